// SPDX-License-Identifier: MIT
// A blue-noise order of points: each prefix of it is evenly spread over the surface.
#pragma once

#include "stipples/candidates.h"
#include "stipples/order_loops.h"

#include <cmath>

namespace hrbfnpr::stipples {

// Distance of neighbours in the densest packing of that many marks.
[[nodiscard]] inline double densest_distance(double area, double marks) noexcept {
    return std::sqrt(2.0 / std::sqrt(3.0) * area / marks);
}

// Relative to the candidates' grid.origin; near the surface.
using OrderedMarks = base::Array<OrderMark>;

// `wanted` marks, or as many as differ.  Each next one is where there is most room: among the candidates that keep
// 0.70 of the densest packing's distance from all before, one at the lowest energy, which is a sum over the marks
// within about two such distances (void and cluster, Ulichney 1993; elimination by weight, Yuksel 2015, does the like
// backwards).  The distance alone (dart throwing) fills some parts of the surface before others; the energy alone lets
// marks touch.  A candidate that is nearly far enough moves to the middle of its gap.  Neighbours whose normals point
// to opposite sides do not see each other: on a thin sheet both faces get their own order.  Works in the candidates
// themselves, which come to stand in another order.
[[nodiscard]] OrderedMarks progressive_order(const marks::Site& site, Candidates& candidates, std::int64_t wanted,
                                             const base::Progress& progress);

} // namespace hrbfnpr::stipples
