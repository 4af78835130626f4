// SPDX-License-Identifier: MIT
// Numbers of corners and sides: corner k of a face has the number 3 face + k, and so has the side from there to the
// next corner.
#pragma once

#include "base/groups.h"
#include "mesh/edges.h"

#include <cmath>

namespace hrbfnpr::mesh {

[[nodiscard]] inline std::int32_t low_end(const Side& side) noexcept {
    return static_cast<std::int32_t>(side.edge >> 32U);
}
[[nodiscard]] inline std::int32_t high_end(const Side& side) noexcept {
    return static_cast<std::int32_t>(side.edge & 0xFFFFFFFFU);
}

// Returns the number of a face's corner at a vertex.
[[nodiscard]] inline std::int64_t corner_at(const base::Array<Triangle>& triangle, std::int64_t face,
                                            std::int32_t vertex) noexcept {
    const Triangle& t = triangle[face];
    HRBFNPR_ASSERT(t[0] == vertex || t[1] == vertex || t[2] == vertex);
    return 3 * face + (t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2);
}

[[nodiscard]] inline std::int64_t number_of(const base::Array<Triangle>& triangle, const Side& side) noexcept {
    return corner_at(triangle, side.face, side.forward != 0 ? low_end(side) : high_end(side));
}

// Returns the angle at a corner, in radians.
[[nodiscard]] inline double angle_at(const std::array<glm::dvec3, 3>& p, std::size_t k) noexcept {
    HRBFNPR_ASSERT(k < 3);
    const glm::dvec3 u = p[(k + 1) % 3] - p[k];
    const glm::dvec3 v = p[(k + 2) % 3] - p[k];
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

// Returns the numbers of the corners at each vertex, rising.
[[nodiscard]] inline base::Groups corners_at_vertices(const Mesh& mesh, const base::Progress& progress) {
    return {mesh.vertex.memory(), mesh.vertex.size(), [&](auto&& put) {
                for (std::int64_t corner = 0; corner < 3 * mesh.faces(); ++corner) {
                    if (corner % 16384 == 0) progress.check();
                    put(mesh.triangle[corner / 3][static_cast<std::size_t>(corner % 3)],
                        static_cast<std::int32_t>(corner));
                }
            }};
}

} // namespace hrbfnpr::mesh
