// SPDX-License-Identifier: MIT
// A triangulation of f = 0: where curves on the surface are looked for, and what rays are counted against.
// By marching tetrahedra over the cells that a flood from seeds reaches.  [Doi & Koide 1991]  Vertices stand on edges
// of the tetrahedra, so that triangles meet nowhere but in their edges and corners.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

#include <cstdint>

namespace hrbfnpr::curves {

class SurfaceEnd;

struct MeshSettings {
    geometry::Bounds region; // beyond it there is no surface: the mesh ends there, and f is not asked for but at seeds
    double side = 0.0;       // of a cell at most, > 0: what is thinner or smaller may be missed
    std::int64_t triangle_limit = 4'000'000;
    // Where this says that the surface is nowhere near the mesh need not go on: at least some cells beyond its end.
    const implicit::Extent* extent = nullptr;
    double tolerance = 1e-9; // of vertices, in diagonals
};

// Oriented, and closed but where the region ends.
struct SurfaceMesh {
    explicit SurfaceMesh(base::Memory& memory) noexcept
        : position(memory), gradient(memory), corner(memory), neighbour(memory) {}

    geometry::VecArray position;      // of the vertices, on the surface to the tolerance; else `unresolved` counts them
    geometry::VecArray gradient;      // of f there
    base::Array<std::int32_t> corner; // 3 of each triangle, counter-clockwise as seen from where f > 0
    base::Array<std::int32_t> neighbour; // 3 of each triangle: the one across the edge from corner k to k + 1; -1: none
    geometry::Bounds region;
    const SurfaceEnd* end = nullptr; // where the surface ends within the region, if it does
    double side = 0.0;               // of the cells: the longest
    std::int64_t unresolved = 0;     // vertices that the search did not bring onto the surface, or whose gradient is 0
    // Seeds on the surface, or less than a side from it, with no triangle that faces their way within 1.5 sides: a part
    // of the surface there is too thin or too small for the cells.
    std::int64_t missed_seeds = 0;
    // Triangles that look away from the gradient at one of their corners: the surface is finer than the cells there, as
    // where a wall is thinner than a cell's diagonal.
    std::int64_t turned = 0;

    [[nodiscard]] std::int64_t vertices() const noexcept { return position.size(); }
    [[nodiscard]] std::int64_t triangles() const noexcept { return corner.size() / 3; }
    [[nodiscard]] std::int64_t bytes() const noexcept;
};

// Whether it looks away from the gradient at one of its corners.
[[nodiscard]] bool is_turned(const SurfaceMesh& mesh, std::int64_t triangle) noexcept;

// Seeds are points on or near the surface; parts of it that no seed belongs to are not reached.
// The same bits for any thread count.  Throws Error{out_of_memory, cancelled, callback}, and Error{invalid_argument}
// where the mesh would pass triangle_limit.
[[nodiscard]] SurfaceMesh triangulate(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                      const geometry::VecArray& seeds, const MeshSettings& settings,
                                      const base::Progress& progress);

// With cells twice as wide, and again, where there would be too many triangles; settings.side: what it came to.
[[nodiscard]] SurfaceMesh triangulate_of_any_size(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                                  const geometry::VecArray& seeds, MeshSettings& settings,
                                                  const base::Progress& progress);

} // namespace hrbfnpr::curves
