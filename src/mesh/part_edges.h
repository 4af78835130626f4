// SPDX-License-Identifier: MIT
// Edges in which solids touch each other.
#pragma once

#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

// Where an edge has two faces or more in either sense, those that have the solid between them get an edge of their own,
// by vertices at the same places, so that each solid is closed.  Returns the number of vertices that were added.
std::int64_t part_edges(const base::Runtime& runtime, base::Array<glm::dvec3>& vertex, base::Array<Triangle>& triangle,
                        const base::Progress& progress);

} // namespace hrbfnpr::mesh
