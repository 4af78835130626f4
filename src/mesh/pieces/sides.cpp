// SPDX-License-Identifier: MIT
#include "mesh/pieces/sides.h"

#include "mesh/fit/outer.h"

#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr double on_edge = 1e-6;     // shares of a corner
constexpr double off_face = 1e-4;    // diagonals: where it is looked which side a face has to the outside
constexpr std::int64_t probes = 128; // faces that tell whether a mesh with gaps is solid all the same
constexpr double solid_share = 0.95;
constexpr double folded = 0.4; // length of the sum of both normals: faces at less than 23 degrees, one upon the other

} // namespace

Sides::Sides(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const base::Progress& progress)
    : mesh_(mesh), tree_(tree), normal_(runtime.memory), edge_(runtime.memory, 3 * mesh.faces()),
      vertex_(runtime.memory, mesh.vertex.size()), folded_(runtime.memory, mesh.vertex.size()),
      off_(off_face * mesh.bounds.diagonal()) {
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        const auto p = mesh.corners(face);
        normal_.push_back(glm::normalize(doubled_area(p)));
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 u = p[(k + 1) % 3] - p[k];
            const glm::dvec3 v = p[(k + 2) % 3] - p[k];
            vertex_[mesh.triangle[face][k]] +=
                std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)) * normal_[face];
        }
    }
    const base::Array<Side> sides = sides_by_edge(runtime, mesh.triangle, progress);
    for_edges(sides, progress, [&](const Side* first, const Side* last) {
        glm::dvec3 sum(0.0);
        for (const Side* side = first; side != last; ++side) sum += normal_[side->face];
        if (last - first == 2 && glm::length(sum) < folded)
            for (const Side* side = first; side != last; ++side)
                for (const std::int32_t vertex : mesh.triangle[side->face]) folded_[vertex] = 1;
        const auto low = static_cast<std::int32_t>(first->edge >> 32U);
        const auto high = static_cast<std::int32_t>(first->edge & 0xFFFFFFFFU);
        for (const Side* side = first; side != last; ++side) {
            const std::int32_t from = side->forward != 0 ? low : high;
            const Triangle& t = mesh.triangle[side->face];
            edge_[3 * std::int64_t{side->face} + (t[0] == from ? 0 : t[1] == from ? 1 : 2)] = sum;
        }
    });
    const MeshReport& report = mesh.report;
    solid_ = report.closed || looks_solid(runtime, progress);
    const bool simple = report.closed && report.components - report.left_out_components == 1;
    by_rays_ = solid_ && !simple;
}

// By number, and by area: of a tray the many small faces of its rounded corners may look solid.
bool Sides::looks_solid(const base::Runtime& runtime, const base::Progress& progress) const {
    base::Array<std::int64_t> by_number(runtime.memory);
    base::Array<std::int64_t> by_area(runtime.memory);
    const std::int64_t step = std::max<std::int64_t>(1, mesh_.faces() / probes);
    for (std::int64_t face = 0; face < mesh_.faces(); face += step) by_number.push_back(face);
    double area = 0.0;
    for (std::int64_t face = 0; face < mesh_.faces(); ++face) area += glm::length(doubled_area(mesh_.corners(face)));
    double passed = 0.0;
    for (std::int64_t face = 0; face < mesh_.faces(); ++face) {
        passed += glm::length(doubled_area(mesh_.corners(face)));
        while (by_area.size() < probes && passed * probes >= area * (static_cast<double>(by_area.size()) + 0.5))
            by_area.push_back(face);
    }
    return look_solid(runtime, by_number, progress) && look_solid(runtime, by_area, progress);
}

bool Sides::look_solid(const base::Runtime& runtime, const base::Array<std::int64_t>& face,
                       const base::Progress& progress) const {
    base::Array<std::uint8_t> right(runtime.memory, face.size());
    runtime.parallel.for_chunks(face.size(), 16, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) {
            const auto p = mesh_.corners(face[i]);
            const glm::dvec3 middle = (p[0] + p[1] + p[2]) / 3.0;
            const glm::dvec3 off = off_ * normal_[face[i]];
            right[i] = where(tree_, middle + off) == Where::outside && where(tree_, middle - off) == Where::inside;
        }
    });
    std::int64_t sum = 0;
    for (const std::uint8_t one : right) sum += one;
    return static_cast<double>(sum) >= solid_share * static_cast<double>(face.size());
}

glm::dvec3 Sides::pseudo_normal(std::int64_t face, const glm::dvec3& place, bool& inner) const noexcept {
    const glm::dvec3 shares = shares_of(mesh_.corners(face), place);
    inner = shares.x > on_edge && shares.y > on_edge && shares.z > on_edge;
    if (inner) return normal_[face];
    for (int k = 0; k < 3; ++k)
        if (shares[k] >= 1.0 - on_edge) return vertex_[mesh_.triangle[face][static_cast<std::size_t>(k)]];
    // The side opposite the corner that has no share.
    const int corner = shares.x <= on_edge ? 0 : shares.y <= on_edge ? 1 : 2;
    return edge_[3 * face + (corner + 1) % 3];
}

Beside Sides::beside(const glm::dvec3& place) const noexcept {
    const FaceTree::Nearest nearest = tree_.nearest(place);
    Beside result{std::sqrt(nearest.squared), nearest.face, nearest.place, false};
    const glm::dvec3 normal = pseudo_normal(nearest.face, nearest.place, result.inner);
    const bool by_rays = by_rays_ || (solid_ && is_folded(nearest.face));
    const bool inside = by_rays ? is_inside(tree_, place) : glm::dot(place - nearest.place, normal) < 0.0;
    if (inside) result.distance = -result.distance;
    return result;
}

bool Sides::is_folded(std::int64_t face) const noexcept {
    const Triangle& t = mesh_.triangle[face];
    return folded_[t[0]] != 0 || folded_[t[1]] != 0 || folded_[t[2]] != 0;
}

double Sides::room(const glm::dvec3& place, const glm::dvec3& along, double most) const noexcept {
    const FaceTree::Hit hit = tree_.first_hit(place, 2.0 * most * along, 1e-6, 1.0);
    return hit.face < 0 ? most : 0.9 * hit.t * most;
}

bool Sides::is_outer(const Beside& beside) const noexcept {
    return !by_rays_ || !is_inside(tree_, beside.place + off_ * normal_[beside.face]) ||
           !is_inside(tree_, beside.place - off_ * normal_[beside.face]);
}

} // namespace hrbfnpr::mesh
