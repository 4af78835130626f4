// SPDX-License-Identifier: MIT
// What a mesh is like as it was given, and what is wrong with it: parts, borders, edges, orientation.
#pragma once

#include "picture/shape.h"

namespace hrbfnpr::picture {

// Counted after vertices at the same place are joined; nothing else is repaired, unlike in hrbfnpr_mesh_info.
struct MeshFacts {
    std::int64_t components = 0;            // parts that share no vertex
    std::int64_t components_inside_out = 0; // parts without border whose faces look inward
    std::int64_t boundary_edges = 0;        // of one face
    std::int64_t boundary_loops = 0;        // lines that those make
    std::int64_t nonmanifold_edges = 0;     // of more than two faces
    std::int64_t contrary_edges = 0;        // of two faces that run along it in the same direction
    std::int64_t faces_not_finite = 0;      // with a corner that is not finite; no other number counts these
    std::int64_t degenerate_faces = 0;      // without area
    std::int64_t repeated_faces = 0;        // with the corners of another
    std::int64_t unused_vertices = 0;       // of no face
    std::int64_t joined_vertices = 0;       // at the place of another
    bool closed = false;                    // each edge has two faces, in opposite directions
    bool inside_out = false;                // it is closed, and its faces look inward
    double area = 0.0;
    double volume = 0.0; // of a closed mesh
};

[[nodiscard]] MeshFacts mesh_facts_of(const Shape& shape, Pool& pool);

} // namespace hrbfnpr::picture
