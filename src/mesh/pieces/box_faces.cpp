// SPDX-License-Identifier: MIT
#include "mesh/pieces/box_faces.h"

#include "geometry/segment.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

// Whether an axis parts a triangle (from the box's centre) and the box.
[[nodiscard]] bool parts(const glm::dvec3& axis, const std::array<glm::dvec3, 3>& p, double half) noexcept {
    const double a = glm::dot(axis, p[0]);
    const double b = glm::dot(axis, p[1]);
    const double c = glm::dot(axis, p[2]);
    const double radius = half * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
    return std::min({a, b, c}) > radius || std::max({a, b, c}) < -radius;
}

} // namespace

bool meets(const CellBox& box, const std::array<glm::dvec3, 3>& corners) noexcept {
    const std::array<glm::dvec3, 3> p{corners[0] - box.centre, corners[1] - box.centre, corners[2] - box.centre};
    const glm::dvec3 low = glm::min(glm::min(p[0], p[1]), p[2]);
    const glm::dvec3 high = glm::max(glm::max(p[0], p[1]), p[2]);
    for (int axis = 0; axis < 3; ++axis)
        if (low[axis] > box.half || high[axis] < -box.half) return false;
    if (parts(doubled_area(p), p, box.half)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 edge = p[(k + 1) % 3] - p[k];
        if (parts({0.0, -edge.z, edge.y}, p, box.half) || parts({edge.z, 0.0, -edge.x}, p, box.half) ||
            parts({-edge.y, edge.x, 0.0}, p, box.half))
            return false;
    }
    return true;
}

void faces_in_box(const CellBox& box, const Mesh& mesh, const base::Array<std::int32_t>& from,
                  base::Array<std::int32_t>& to) {
    for (const std::int32_t face : from)
        if (meets(box, mesh.corners(face))) to.push_back(face);
}

// To the plane's place if that is inside, else to the nearest edge.
double distance_to(const glm::dvec3& place, const std::array<glm::dvec3, 3>& corners) noexcept {
    const glm::dvec3 shares = shares_of(corners, place);
    if (shares.x >= 0.0 && shares.y >= 0.0 && shares.z >= 0.0)
        return glm::distance(place, shares.x * corners[0] + shares.y * corners[1] + shares.z * corners[2]);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k)
        least = std::min(least, geometry::distance_to_segment(place, corners[k], corners[(k + 1) % 3]));
    return least;
}

} // namespace hrbfnpr::mesh
