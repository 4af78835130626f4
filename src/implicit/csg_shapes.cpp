// SPDX-License-Identifier: MIT
#include "implicit/csg_shapes.h"

namespace hrbfnpr::implicit {
namespace {

constexpr double boundless = std::numeric_limits<double>::infinity();

// Of places, which are within 1e150: faster than std::hypot, and the same everywhere.
double root_of_squares(double x, double y) noexcept { return std::sqrt(x * x + y * y); }

// A function of the distance from the z axis and of z, with its derivatives.
struct Profile {
    double value = 0.0;
    double by_rho = 0.0, by_z = 0.0;
    double by_rho_rho = 0.0, by_rho_z = 0.0, by_z_z = 0.0;
};

// On the axis, where a gradient across it would have no direction, there is none across it.
CsgJet around_axis(const glm::dvec3& p, double rho, const Profile& f) noexcept {
    if (rho == 0.0) return {f.value, {0.0, 0.0, f.by_z}, {0.0, 0.0, 0.0, 0.0, 0.0, f.by_z_z}};
    const double x = p.x / rho;
    const double y = p.y / rho;
    const double bend = f.by_rho / rho;
    return {f.value,
            {f.by_rho * x, f.by_rho * y, f.by_z},
            {f.by_rho_rho * x * x + bend * y * y, (f.by_rho_rho - bend) * x * y, f.by_rho_z * x,
             f.by_rho_rho * y * y + bend * x * x, f.by_rho_z * y, f.by_z_z}};
}

CsgJet plane(int axis, double sign, double value) noexcept {
    CsgJet jet{value, glm::dvec3(0.0), {}};
    jet.gradient[axis] = sign;
    return jet;
}

CsgJet sphere(const glm::dvec3& p, double radius) noexcept {
    const double length = glm::length(p);
    CsgJet jet{length - radius, glm::dvec3(0.0), {}};
    if (length == 0.0) return jet;
    const glm::dvec3 n = p / length;
    jet.gradient = n;
    jet.hessian = {(1.0 - n.x * n.x) / length, -n.x * n.y / length, -n.x * n.z / length,
                   (1.0 - n.y * n.y) / length, -n.y * n.z / length, (1.0 - n.z * n.z) / length};
    return jet;
}

Profile tube(double rho, double z, double radius, double tube_radius) noexcept {
    const double across = rho - radius;
    const double length = root_of_squares(across, z);
    if (length == 0.0) return {-tube_radius, 0.0, 0.0, 0.0, 0.0, 0.0};
    const double u = across / length;
    const double v = z / length;
    return {length - tube_radius, u, v, v * v / length, -u * v / length, u * u / length};
}

// How far a disc about the z axis reaches along each axis, moved.
glm::dvec3 reach_of_disc(const glm::dmat3& linear, double radius) noexcept {
    glm::dvec3 reach;
    for (int i = 0; i < 3; ++i) reach[i] = radius * std::hypot(linear[0][i], linear[1][i]);
    return reach;
}

// ... and a ball.
glm::dvec3 reach_of_ball(const glm::dmat3& linear, double radius) noexcept {
    glm::dvec3 reach;
    for (int i = 0; i < 3; ++i) reach[i] = radius * glm::length(glm::dvec3(linear[0][i], linear[1][i], linear[2][i]));
    return reach;
}

CsgBox about(const glm::dvec3& centre, const glm::dvec3& reach) noexcept { return {centre - reach, centre + reach}; }

// {n . y <= level}, n: the z axis before it was moved.
CsgBox half_space(const glm::dmat3& linear, const glm::dvec3& translation, double level, double side) noexcept {
    const glm::dvec3 n = glm::cross(linear[0], linear[1]) * (glm::determinant(linear) < 0.0 ? -1.0 : 1.0);
    CsgBox box;
    for (int i = 0; i < 3; ++i) {
        if (n[(i + 1) % 3] != 0.0 || n[(i + 2) % 3] != 0.0) continue;
        const double end = translation[i] + linear[2][i] * side * level;
        const bool below = (n[i] > 0.0) == (side > 0.0);
        (below ? box.high : box.low)[i] = end;
    }
    return box;
}

} // namespace

CsgShape::CsgShape(const CsgNode& node) noexcept
    : kind_(node.kind), half_(0.5 * node.size), radius_(node.radius), second_radius_(node.second_radius) {
    if (kind_ == CsgKind::cylinder) second_radius_ = radius_;
    if (kind_ != CsgKind::cylinder && kind_ != CsgKind::cone) return;
    half_.z = 0.5 * node.height;
    const double narrows = radius_ - second_radius_;
    const double length = std::hypot(node.height, narrows);
    slant_ = {node.height / length, narrows / length};
}

std::int32_t CsgShape::sheets() const noexcept {
    switch (kind_) {
    case CsgKind::box: return 6;
    case CsgKind::cylinder:
    case CsgKind::cone: return 3;
    default: return 1;
    }
}

double CsgShape::value(const glm::dvec3& p, std::int32_t& sheet) const noexcept {
    sheet = 0;
    switch (kind_) {
    case CsgKind::half_space: return p.z;
    case CsgKind::sphere: return glm::length(p) - radius_;
    case CsgKind::torus: return root_of_squares(root_of_squares(p.x, p.y) - radius_, p.z) - second_radius_;
    case CsgKind::box: {
        const glm::dvec3 beyond = glm::abs(p) - half_;
        int axis = beyond.y > beyond.x ? 1 : 0;
        if (beyond.z > beyond[axis]) axis = 2;
        sheet = 2 * axis + (p[axis] < 0.0 ? 1 : 0);
        return beyond[axis];
    }
    default: break;
    }
    const double beside = side(root_of_squares(p.x, p.y), p.z);
    const double beyond = std::abs(p.z) - half_.z;
    if (!(beyond > beside)) return beside;
    sheet = p.z < 0.0 ? 2 : 1;
    return beyond;
}

CsgJet CsgShape::jet(std::int32_t sheet, const glm::dvec3& p) const noexcept {
    switch (kind_) {
    case CsgKind::half_space: return plane(2, 1.0, p.z);
    case CsgKind::sphere: return sphere(p, radius_);
    case CsgKind::torus: {
        const double rho = root_of_squares(p.x, p.y);
        return around_axis(p, rho, tube(rho, p.z, radius_, second_radius_));
    }
    case CsgKind::box: {
        const int axis = sheet / 2;
        const double sign = sheet % 2 == 0 ? 1.0 : -1.0;
        return plane(axis, sign, sign * p[axis] - half_[axis]);
    }
    default: break;
    }
    if (sheet > 0) return plane(2, sheet == 1 ? 1.0 : -1.0, (sheet == 1 ? p.z : -p.z) - half_.z);
    const double rho = root_of_squares(p.x, p.y);
    return around_axis(p, rho, {side(rho, p.z), slant_.x, slant_.y, 0.0, 0.0, 0.0});
}

CsgBox CsgShape::box(const glm::dmat3& linear, const glm::dvec3& translation, double level) const noexcept {
    switch (kind_) {
    case CsgKind::half_space: return half_space(linear, translation, level, 1.0);
    case CsgKind::sphere: return about(translation, reach_of_ball(linear, radius_ + level));
    case CsgKind::torus:
        return about(translation, reach_of_disc(linear, radius_) + reach_of_ball(linear, second_radius_ + level));
    case CsgKind::box: {
        const glm::dmat3 size(glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2]));
        return about(translation, size * (half_ + level));
    }
    default: break;
    }
    // The side moves outward by level / slant.x, and is met by the ends that have moved along it.
    const double outward = level / slant_.x;
    const double along = outward * std::abs(slant_.y);
    const glm::dvec3 up = linear[2] * (half_.z + level);
    return hull(about(translation - up, reach_of_disc(linear, radius_ + outward + along)),
                about(translation + up, reach_of_disc(linear, second_radius_ + outward + along)));
}

CsgBox CsgShape::box_outside(const glm::dmat3& linear, const glm::dvec3& translation, double level) const noexcept {
    if (kind_ == CsgKind::half_space) return half_space(linear, translation, level, -1.0);
    return {glm::dvec3(-boundless), glm::dvec3(boundless)};
}

} // namespace hrbfnpr::implicit
