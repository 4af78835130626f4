// SPDX-License-Identifier: MIT
// Changes of sign that a mesh sees, as places where curves are started.
#pragma once

#include "curves/level_roots.h"
#include "curves/mesh_chains.h"

namespace hrbfnpr::curves {

// A change of sign on an edge of the mesh, and which way its chain runs there.
struct Bead {
    glm::dvec3 place;
    glm::dvec3 way;
    Straddle edge;
};

// One of each crossing, in their order.
[[nodiscard]] base::Array<Bead> beads_of(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                         const MeshChains& chains);

} // namespace hrbfnpr::curves
