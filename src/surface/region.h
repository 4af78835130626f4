// SPDX-License-Identifier: MIT
// The region in which the surface of an implicit is searched for, how steep f is there, and which points are inside.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::surface {

// The region is the bounds grown on every side by this share of the diagonal, since samples do not reach the extremes
// of the surface through them. Beyond the region the surface counts as absent, whatever f is.
inline constexpr double region_margin = 0.05;
[[nodiscard]] geometry::Bounds search_region(const implicit::Implicit& implicit) noexcept;

// Returns the implicit's own bound on |grad f| if it has one. Otherwise it estimates f's Lipschitz constant in the
// region, without proof: 1.5 times the largest |grad f| of a grid of 24^3 points. The result is positive, and has the
// same bits for any number of threads.
[[nodiscard]] double lipschitz_estimate(const base::Work& work, const implicit::Implicit& implicit);

// Sets inside[i] to 1 where a point is in the region and f < 0, else to 0, and resizes `inside`. f is evaluated in the
// region only.
void contains(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& points,
              base::Array<std::uint8_t>& inside);

} // namespace hrbfnpr::surface
