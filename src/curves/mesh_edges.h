// SPDX-License-Identifier: MIT
// Functions for the edges of a mesh. find_neighbours finds the triangle across each edge. halve_edges divides triangles
// at the middles of given edges. clip cuts triangles where a function g on the surface is 0. In the results, triangles
// still meet only in edges and corners. walk_chains finds the chains of edges that lines on the mesh cross.
#pragma once

#include "base/operation.h"
#include "curves/curves.h"

#include <cstring>

namespace hrbfnpr::curves {

// ---- Half-edges: half-edge e leads from corner e % 3 of triangle e / 3 to the next corner.
// Arguments named `edge` are indices of half-edges.

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
// Returns the other half-edge of the same edge, which is in the adjacent triangle, or -1 at a border.
[[nodiscard]] std::int64_t opposite_of(const SurfaceMesh& mesh, std::int64_t edge) noexcept;
// Returns whether this half-edge is in the triangle with the lower index, or at a border. This is true for one
// half-edge of each edge, so it is used to visit each edge once.
[[nodiscard]] inline bool is_first(const SurfaceMesh& mesh, std::int64_t edge) noexcept {
    return mesh.neighbour[edge] < 0 || mesh.neighbour[edge] > edge / 3;
}

// Computes SurfaceMesh::neighbour. The triangles must be oriented: no two triangles may contain the same half-edge,
// with the same start and end.
[[nodiscard]] base::Array<std::int32_t> find_neighbours(const base::Work& work, const base::Array<std::int32_t>& corner,
                                                        std::int64_t vertices);

// Divides triangles at the middles of the given edges, and moves the middles onto the surface. Each edge is given by
// one of its two half-edges. An edge is not divided if its middle would move farther than `farthest` times its length.
// With `smooth`, it is also not divided if the gradient at the middle is opposite to those at its ends, as happens
// across a thin wall. Returns whether any edge was divided.
bool halve_edges(const base::Work& work, const implicit::Implicit& implicit, const base::Array<std::int64_t>& edges,
                 double farthest, bool smooth, SurfaceMesh& mesh);

// ---- The part of a mesh where g is not positive

struct ClippedMesh {
    explicit ClippedMesh(base::Memory& memory) noexcept : mesh(memory), cut(memory) {}

    SurfaceMesh mesh; // Vertices from `first_cut` on are on the curve f = g = 0.
    std::int64_t first_cut = 0;
    base::Array<CurvePoint> cut; // for each vertex from `first_cut` on: its point on the curve
    double left_out = 0.0;       // the share of the area that was removed
};

// Cuts the mesh where g is 0. The result has the same bits for any number of threads.
[[nodiscard]] ClippedMesh clip(const base::Work& work, const Level& level, const SurfaceMesh& mesh);

// ---- Chains of edges

// Follows lines across triangles, and returns the chains of half-edges that they cross. crossed[t] has the bits 1, 2
// and 4 for the edges of triangle t: two bits are set if a line crosses the triangle, else none. At the end, all
// elements are 0. may_enter(edge) returns whether a walk may enter a triangle through this half-edge of it. A chain
// contains, for each triangle, the half-edge through which the walk leaves it. An open chain begins with the half-edge
// through which the walk enters the first triangle.
template <class MayEnter>
[[nodiscard]] Chains<std::int64_t> walk_chains(const SurfaceMesh& mesh, base::Array<std::uint8_t>& crossed,
                                               MayEnter&& may_enter) {
    HRBFNPR_ASSERT(crossed.size() == mesh.triangles());
    Chains<std::int64_t> chains(crossed.memory());
    base::Array<std::int32_t> found(crossed.memory()); // the triangles that are crossed
    for (std::int64_t t = 0; t < crossed.size(); ++t) {
        std::uint64_t eight = 1;
        if (t + 8 <= crossed.size()) std::memcpy(&eight, crossed.data() + t, sizeof eight);
        if (eight == 0) // Most groups of eight triangles are not crossed, and are skipped together.
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

// A crossing: a place on an edge of the mesh where g changes its sign.
struct EdgeCrossing {
    std::int32_t negative, positive; // the indices of the edge's two vertices
    Bracket edge;                    // the positions of the two vertices
    glm::dvec3 place;                // the place of the crossing, by linear interpolation
    glm::dvec3 way;                  // the direction of the chain, from the previous crossing to the next one
};

// Finds the crossings along each chain of edges, from the values of g at the vertices. The value 0 counts as positive.
// As seen from outside, negative g is to the left of a chain, so chains run in the direction of grad f x grad g. The
// result has the same bits for any number of threads.
[[nodiscard]] Chains<EdgeCrossing> find_edge_crossings(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                                       const base::Array<double>& level);

} // namespace hrbfnpr::curves
