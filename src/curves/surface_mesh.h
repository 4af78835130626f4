// SPDX-License-Identifier: MIT
// A triangulation of f = 0, on which curves are found and against which rays are tested.
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
    geometry::Bounds region; // the mesh ends at its walls; outside it f is evaluated at seeds only
    double side = 0.0;       // the largest cell side, > 0: thinner or smaller parts of the surface may be missed
    std::int64_t triangle_limit = 4'000'000;
    // The mesh may end where the domain says that the surface is nowhere near. It continues for at least a few cells
    // beyond the surface's end.
    const implicit::Domain* domain = nullptr;
    double tolerance = 1e-9; // the greatest distance of vertices from the surface, in diagonals
};

// An oriented mesh; it is closed except where the region ends.
struct SurfaceMesh {
    explicit SurfaceMesh(base::Memory& memory) noexcept
        : position(memory), gradient(memory), corner(memory), neighbour(memory) {}

    geometry::VecArray position;         // the vertices; all except `unresolved` ones are on the surface
    geometry::VecArray gradient;         // grad f at each vertex
    base::Array<std::int32_t> corner;    // 3 of each triangle, counter-clockwise as seen from where f > 0
    base::Array<std::int32_t> neighbour; // 3 of each triangle: the one across the edge from corner k to k + 1; -1: none
    geometry::Bounds region;
    const implicit::Domain* domain = nullptr; // where in the region the surface is; null: everywhere
    double side = 0.0;                        // the longest side of the cells
    std::int64_t unresolved = 0;              // vertices that are not on the surface, or whose gradient is 0
    // Seeds on the surface, or less than a side from it, without a vertex near them whose gradient points the same way:
    // the surface there is too thin or too small for the cells.
    std::int64_t missed_seeds = 0;
    // Triangles that face away from the gradient at one of their corners: the surface has details smaller than the
    // cells there, such as a wall thinner than a cell's diagonal.
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

// Whether the triangle faces away from the gradient at one of its corners.
[[nodiscard]] bool is_turned(const SurfaceMesh& mesh, std::int64_t triangle) noexcept;

// Seeds are points on or near the surface; parts of the surface without a seed are not found. The same bits for any
// thread count. Throws Error{out_of_memory, cancelled, callback}, and Error{invalid_argument} if the mesh would exceed
// triangle_limit.
[[nodiscard]] SurfaceMesh triangulate(const base::Work& work, const implicit::Implicit& implicit,
                                      const geometry::VecArray& seeds, const MeshSettings& settings);

// Makes a mesh as triangulate() does, but doubles settings.side as often as needed to stay within the triangle limit.
[[nodiscard]] SurfaceMesh triangulate_of_any_size(const base::Work& work, const implicit::Implicit& implicit,
                                                  const geometry::VecArray& seeds, MeshSettings& settings);

} // namespace hrbfnpr::curves
