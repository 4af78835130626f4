// SPDX-License-Identifier: MIT
// Loops of g = 0 that pass between the vertices of the mesh: each goes round an extremum of g, beside a vertex where
// |g| is least among its neighbours.
#pragma once

#include "curves/level_roots.h"

namespace hrbfnpr::curves {

// Looks for the extremum beside each such vertex, and gives a place on either side of the loop where g has changed its
// sign there.  Adds up evaluations.
[[nodiscard]] base::Array<Straddle> find_small_loops(const base::Runtime& runtime, const Level& level,
                                                     const SurfaceMesh& mesh, const base::Array<double>& at_vertices,
                                                     std::int64_t& evaluations, const base::Progress& progress);

} // namespace hrbfnpr::curves
