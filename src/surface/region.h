// SPDX-License-Identifier: MIT
// Where the surface of an implicit is looked for, how steep f is there, and which points lie inside.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::surface {

// The bounds grown on every side by this share of the diagonal: samples do not reach the extremes
// of the surface that goes through them.  Beyond it there is no surface, whatever f is.
inline constexpr double region_margin = 0.05;
[[nodiscard]] geometry::Bounds search_region(const implicit::Implicit& implicit) noexcept;

// The largest |grad f| of a grid of 24^3 points over the region, times 1.5: an estimate of f's
// Lipschitz constant there, and no proof; or a bound that the implicit knows.  Positive; the same bits for any thread
// count.
[[nodiscard]] double lipschitz_estimate(const base::Work& work, const implicit::Implicit& implicit);

// 1 where a point lies in the region and f < 0, else 0; inside is resized.  f is evaluated in the region only.
void contains(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& points,
              base::Array<std::uint8_t>& inside);

} // namespace hrbfnpr::surface
