// SPDX-License-Identifier: MIT
// What a drawing is written as for a graphics card.
#pragma once

#include <cstdint>

namespace hrbfnpr::output {

// Same numbers as HRBFNPR_PRIMITIVE_...
enum class Primitive : std::uint32_t { points = 1, line_strips = 2, triangle_strips = 3 };
// Ends a strip.
inline constexpr std::uint32_t index_restart = 0xFFFFFFFFU;

} // namespace hrbfnpr::output
