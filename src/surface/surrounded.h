// SPDX-License-Identifier: MIT
// Samples that others of the same sheet stand around on all sides: no surface ends there.
#pragma once

#include "geometry/vec_array.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::surface {

// neighbours: of sample i, nearest first, without itself; the first twelve are looked at, of these those that face
// the same way, and whether they leave no gap of 120 degrees or more about its normal (unit).  At a straight border it
// is 180 degrees.
[[nodiscard]] bool is_surrounded(const geometry::VecArray& position, const geometry::VecArray& normal,
                                 std::span<const std::int64_t> neighbours, std::int64_t i) noexcept;

} // namespace hrbfnpr::surface
