// SPDX-License-Identifier: MIT
// The kinds of values that a field has. A field gives each place of a surface a value and a weight.
#pragma once

#include <cstdint>

namespace hrbfnpr::paint {

// The values equal those of the constants HRBFNPR_FIELD_KIND. A colour is r, g, b. A direction is x, y, z; its sign has
// no meaning.
enum class FieldKind : std::uint32_t { scalar = 0, colour = 1, direction = 2 };
inline constexpr std::uint32_t field_kind_count = 3;

// Returns how many numbers a value has.
[[nodiscard]] constexpr int components_of(FieldKind kind) noexcept { return kind == FieldKind::scalar ? 1 : 3; }

} // namespace hrbfnpr::paint
