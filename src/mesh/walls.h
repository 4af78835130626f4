// SPDX-License-Identifier: MIT
// Walls within solids: faces that two of them share, as boxes beside each other do.
#pragma once

#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

enum class Twin : std::uint8_t {
    none = 0, // a face of one side, or of a leaf
    wall = 1,
    contact = 2 // of solids that touch in more than this
};

// twin: of each face 1 where it stands for as many of one sense as of the other.  What hangs together of these is a
// wall where it ends at other faces on both sides, and nowhere else: a leaf of two sides ends at nothing, and a solid
// with two sides nowhere.  It is a part of a contact where those other faces lie on each other, too, in triangles of
// their own.
[[nodiscard]] base::Array<Twin> find_walls(const base::Runtime& runtime, const base::Array<glm::dvec3>& vertex,
                                           const base::Array<Triangle>& triangle, const base::Array<std::uint8_t>& twin,
                                           const base::Progress& progress);

} // namespace hrbfnpr::mesh
