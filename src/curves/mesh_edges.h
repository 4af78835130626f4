// SPDX-License-Identifier: MIT
// Functions for the edges of a mesh: find_neighbours finds the triangle across each edge. halve_edges cuts triangles at
// the middles of edges that are too long, and clip where a function g on the surface is 0; the triangles still meet
// only in edges and corners. walk_chains finds chains of edges that a line crosses.
#pragma once

#include "base/operation.h"
#include "curves/curves.h"

#include <cstring>

namespace hrbfnpr::curves {

// ---- Edges: edge e leads from corner e % 3 of triangle e / 3 to the next corner.

[[nodiscard]] inline std::int64_t next_in_triangle(std::int64_t edge) noexcept {
    return edge % 3 == 2 ? edge - 2 : edge + 1;
}
[[nodiscard]] inline std::int32_t start_of(const SurfaceMesh& mesh, std::int64_t edge) noexcept {
    HRBFNPR_ASSERT(edge >= 0 && edge < mesh.corner.size());
    return mesh.corner[edge];
}
[[nodiscard]] inline std::int32_t end_of(const SurfaceMesh& mesh, std::int64_t edge) noexcept {
    return start_of(mesh, next_in_triangle(edge));
}
// The same edge as seen from the adjacent triangle; -1 at a border.
[[nodiscard]] std::int64_t opposite_of(const SurfaceMesh& mesh, std::int64_t edge) noexcept;
// Whether this edge comes before its opposite edge; used to visit each pair once.
[[nodiscard]] inline bool is_first(const SurfaceMesh& mesh, std::int64_t edge) noexcept {
    return mesh.neighbour[edge] < 0 || mesh.neighbour[edge] > edge / 3;
}

// Computes SurfaceMesh::neighbour for oriented triangles, no two of which have an edge in the same direction.
[[nodiscard]] base::Array<std::int32_t> find_neighbours(const base::Work& work, const base::Array<std::int32_t>& corner,
                                                        std::int64_t vertices);

// Cuts triangles at the middles of the given edges, and brings the middles onto the surface; of each edge one of its
// two sides is given. An edge stays whole if its middle moves farther than `farthest` of the edge's length. If `smooth`
// is set, it also stays whole if the gradient at the middle points away from those at its ends, which happens across a
// thin wall. Returns whether any edge was halved.
bool halve_edges(const base::Work& work, const implicit::Implicit& implicit, const base::Array<std::int64_t>& edges,
                 double farthest, bool smooth, SurfaceMesh& mesh);

// ---- The part of a mesh where g is not positive

struct ClippedMesh {
    explicit ClippedMesh(base::Memory& memory) noexcept : mesh(memory), cut(memory) {}

    SurfaceMesh mesh; // vertices from `first_cut` on lie on the curve f = g = 0
    std::int64_t first_cut = 0;
    base::Array<CurvePoint> cut; // the curve's point at each vertex from `first_cut` on
    double left_out = 0.0;       // the share of the area that was removed
};

// Gives the same bits for any thread count.
[[nodiscard]] ClippedMesh clip(const base::Work& work, const Level& level, const SurfaceMesh& mesh);

// ---- Chains of edges

// Follows the lines that cross triangles, as chains of edges. crossed: two edges of each triangle as bits 1, 2, 4, or
// 0; it is 0 afterwards. may_enter(edge) tells whether a walk may enter the edge's triangle over this edge. A chain has
// the edge over which each of its triangles is left; an open one also starts with the edge over which the first
// triangle is entered.
template <class MayEnter>
[[nodiscard]] Chains<std::int64_t> walk_chains(const SurfaceMesh& mesh, base::Array<std::uint8_t>& crossed,
                                               MayEnter&& may_enter) {
    HRBFNPR_ASSERT(crossed.size() == mesh.triangles());
    Chains<std::int64_t> chains(crossed.memory());
    base::Array<std::int32_t> found(crossed.memory()); // the crossed triangles
    for (std::int64_t t = 0; t < crossed.size(); ++t) {
        std::uint64_t eight = 1;
        if (t + 8 <= crossed.size()) std::memcpy(&eight, crossed.data() + t, sizeof eight);
        if (eight == 0) // few triangles are crossed
            t += 7;
        else if (crossed[t] != 0)
            found.push_back(static_cast<std::int32_t>(t));
    }
    const auto has = [&](std::int64_t edge) { return ((crossed[edge / 3] >> (edge % 3)) & 1) != 0; };
    const auto walk = [&](std::int64_t edge) {
        while (edge >= 0 && crossed[edge / 3] != 0) {
            std::int64_t exit = next_in_triangle(edge);
            if (!has(exit)) exit = next_in_triangle(exit);
            HRBFNPR_ASSERT(exit != edge && has(exit));
            crossed[edge / 3] = 0;
            chains.point.push_back(exit);
            edge = opposite_of(mesh, exit);
        }
    };
    for (const bool closed : {false, true})
        for (const std::int32_t t : found)
            for (std::int64_t edge = 3 * t; edge < 3 * t + 3; ++edge) {
                if (!has(edge) || !may_enter(edge)) continue;
                const std::int64_t before = mesh.neighbour[edge];
                if (!closed && before >= 0 && crossed[before] != 0) continue;
                if (!closed) chains.point.push_back(edge);
                walk(edge);
                chains.end(closed);
            }
    return chains;
}

// A place on an edge of the mesh where g changes its sign.
struct EdgeCrossing {
    std::int32_t negative, positive; // vertices
    Bracket edge;                    // their positions
    glm::dvec3 place;                // by linear interpolation
    glm::dvec3 way;                  // the chain's direction, from the previous place to the next one
};

// Finds the crossings along each chain of edges from the values of g at the vertices; 0 counts as positive. Negative g
// lies to the left of a chain as seen from outside: chains run in the direction of grad f x grad g. The same bits for
// any thread count.
[[nodiscard]] Chains<EdgeCrossing> find_edge_crossings(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                                       const base::Array<double>& level);

} // namespace hrbfnpr::curves
