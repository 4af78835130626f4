// SPDX-License-Identifier: MIT
// Edges and corners in which solids touch each other.
#pragma once

#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

// Where an edge has two faces or more in either sense, those that have the solid between them get an edge of their own,
// by vertices at the same places, so that each solid is closed.  Solids that share a vertex and no edge get vertices of
// their own, where no border passes: they are parts, and whether one lies against another is asked of parts.  Returns
// the number of vertices that were added.
std::int64_t part_edges(const base::Runtime& runtime, base::Array<glm::dvec3>& vertex, base::Array<Triangle>& triangle,
                        const base::Progress& progress);

} // namespace hrbfnpr::mesh
