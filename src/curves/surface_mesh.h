// SPDX-License-Identifier: MIT
// A triangulation of f = 0: where curves on the surface are looked for, and what rays are counted against.
#pragma once

#include "base/assert.h"
#include "base/memory.h"
#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::curves {

struct MeshSettings {
    geometry::Bounds region; // the mesh ends where this ends, and beyond it f is evaluated at seeds only
    double side = 0.0;       // the most that a cell's side may be, > 0: parts that are thinner or smaller may be missed
    std::int64_t triangle_limit = 4'000'000;
    // The mesh need not go on where this says that the surface is nowhere near; it goes on for some cells at least.
    const implicit::Domain* domain = nullptr;
    double tolerance = 1e-9; // how far vertices may be off the surface, in diagonals
};

// It is oriented, and closed but where the region ends.
struct SurfaceMesh {
    explicit SurfaceMesh(base::Memory& memory) noexcept
        : position(memory), gradient(memory), corner(memory), neighbour(memory) {}

    geometry::VecArray position;         // the vertices; all but `unresolved` of them are on the surface
    geometry::VecArray gradient;         // grad f at each vertex
    base::Array<std::int32_t> corner;    // 3 of each triangle, counter-clockwise as seen from where f > 0
    base::Array<std::int32_t> neighbour; // 3 of each triangle: the one across the edge from corner k to k + 1; -1: none
    geometry::Bounds region;
    const implicit::Domain* domain = nullptr; // where the surface is within the region; null: all of it
    double side = 0.0;                        // the longest side of the cells
    std::int64_t unresolved = 0; // vertices that the search did not bring onto the surface, or whose gradient is 0
    // Seeds on the surface, or less than a side from it, with no vertex near whose gradient points their way: a part of
    // the surface there is too thin or too small for the cells.
    std::int64_t missed_seeds = 0;
    // Triangles that look away from the gradient at one of their corners: the surface is finer than the cells there, as
    // where a wall is thinner than a cell's diagonal.
    std::int64_t turned = 0;

    [[nodiscard]] std::int64_t vertices() const noexcept { return position.size(); }
    [[nodiscard]] std::int64_t triangles() const noexcept { return corner.size() / 3; }
    [[nodiscard]] std::int64_t bytes() const noexcept;
};

[[nodiscard]] inline std::array<glm::dvec3, 3> corners_of(const SurfaceMesh& mesh, std::int64_t triangle) noexcept {
    HRBFNPR_ASSERT(triangle >= 0 && triangle < mesh.triangles());
    const std::int32_t* const corner = mesh.corner.data() + 3 * triangle;
    return {mesh.position[corner[0]], mesh.position[corner[1]], mesh.position[corner[2]]};
}

// Whether the triangle looks away from the gradient at one of its corners.
[[nodiscard]] bool is_turned(const SurfaceMesh& mesh, std::int64_t triangle) noexcept;

// Seeds are points on or near the surface; parts of it that no seed belongs to are not reached.
// The same bits for any thread count.  Throws Error{out_of_memory, cancelled, callback}, and Error{invalid_argument}
// where the mesh would pass triangle_limit.
[[nodiscard]] SurfaceMesh triangulate(const base::Work& work, const implicit::Implicit& implicit,
                                      const geometry::VecArray& seeds, const MeshSettings& settings);

// The same with cells twice as wide, and again, while there would be too many triangles. It changes settings.side.
[[nodiscard]] SurfaceMesh triangulate_of_any_size(const base::Work& work, const implicit::Implicit& implicit,
                                                  const geometry::VecArray& seeds, MeshSettings& settings);

} // namespace hrbfnpr::curves
