// SPDX-License-Identifier: MIT
// Finds samples that others of the same sheet surround on all sides. The surface does not end there.
#pragma once

#include "geometry/vec_array.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::surface {

// Tells whether the neighbours of sample i surround it. `neighbours` are nearest first, without the sample itself.
// Among the first twelve, those that face the same way must leave no gap of 120 degrees or more about the sample's
// normal (unit). At a straight border the gap is 180 degrees.
[[nodiscard]] bool is_surrounded(const geometry::VecArray& position, const geometry::VecArray& normal,
                                 std::span<const std::int64_t> neighbours, std::int64_t i) noexcept;

} // namespace hrbfnpr::surface
