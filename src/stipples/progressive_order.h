// SPDX-License-Identifier: MIT
// Candidates in the order in which they become marks: every prefix of it is as even as can be.
//
// Each next mark is where there is most room: among the candidates that keep 0.70 of the densest packing's distance
// from all before, one at the lowest energy, which is a sum over the marks within about two such distances (void and
// cluster, Ulichney 1993; elimination by weight, Yuksel 2015, does the like backwards). The distance alone (dart
// throwing) fills some parts of the surface before others; the energy alone lets marks touch. A candidate that is
// nearly far enough moves to the middle of its gap. Neighbours whose normals point to opposite sides do not see each
// other: on a thin sheet both faces get their own order.
//
// 1. Stages have cells of twice the width of the next one's, and fill four times fewer marks. A stage takes its
//    candidates and the marks of the stages before it into its cells.
// 2. It is filled in sweeps over tiles of cells, at rising thresholds of energy. In a tile the cell with the lowest
//    energy gives its best candidate, or the middle of the gap beside it; the cells around feel the new mark.
// 3. The marks of a sweep's step are shuffled, so that each prefix is spread like the whole.
#pragma once

#include "stipples/candidates.h"

#include <cmath>
#include <span>

namespace hrbfnpr::stipples {

// Distance of neighbours in the densest packing of that many marks.
[[nodiscard]] inline double densest_distance(double area, double marks) noexcept {
    return std::sqrt(2.0 / std::sqrt(3.0) * area / marks);
}

// The way from 0 to the middle of the gap between the points around it, in a plane: uphill on the distance to the
// nearest of them, first away from the nearest point, then between the two nearest, from one Voronoi vertex to the
// next. It ends where that distance is `wanted`, or at a maximum of it; it is 0 if it would lead beyond `farthest`.
[[nodiscard]] glm::dvec2 toward_void(std::span<const glm::dvec2> around, double wanted, double farthest) noexcept;

// Relative to the candidates' grid.origin; near the surface.
using OrderedMarks = base::Array<OrderMark>;

// Orders `wanted` marks, or as many as differ. Works in the candidates themselves, which come to stand in another
// order.
[[nodiscard]] OrderedMarks progressive_order(const marks::Site& site, Candidates& candidates, std::int64_t wanted,
                                             const base::Progress& progress);

} // namespace hrbfnpr::stipples
