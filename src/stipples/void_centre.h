// SPDX-License-Identifier: MIT
// The way from a point to the middle of the gap between the points around it, in a plane.
#pragma once

#include "geometry/vec.h"

#include <span>

namespace hrbfnpr::stipples {

// From 0 uphill on the distance to the nearest of `around`: first away from the nearest point, then between the
// two nearest, from one Voronoi vertex to the next.  Ends where that distance is `wanted`, or at a maximum of it.
// 0 if the way leads beyond `farthest`.
[[nodiscard]] glm::dvec2 toward_void(std::span<const glm::dvec2> around, double wanted, double farthest) noexcept;

} // namespace hrbfnpr::stipples
