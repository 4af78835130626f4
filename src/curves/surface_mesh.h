// SPDX-License-Identifier: MIT
// A triangulation of f = 0. Curves are found on it, and rays are tested against it.
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
    geometry::Bounds region; // The mesh ends at the walls of this box. Outside, f is evaluated only at seeds.
    double side = 0.0; // The largest side of a cell, above 0. Thinner or smaller parts of the surface may be missed.
    std::int64_t triangle_limit = 4'000'000;
    // The mesh may end where the domain says that no surface is near. It continues for at least a few cells beyond the
    // end of the surface.
    const implicit::Domain* domain = nullptr;
    std::int64_t block_side = 8; // The domain is asked about blocks of cells. This is the side of a block, in cells.
    double tolerance = 1e-9;     // the largest distance of vertices from the surface, in diagonals
};

// An oriented triangle mesh of the surface. It is closed, except where the region ends.
struct SurfaceMesh {
    explicit SurfaceMesh(base::Memory& memory) noexcept
        : position(memory), gradient(memory), corner(memory), neighbour(memory) {}

    geometry::VecArray position; // the vertices; all of them except `unresolved` ones are on the surface
    geometry::VecArray gradient; // grad f at each vertex
    // The indices of the three vertices of each triangle, counter-clockwise as seen from where f > 0.
    base::Array<std::int32_t> corner;
    // For each triangle, three indices of triangles: element k is the triangle across the edge from corner k to corner
    // k + 1, or -1 at a border.
    base::Array<std::int32_t> neighbour;
    geometry::Bounds region;
    const implicit::Domain* domain = nullptr; // the part of the region in which the surface exists; null: everywhere
    double side = 0.0;                        // the longest side of a cell
    std::int64_t unresolved = 0; // the number of vertices that are not on the surface, or whose gradient is 0
    // The number of seeds without a part of the mesh near them. Such a seed is at most a side away from the surface,
    // but near it there is no vertex whose gradient makes less than a right angle with the gradient at the seed. The
    // surface there is too thin or too small for the cells.
    std::int64_t missed_seeds = 0;
    // The number of triangles that face away from the gradient at one of their corners. The surface there has details
    // smaller than a cell, such as a thin wall.
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

// Returns whether the triangle faces away from the gradient at one of its corners.
[[nodiscard]] bool is_turned(const SurfaceMesh& mesh, std::int64_t triangle) noexcept;

// Makes a mesh of the surface. Seeds are points on or near the surface, and parts of the surface without a seed are not
// found. The result has the same bits for any number of threads. Throws Error{out_of_memory, cancelled, callback}, and
// Error{invalid_argument} if the mesh would exceed triangle_limit.
[[nodiscard]] SurfaceMesh triangulate(const base::Work& work, const implicit::Implicit& implicit,
                                      const geometry::VecArray& seeds, const MeshSettings& settings);

// Makes a mesh like triangulate(), but doubles settings.side until the mesh stays within the triangle limit.
[[nodiscard]] SurfaceMesh triangulate_of_any_size(const base::Work& work, const implicit::Implicit& implicit,
                                                  const geometry::VecArray& seeds, MeshSettings& settings);

} // namespace hrbfnpr::curves
