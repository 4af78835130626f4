// SPDX-License-Identifier: MIT
#include "mesh/corner_normals.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t grain = 4096;
// Corners at one vertex that are looked at: of fans with more, so many evenly chosen ones.
constexpr std::int64_t most_about = 256;
constexpr double radians = 0.017453292519943295;

[[nodiscard]] double angle_at(const std::array<glm::dvec3, 3>& p, std::size_t corner) noexcept {
    const glm::dvec3 u = p[(corner + 1) % 3] - p[corner];
    const glm::dvec3 v = p[(corner + 2) % 3] - p[corner];
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

// Corners (3 face + k) by vertex: those of vertex v are index[first[v]] .. index[first[v + 1] - 1].
struct Corners {
    Corners(const Mesh& mesh, const base::Progress& progress)
        : first(mesh.vertex.memory(), mesh.vertex.size() + 1), index(mesh.vertex.memory(), 3 * mesh.faces()) {
        for (const Triangle& t : mesh.triangle)
            for (const std::int32_t v : t) ++first[v + 1];
        for (std::int64_t v = 0; v < mesh.vertex.size(); ++v) first[v + 1] += first[v];
        progress.check();
        base::Array<std::int64_t> next(mesh.vertex.memory());
        for (const std::int64_t at : first) next.push_back(at);
        for (std::int64_t face = 0; face < mesh.faces(); ++face) {
            if (face % grain == 0) progress.check();
            for (std::size_t k = 0; k < 3; ++k)
                index[next[mesh.triangle[face][k]]++] = 3 * face + static_cast<std::int64_t>(k);
        }
    }
    base::Array<std::int64_t> first, index;
};

} // namespace

void set_corner_normals(const base::Runtime& runtime, double crease_angle, Mesh& mesh, const base::Progress& progress) {
    const Corners corners(mesh, progress);
    base::Array<glm::dvec3> normal(runtime.memory);   // of faces
    base::Array<glm::dvec3> weighted(runtime.memory); // the same, times the angle, for each corner
    normal.resize_for_overwrite(mesh.faces());
    weighted.resize_for_overwrite(3 * mesh.faces());
    mesh.corner_normal.resize_for_overwrite(3 * mesh.faces());
    runtime.parallel.for_chunks(mesh.faces(), grain, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t face = begin; face < end; ++face) {
            const auto p = mesh.corners(face);
            normal[face] = glm::normalize(doubled_area(p));
            for (std::size_t k = 0; k < 3; ++k)
                weighted[3 * face + static_cast<std::int64_t>(k)] = angle_at(p, k) * normal[face];
        }
    });
    const double least = std::cos(crease_angle * radians) - 1e-12;
    runtime.parallel.for_chunks(mesh.faces(), grain, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t corner = 3 * begin; corner < 3 * end; ++corner) {
            const glm::dvec3 own = normal[corner / 3];
            const std::int32_t v = mesh.triangle[corner / 3][static_cast<std::size_t>(corner % 3)];
            const std::int64_t step = (corners.first[v + 1] - corners.first[v] + most_about - 1) / most_about;
            glm::dvec3 sum = step > 1 ? weighted[corner] : glm::dvec3(0.0);
            for (std::int64_t at = corners.first[v]; at < corners.first[v + 1]; at += step) {
                const std::int64_t other = corners.index[at];
                if (glm::dot(own, normal[other / 3]) >= least) sum += weighted[other];
            }
            const double length = glm::length(sum);
            mesh.corner_normal[corner] = length > 1e-12 ? sum / length : own;
        }
    });
}

} // namespace hrbfnpr::mesh
