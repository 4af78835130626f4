// SPDX-License-Identifier: MIT
// Triangles cut at places on their edges, so that they still meet nowhere but in edges and corners: where a function g
// on the surface is 0, or at the middles of edges that are too long.
#pragma once

#include "curves/curves.h"

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

// Cuts each triangle into one to four. middle[e] is the vertex on edge e, the same one on both sides of it; < 0: none.
void cut_at_middles(const base::Runtime& runtime, const base::Array<std::int32_t>& middle, SurfaceMesh& mesh);

// ---- The part of a mesh where g is not positive

struct ClippedMesh {
    explicit ClippedMesh(base::Memory& memory) noexcept : mesh(memory), cut(memory) {}

    SurfaceMesh mesh; // vertices from `first_cut` on stand on the curve, with f = g = 0
    std::int64_t first_cut = 0;
    base::Array<CurvePoint> cut; // the curve's points at these vertices
    double left_out = 0.0;       // the share of the area that was cut away
};

// The same bits for any thread count.
[[nodiscard]] ClippedMesh clip(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                               const base::Progress& progress);

} // namespace hrbfnpr::curves
