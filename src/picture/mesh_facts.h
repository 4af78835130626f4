// SPDX-License-Identifier: MIT
// Describes a mesh before repairs, and its defects: parts, borders, edges, orientation.
#pragma once

#include "picture/shape.h"

namespace hrbfnpr::picture {

// Facts about a mesh after joining vertices at the same place. The mesh that hrbfnpr_mesh_info describes is also
// repaired in other ways.
struct MeshFacts {
    std::int64_t components = 0;            // parts that share no vertex
    std::int64_t components_inside_out = 0; // parts without border whose faces point inward
    std::int64_t boundary_edges = 0;        // edges with one face
    std::int64_t boundary_loops = 0;        // closed lines of border edges
    std::int64_t nonmanifold_edges = 0;     // edges with more than two faces
    std::int64_t contrary_edges = 0;        // edges that both of their faces use in the same direction
    std::int64_t faces_not_finite = 0;      // faces with a coordinate that is not finite; no other count has them
    std::int64_t degenerate_faces = 0;      // faces without area
    std::int64_t repeated_faces = 0;        // faces with the same corners as another face
    std::int64_t unused_vertices = 0;       // vertices that no face uses
    std::int64_t joined_vertices = 0;       // vertices at the place of another vertex
    bool closed = false;                    // Each edge has exactly two faces, which use it in opposite directions.
    bool inside_out = false;                // The mesh is closed, and its faces point inward.
    double area = 0.0;
    double volume = 0.0; // 0 if the mesh is not closed
};

[[nodiscard]] MeshFacts mesh_facts_of(const Shape& shape, Pool& pool);

} // namespace hrbfnpr::picture
