// SPDX-License-Identifier: MIT
#include "mesh/fit/flat.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

constexpr double flatness = 1e-6;  // in diagonals, from the plane of the largest face
constexpr double other_way = 0.01; // share of the area that may look the other way

// Unit, of the face with the largest area; and a place of it.
struct Plane {
    glm::dvec3 normal{0.0};
    glm::dvec3 place{0.0};
};

Plane plane_of_largest(const Mesh& mesh) {
    glm::dvec3 most(0.0);
    Plane plane;
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        const std::array<glm::dvec3, 3> corners = mesh.corners(face);
        const glm::dvec3 area = doubled_area(corners);
        if (glm::dot(area, area) <= glm::dot(most, most)) continue;
        most = area;
        plane.place = corners[0];
    }
    if (const double length = glm::length(most); length > 0.0) plane.normal = most / length;
    return plane;
}

} // namespace

void refuse_flat_solid(const Mesh& mesh) {
    const Plane plane = plane_of_largest(mesh);
    const double most = flatness * glm::length(mesh.bounds.size());
    double toward = 0.0;
    double away = 0.0;
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        const std::array<glm::dvec3, 3> corners = mesh.corners(face);
        for (const glm::dvec3& corner : corners)
            if (std::abs(glm::dot(corner - plane.place, plane.normal)) > most) return;
        const double area = glm::dot(doubled_area(corners), plane.normal);
        (area < 0.0 ? away : toward) += std::abs(area);
    }
    const double all = toward + away;
    if (std::min(toward, away) > other_way * all)
        fail(
            Status::invalid_argument,
            "the mesh is flat: all of its vertices lie in one plane, %.0f %% of the area looks one way and %.0f %% the "
            "other, so it has no inside; keep the faces of one side, or give it a thickness",
            100.0 * std::max(toward, away) / all, 100.0 * std::min(toward, away) / all);
}

} // namespace hrbfnpr::mesh
