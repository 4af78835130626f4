// SPDX-License-Identifier: MIT
// A mesh as half-edges, here called sides, and walks over it at right angles to a side.
#pragma once

#include "base/assert.h"
#include "mesh/edges.h"

#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::mesh {

// Side 3 face + k goes from corner k of the face to the next one.
struct HalfEdgeMesh {
    HalfEdgeMesh(const Mesh& of, base::Array<glm::dvec3>&& normals, base::Array<std::int64_t>&& sides)
        : mesh(of), normal(std::move(normals)), beyond(std::move(sides)), bend(of.vertex.memory(), 3 * of.faces()) {}

    const Mesh& mesh;
    base::Array<glm::dvec3> normal; // The unit normal of each face.
    // For each side: the side of the other face at the same edge, or -1 at a border.
    base::Array<std::int64_t> beyond;
    // For each side: the angle between the normals of the two faces at its edge, in degrees; below 0 in hollows.
    base::Array<double> bend;

    [[nodiscard]] static std::int64_t next(std::int64_t side) noexcept { return side / 3 * 3 + (side + 1) % 3; }
    [[nodiscard]] std::int32_t start(std::int64_t side) const noexcept {
        return mesh.triangle[side / 3][static_cast<std::size_t>(side % 3)];
    }
    [[nodiscard]] const glm::dvec3& from(std::int64_t side) const noexcept { return mesh.vertex[start(side)]; }
    [[nodiscard]] glm::dvec3 along(std::int64_t side) const noexcept { return from(next(side)) - from(side); }
    [[nodiscard]] double length(std::int64_t side) const noexcept { return glm::length(along(side)); }
    // Returns the height of a side's triangle above that side.
    [[nodiscard]] double height(std::int64_t side) const noexcept {
        return glm::length(doubled_area(mesh.corners(side / 3))) / length(side);
    }
};

// Calls visit(side, opposite side) for each edge that has two faces.
template <class Visit>
void for_plain_edges(const HalfEdgeMesh& sided, const base::Progress& progress, Visit&& visit) {
    for (const std::int64_t side : progress.over(sided.beyond.size())) {
        if (sided.beyond[side] > side) visit(side, sided.beyond[side]);
    }
}

inline HalfEdgeMesh half_edges_of(const base::Work& work, const Mesh& mesh) {
    constexpr double degrees = 57.29577951308232;
    HalfEdgeMesh sided(mesh, unit_normals(mesh, work),
                       sides_beyond(mesh.triangle, sides_by_edge(work, mesh.triangle), work));
    for (std::int64_t side = 0; side < sided.beyond.size(); ++side) {
        const std::int64_t other = sided.beyond[side];
        if (other >= 0 && !run_opposite(mesh.triangle, side, other)) sided.beyond[side] = sided.beyond[other] = -1;
    }
    for_plain_edges(sided, work, [&](std::int64_t one, std::int64_t other) {
        const glm::dvec3& a = sided.normal[one / 3];
        const glm::dvec3& b = sided.normal[other / 3];
        const glm::dvec3 about = glm::cross(a, b);
        const double bend = degrees * std::atan2(glm::length(about), glm::dot(a, b));
        sided.bend[one] = sided.bend[other] = glm::dot(about, sided.along(one)) < 0.0 ? -bend : bend;
    });
    return sided;
}

// A place where a walk leaves a face.
struct Crossing {
    std::int64_t side; // the side through which the walk leaves
    double distance;   // the length of the walk up to this place
    double across;     // the cosine of the angle between the walk and the perpendicular of the side
};

// Walks from the middle of a side across its face and further, at right angles to the side. Calls visit(crossing)
// where the walk passes from one face to the next one. The walk ends where visit returns false, after the distance
// `reach`, at a border, or after `face_limit` faces. Returns the length of the walk.
template <class Visit>
double walk_beside(const HalfEdgeMesh& sided, std::int64_t side, double reach, std::int64_t face_limit,
                   Visit&& visit) noexcept {
    HRBFNPR_ASSERT(side >= 0 && side < sided.beyond.size() && reach >= 0.0);
    glm::dvec3 place = sided.from(side) + 0.5 * sided.along(side);
    glm::dvec3 way = glm::normalize(glm::cross(sided.normal[side / 3], sided.along(side)));
    double walked = 0.0;
    for (std::int64_t faces = 0; faces < face_limit; ++faces) {
        const glm::dvec3& normal = sided.normal[side / 3];
        std::int64_t exit = -1;
        double distance = std::numeric_limits<double>::infinity();
        for (std::int64_t other = HalfEdgeMesh::next(side); other != side; other = HalfEdgeMesh::next(other)) {
            const glm::dvec3 outward = glm::cross(sided.along(other), normal);
            const double speed = glm::dot(way, outward);
            if (!(speed > 1e-12 * glm::length(outward))) continue;
            const double to_other = std::max(glm::dot(sided.from(other) - place, outward) / speed, 0.0);
            if (to_other >= distance) continue;
            distance = to_other;
            exit = other;
        }
        if (exit < 0) return walked;
        if (distance >= reach - walked) return reach;
        walked += distance;
        if (sided.beyond[exit] < 0) return walked;
        place += distance * way;
        // Beyond an edge, the walk continues at the same angle to the edge.
        const glm::dvec3 edge = glm::normalize(sided.along(exit));
        const double along = glm::dot(way, edge);
        const double across = glm::dot(way, glm::cross(edge, normal));
        if (!visit(Crossing{exit, walked, across})) return walked;
        side = sided.beyond[exit];
        way = along * edge + across * glm::cross(edge, sided.normal[side / 3]);
    }
    return walked;
}

} // namespace hrbfnpr::mesh
