// SPDX-License-Identifier: MIT
// A mesh by its edges: which triangle lies across each of them (find_neighbours); triangles cut at places on their
// edges, so that they still meet nowhere but in edges and corners, at the middles of edges that are too long
// (halve_edges) or where a function g on the surface is 0 (clip); and chains of edges that lines cross (walk_chains).
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
// The same edge of the triangle across; -1 at a border.
[[nodiscard]] std::int64_t opposite_of(const SurfaceMesh& mesh, std::int64_t edge) noexcept;
// Whether the edge comes before its opposite one, so that each pair is visited once.
[[nodiscard]] inline bool is_first(const SurfaceMesh& mesh, std::int64_t edge) noexcept {
    return mesh.neighbour[edge] < 0 || mesh.neighbour[edge] > edge / 3;
}

// For oriented triangles, no two of which have an edge in the same direction, as SurfaceMesh::neighbour.
[[nodiscard]] base::Array<std::int32_t> find_neighbours(const base::Work& work, const base::Array<std::int32_t>& corner,
                                                        std::int64_t vertices);

// Halves edges, each told by one of its two sides: brings their middles onto the surface, and cuts the triangles there.
// An edge stays whole if its middle has no place on the surface within `farthest` of its length, or, where the surface
// is smooth, one whose gradient turns away from those at its ends, as across a thin wall. Returns whether any was
// halved.
bool halve_edges(const base::Work& work, const implicit::Implicit& implicit, const base::Array<std::int64_t>& edges,
                 double farthest, bool smooth, SurfaceMesh& mesh);

// ---- The part of a mesh where g is not positive

struct ClippedMesh {
    explicit ClippedMesh(base::Memory& memory) noexcept : mesh(memory), cut(memory) {}

    SurfaceMesh mesh; // vertices from `first_cut` on stand on the curve, with f = g = 0
    std::int64_t first_cut = 0;
    base::Array<CurvePoint> cut; // the curve's points at these vertices
    double left_out = 0.0;       // the share of the area that was cut away
};

// The same bits for any thread count.
[[nodiscard]] ClippedMesh clip(const base::Work& work, const Level& level, const SurfaceMesh& mesh);

// ---- Chains of edges

// Walks along the lines that cross triangles. crossed: two edges of each triangle as bits 1, 2, 4, or 0; it is 0
// afterwards. may_enter(edge) tells whether a walk may come into the triangle of an edge over it. Open chains are the
// edge that the first triangle is entered by and those that each is left by; closed ones only the latter.
template <class MayEnter>
[[nodiscard]] Chains<std::int64_t> walk_chains(const SurfaceMesh& mesh, base::Array<std::uint8_t>& crossed,
                                               MayEnter&& may_enter) {
    HRBFNPR_ASSERT(crossed.size() == mesh.triangles());
    Chains<std::int64_t> chains(crossed.memory());
    base::Array<std::int32_t> found(crossed.memory()); // the triangles that are crossed
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
struct Bead {
    std::int32_t negative, positive; // vertices
    Straddle edge;                   // their positions
    glm::dvec3 place;                // by linear interpolation
    glm::dvec3 way;                  // the direction of its chain there, from the place before to the place after
};

// The beads along each chain of edges, by one value of g for each vertex; 0 counts as positive. Along a chain negative
// g lies to the left, as seen from outside: the direction of grad f x grad g. The same bits for any thread count.
[[nodiscard]] Chains<Bead> find_beads(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                      const base::Array<double>& level);

} // namespace hrbfnpr::curves
