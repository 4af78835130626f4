// SPDX-License-Identifier: MIT
#include "mesh/fit/outer.h"

#include <cmath>

namespace hrbfnpr::mesh {
namespace {

// In no direction that edges of meshes have.
const std::array<glm::dvec3, 3> directions{glm::dvec3{0.5773, 0.2161, 0.7874}, glm::dvec3{-0.6431, 0.7321, 0.2247},
                                           glm::dvec3{0.1713, -0.5119, -0.8418}};
constexpr std::size_t rays = 16;
constexpr std::size_t dissenters = 2;
constexpr double beside = 1e-4; // a face, in diagonals
constexpr std::int64_t tested_a_task = 512;

[[nodiscard]] bool may_overlap(const Mesh& mesh) noexcept {
    return mesh.report.closed && mesh.report.components - mesh.report.left_out_components > 1;
}

// Whether its middle and its corners, or places close to them, lie inside another component.
[[nodiscard]] bool is_covered(const Mesh& mesh, const FaceTree& tree, std::int64_t face, double off) noexcept {
    const auto p = mesh.corners(face);
    const glm::dvec3 middle = (p[0] + p[1] + p[2]) / 3.0;
    const glm::dvec3 beyond = off * glm::normalize(doubled_area(p));
    if (!is_inside(tree, middle + beyond)) return false;
    for (const glm::dvec3& corner : p)
        if (!is_inside(tree, corner + 0.01 * (middle - corner) + beyond)) return false;
    return true;
}

} // namespace

bool is_inside(const FaceTree& tree, const glm::dvec3& place) noexcept {
    int votes = 0;
    for (const glm::dvec3& direction : directions) {
        int winding = 0;
        tree.crossings(place, direction, [&](std::int64_t, double, int sign) { winding += sign; });
        votes += winding > 0 ? 1 : 0;
    }
    return votes >= 2;
}

Where where(const FaceTree& tree, const glm::dvec3& place) noexcept {
    std::size_t votes = 0;
    for (std::size_t k = 0; k < rays; ++k) {
        // Evenly over the sphere [Vogel 1979], and turned.
        const double z = 1.0 - (2.0 * static_cast<double>(k) + 1.0) / static_cast<double>(rays);
        const double angle = 0.6 + 2.399963229728653 * static_cast<double>(k);
        const double r = std::sqrt(1.0 - z * z);
        const glm::dvec3 direction = r * std::cos(angle) * directions[0] + r * std::sin(angle) * directions[1] +
                                     z * glm::cross(directions[0], directions[1]);
        int winding = 0;
        tree.crossings(place, direction, [&](std::int64_t, double, int sign) { winding += sign; });
        votes += winding > 0 ? 1 : 0;
    }
    if (votes >= rays - dissenters) return Where::inside;
    return votes <= dissenters ? Where::outside : Where::unsure;
}

void keep_outer(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, geometry::VecArray& position,
                geometry::VecArray& normal, const base::Progress& progress) {
    if (!may_overlap(mesh)) return;
    base::Array<std::uint8_t> inside(runtime.memory, position.size());
    const double off = beside * mesh.bounds.diagonal();
    runtime.parallel.for_chunks(position.size(), tested_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) inside[i] = is_inside(tree, position[i] + off * normal[i]) ? 1 : 0;
    });
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < position.size(); ++i) {
        if (inside[i] != 0) continue;
        position.set(kept, position[i]);
        normal.set(kept++, normal[i]);
    }
    if (kept == 0) return; // all of them: a mesh of which nobody knows what is outside
    position.resize(kept);
    normal.resize(kept);
}

OuterFaces::OuterFaces(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& all,
                       const base::Progress& progress)
    : all_(all) {
    if (!may_overlap(mesh)) return;
    base::Array<std::uint8_t> covered(runtime.memory, mesh.faces());
    const double off = beside * mesh.bounds.diagonal();
    runtime.parallel.for_chunks(mesh.faces(), tested_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t face = begin; face < end; ++face) covered[face] = is_covered(mesh, all, face, off) ? 1 : 0;
    });
    base::Array<Triangle> outer(runtime.memory);
    for (std::int64_t face = 0; face < mesh.faces(); ++face)
        if (covered[face] == 0) outer.push_back(mesh.triangle[face]);
    if (!outer.empty() && outer.size() < mesh.faces()) outer_.emplace(runtime, mesh.vertex, outer, progress);
}

} // namespace hrbfnpr::mesh
