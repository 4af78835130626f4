// SPDX-License-Identifier: MIT
// The region in which the surface is searched for, a bound on |grad f| in it, and the test of whether points are inside
// the solid.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::surface {

// The region is the bounds, enlarged on each side by this share of the diagonal. The margin is needed because the
// surface may extend beyond its samples. Outside the region there is no surface, whatever f is.
inline constexpr double region_margin = 0.05;
[[nodiscard]] geometry::Bounds search_region(const implicit::Implicit& implicit) noexcept;

// Returns the implicit function's bound on |grad f| if it has one. Otherwise it returns an estimate without guarantee
// of f's Lipschitz constant in the region: 1.5 times the largest |grad f| at the points of a 24^3 grid. The result is
// positive, and has the same bits for any number of threads.
[[nodiscard]] double lipschitz_estimate(const base::Work& work, const implicit::Implicit& implicit);

// Sets inside[i] to 1 if point i is in the region and f < 0 there, else to 0. Resizes `inside`. f is evaluated only in
// the region.
void contains(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& points,
              base::Array<std::uint8_t>& inside);

} // namespace hrbfnpr::surface
