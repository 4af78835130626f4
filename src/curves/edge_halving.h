// SPDX-License-Identifier: MIT
// Triangles cut at vertices on their edges, so that they still meet nowhere but in edges and corners.
#pragma once

#include "curves/surface_mesh.h"

namespace hrbfnpr::curves {

[[nodiscard]] inline std::int64_t next_in_triangle(std::int64_t edge) noexcept {
    return edge % 3 == 2 ? edge - 2 : edge + 1;
}
// Edge e leads from corner e % 3 of triangle e / 3 to the next.
[[nodiscard]] inline std::int32_t start_of(const SurfaceMesh& mesh, std::int64_t edge) noexcept {
    return mesh.corner[edge];
}
[[nodiscard]] inline std::int32_t end_of(const SurfaceMesh& mesh, std::int64_t edge) noexcept {
    return mesh.corner[next_in_triangle(edge)];
}
// The same edge of the triangle across; -1: there is none.
[[nodiscard]] std::int64_t opposite_of(const SurfaceMesh& mesh, std::int64_t edge) noexcept;
// Of the two of an edge the one that counts.
[[nodiscard]] inline bool is_first(const SurfaceMesh& mesh, std::int64_t edge) noexcept {
    return mesh.neighbour[edge] < 0 || mesh.neighbour[edge] > edge / 3;
}

// middle: the vertex on each edge, the same one on both sides of it; < 0: none.  Each triangle becomes one to four.
void cut_at_middles(const base::Runtime& runtime, const base::Array<std::int32_t>& middle, SurfaceMesh& mesh);

} // namespace hrbfnpr::curves
