// SPDX-License-Identifier: MIT
// Finds the tangent edges of a mesh: edges along which two surfaces of a part touch without a kink, but bend
// differently, as a fillet and the plane beside it do.
//
// Along a line of constant curvature that is divided into chords, the bend between two chords is half of their lengths
// times the curvature. So the bend at an edge follows from the widths and the curvatures of the two faces beside it.
// An edge is tangent if its bend is as expected for two different curvatures. If the curvatures were equal the bend
// would be larger or smaller, and at a kink it is larger. A mesh of a scan fits neither.
#pragma once

#include "mesh/edges.h"

namespace hrbfnpr::mesh {

// Returns both sides 3 face + k of each tangent edge, in ascending order. `cut` is Creases::cut: no surface continues
// across these sides.
[[nodiscard]] base::Array<std::int64_t> find_tangent_edges(const base::Work& work, const Mesh& mesh,
                                                           const base::Array<std::uint8_t>& cut);

} // namespace hrbfnpr::mesh
