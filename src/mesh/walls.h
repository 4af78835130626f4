// SPDX-License-Identifier: MIT
// Walls within solids: faces that two of them share, as boxes beside each other do.
#pragma once

#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

// 1 for each face that is a wall.  twin: of each face 1 where it stands for as many of one sense as of the other.  What
// hangs together of these is a wall where it ends at other faces on both sides, and nowhere else: a leaf of two sides
// ends at nothing, and a solid with two sides nowhere.
[[nodiscard]] base::Array<std::uint8_t> find_walls(const base::Runtime& runtime, const base::Array<Triangle>& triangle,
                                                   const base::Array<std::uint8_t>& twin,
                                                   const base::Progress& progress);

} // namespace hrbfnpr::mesh
