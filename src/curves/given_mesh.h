// SPDX-License-Identifier: MIT
// Makes the mesh of a surface from triangles near it, such as those of the mesh that the surface was fitted to. Cells
// cannot tell two walls apart that are closer together than a cell, but triangles of a mesh can.
#pragma once

#include "base/work.h"
#include "curves/surface_mesh.h"

#include <array>
#include <cstdint>
#include <span>

namespace hrbfnpr::curves {

// Oriented triangles near a surface. No two of them have the same half-edge.
struct GivenTriangles {
    std::span<const glm::dvec3> vertex;
    std::span<const std::array<std::int32_t, 3>> triangle;

    [[nodiscard]] bool empty() const noexcept { return triangle.empty(); }
};

struct GivenMeshSettings {
    geometry::Bounds region; // as in MeshSettings
    double side = 0.0;       // Edges longer than this are halved. It becomes the side of the result.
    // Strips of this width are added along the border, so that the result can be cut where the surface ends. 0: none.
    double strip = 0.0;
    std::int64_t triangle_limit = 4'000'000; // Edges are no longer halved beyond this number of triangles.
};

// Moves the vertices onto the surface, adds strips, and halves long edges. The result has the same bits for any number
// of threads. Throws Error{out_of_memory, cancelled, callback}.
[[nodiscard]] SurfaceMesh mesh_of_triangles(const base::Work& work, const implicit::Implicit& implicit,
                                            const GivenTriangles& given, const GivenMeshSettings& settings);

} // namespace hrbfnpr::curves
