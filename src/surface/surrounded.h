// SPDX-License-Identifier: MIT
// Finds samples that other samples of the same sheet surround on all sides. The surface does not end at them.
#pragma once

#include "geometry/vec_array.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::surface {

// Returns whether the neighbours of sample i surround it. `neighbours` are sorted, the nearest first, without the
// sample itself. Only those of the first twelve whose normals point the same way are used. Seen along the unit normal
// of the sample, they must leave no gap of 120 degrees or more. At a straight border the gap is 180 degrees.
[[nodiscard]] bool is_surrounded(const geometry::VecArray& position, const geometry::VecArray& normal,
                                 std::span<const std::int64_t> neighbours, std::int64_t i) noexcept;

} // namespace hrbfnpr::surface
