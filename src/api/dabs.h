// SPDX-License-Identifier: MIT
// The dabs of a brush, as the caller gives them.
#pragma once

#include "api/descriptor.h"
#include "api/fields.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

inline constexpr std::int64_t most_dabs = 1'000'000;

[[nodiscard]] constexpr auto dab_fields() noexcept {
    using Dab = hrbfnpr_dab;
    constexpr rule::Between any_number{-1e300, 1e300};
    return FieldTable{field("map", &Dab::map, rule::OneOf{HRBFNPR_DAB_DIRECTION, "HRBFNPR_DAB_*"}),
                      field("position", &Dab::position, rule::IndexedNumbers{any_number}),
                      field("normal", &Dab::normal, rule::IndexedNumbers{any_number}),
                      field("radius", &Dab::radius, rule::Positive{}),
                      field("strength", &Dab::strength, rule::Between{0.0, 1.0}),
                      field("value", &Dab::value, any_number),
                      field("direction", &Dab::direction, rule::IndexedNumbers{any_number})};
}
static_assert(dab_fields().covers<hrbfnpr_dab>());

template <>
hrbfnpr_dab defaults() noexcept;

} // namespace hrbfnpr::api
