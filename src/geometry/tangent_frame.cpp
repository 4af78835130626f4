// SPDX-License-Identifier: MIT
#include "geometry/tangent_frame.h"

#include <cmath>

namespace hrbfnpr::geometry {
namespace {

// Returns the axis along which n has the component of smallest magnitude. Ties go to the first axis, so that the choice
// is stable.
int smallest_axis(const glm::dvec3& n) noexcept {
    const glm::dvec3 a = glm::abs(n);
    if (a.x <= a.y && a.x <= a.z) return 0;
    return a.y <= a.z ? 1 : 2;
}

glm::dvec3 cross_with_axis(const glm::dvec3& n, int axis) noexcept {
    if (axis == 0) return {0.0, n.z, -n.y};
    if (axis == 1) return {-n.z, 0.0, n.x};
    return {n.y, -n.x, 0.0};
}

} // namespace

glm::dvec3 any_perpendicular(const glm::dvec3& n) noexcept {
    return glm::normalize(cross_with_axis(n, smallest_axis(n)));
}

TangentFrame stipple_frame(const glm::dvec3& n) noexcept {
    // R is the rotation by 90 degrees about this axis. The axis is not a coordinate axis, so that the two singular
    // points are away from the poles of symmetric models.
    constexpr glm::dvec3 axis(0.36, 0.48, 0.80); // unit length
    const glm::dvec3 turned = glm::cross(axis, n) + axis * glm::dot(axis, n);
    const glm::dvec3 u = glm::cross(n, turned);
    const double length = glm::length(u);
    if (length < 1e-9) {
        const glm::dvec3 fallback = any_perpendicular(n);
        return {fallback, glm::cross(n, fallback)};
    }
    return {u / length, glm::normalize(glm::cross(n, u))};
}

TangentFrame combing_frame(const glm::dvec3& n) noexcept {
    const glm::dvec3 u = any_perpendicular(n);
    return {u, glm::cross(n, u)};
}

double combing_confidence(const glm::dvec3& n) noexcept {
    double a = std::abs(n.x);
    double b = std::abs(n.y);
    double c = std::abs(n.z);
    if (a > b) std::swap(a, b);
    if (b > c) std::swap(b, c);
    if (a > b) std::swap(a, b);
    return glm::smoothstep(0.05, 0.35, b - a);
}

} // namespace hrbfnpr::geometry
