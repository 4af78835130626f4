// SPDX-License-Identifier: MIT
// Makes fields of painted dabs, and of fields that lie over others.
#pragma once

#include "picture/call.h"
#include "picture/handles.h"
#include "picture/style.h"

#include <hrbfnpr.h>

#include <cstdint>
#include <memory>

namespace hrbfnpr::picture {

// A field over another. At a place, the result is below + w (above - below), where w is the weight of `above`.
struct FieldOver {
    base::Memory* memory;
    Field below; // may be null
    Field above;
    bool is_direction; // true if values have three numbers, and each weight of `above` that is not 0 counts as 1
};

// Implements hrbfnpr_field_fn. Its `user` is a FieldOver.
std::int32_t values_over(void* user, std::int64_t count, const double* positions, const double* normals, double* values,
                         double* weights) noexcept;

// A field of a FieldOver, which must stay at its place.
struct HeldField {
    explicit HeldField(FieldOver&& fields) : over(std::move(fields)) {}
    HeldField(const HeldField&) = delete;
    HeldField& operator=(const HeldField&) = delete;

    FieldOver over;
    Field field;
};

// Returns a field of the caller's dabs of one map (HRBFNPR_DAB_*). It is null without such dabs.
[[nodiscard]] Field field_of_dabs(const Call& call, std::uint32_t map);

// Returns painted numbers over other numbers, which may be null.
[[nodiscard]] std::shared_ptr<const HeldField> numbers_over(const Call& call, const Field& below, const Field& above);
// Returns painted directions over other directions, which may be null. The painted ones count fully in the whole dab.
[[nodiscard]] std::shared_ptr<const HeldField> directions_over(const Call& call, const Field& below,
                                                               const Field& above);

// Makes layers of marks use painted densities and directions, and keeps their fields alive.
void set_paint(const Call& call, Marks& marks);

} // namespace hrbfnpr::picture
