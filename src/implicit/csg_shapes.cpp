// SPDX-License-Identifier: MIT
#include "implicit/csg_shapes.h"

#include "implicit/sheets.h"

#include <utility>

namespace hrbfnpr::implicit {
namespace {

// Coordinates are below 1e150, so the squares do not overflow. This is faster than std::hypot, and gives the same bits
// on all platforms.
double root_of_squares(double x, double y) noexcept { return std::sqrt(x * x + y * y); }

BlendJet only_a(double a) noexcept { return {a, 1.0, 0.0, 0.0, 0.0, 0.0}; }
BlendJet only_b(double b) noexcept { return {b, 0.0, 1.0, 0.0, 0.0, 0.0}; }

// Returns min(a, b) - R/6 (1 - |a - b|/R)^3 where |a - b| < R. It is twice continuously differentiable, and ends at its
// radius like the blends of Barthe, Wyvill and de Groot ("Controllable binary CSG operators for soft objects", 2004).
BlendJet polynomial_minimum(double a, double b, double radius) noexcept {
    const double u = a - b;
    if (std::abs(u) >= radius) return u < 0.0 ? only_a(a) : only_b(b);
    const double h = 1.0 - std::abs(u) / radius;
    const double slope = std::copysign(0.5 - 0.5 * h * h, u);
    const double bend = h / radius;
    return {std::min(a, b) - radius / 6.0 * h * h * h, 0.5 - slope, 0.5 + slope, -bend, bend, -bend};
}

// Returns max(R, min(a, b)) - (A^p + B^p)^(1/p) with A = max(0, R - a) and B = max(0, R - b). This is the super-ellipse
// of Ricci ("A constructive geometry for computer graphics", 1973), applied to the densities A and B, which are 0 at
// distances of R and more.
BlendJet elliptic_minimum(double a, double b, double radius, double p) noexcept {
    if (std::isnan(a) || std::isnan(b)) return only_a(a + b);
    const double big_a = std::max(0.0, radius - a);
    const double big_b = std::max(0.0, radius - b);
    if (big_b == 0.0 && big_a == 0.0) return takes_lower(a, b) ? only_b(b) : only_a(a);
    if (big_b == 0.0) return only_a(a);
    if (big_a == 0.0) return only_b(b);
    const double most = std::max(big_a, big_b);
    const double norm = most * std::pow(std::pow(big_a / most, p) + std::pow(big_b / most, p), 1.0 / p);
    const double s = big_a / norm;
    const double t = big_b / norm;
    const double s_low = std::pow(s, p - 2.0);
    const double t_low = std::pow(t, p - 2.0);
    const double bend = (p - 1.0) / norm;
    return {radius - norm,
            s_low * s,
            t_low * t,
            -bend * s_low * t_low * t * t,
            bend * s_low * s * t_low * t,
            -bend * t_low * s_low * s * s};
}

// Faces of an empty box are included, because the box may become nonempty when it grows.
CsgBox hull(const CsgBox& a, const CsgBox& b) noexcept {
    return {glm::min(glm::min(a.low, a.high), glm::min(b.low, b.high)),
            glm::max(glm::max(a.low, a.high), glm::max(b.low, b.high))};
}

CsgBox common(const CsgBox& a, const CsgBox& b) noexcept { return {glm::max(a.low, b.low), glm::min(a.high, b.high)}; }

// A function of z and of the distance from the z axis, with its derivatives.
struct Profile {
    double value = 0.0;
    double by_rho = 0.0, by_z = 0.0;
    double by_rho_rho = 0.0, by_rho_z = 0.0, by_z_z = 0.0;
};

// Returns the jet of a profile. On the axis the radial part of the gradient has no direction and is omitted.
Jet around_axis(const glm::dvec3& p, double rho, const Profile& f) noexcept {
    if (rho == 0.0) return {f.value, {0.0, 0.0, f.by_z}, {0.0, 0.0, 0.0, 0.0, 0.0, f.by_z_z}};
    const double x = p.x / rho;
    const double y = p.y / rho;
    const double bend = f.by_rho / rho;
    return {f.value,
            {f.by_rho * x, f.by_rho * y, f.by_z},
            {f.by_rho_rho * x * x + bend * y * y, (f.by_rho_rho - bend) * x * y, f.by_rho_z * x,
             f.by_rho_rho * y * y + bend * x * x, f.by_rho_z * y, f.by_z_z}};
}

Jet plane(int axis, double sign, double value) noexcept {
    Jet jet{value, glm::dvec3(0.0), {}};
    jet.gradient[axis] = sign;
    return jet;
}

Jet sphere(const glm::dvec3& p, double radius) noexcept {
    const double length = glm::length(p);
    Jet jet{length - radius, glm::dvec3(0.0), {}};
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

// Returns half the extent along each axis of a disc about the z axis after the linear map.
glm::dvec3 reach_of_disc(const glm::dmat3& linear, double radius) noexcept {
    glm::dvec3 reach;
    for (int i = 0; i < 3; ++i) reach[i] = radius * std::hypot(linear[0][i], linear[1][i]);
    return reach;
}

// Returns half the extent along each axis of a ball after the linear map.
glm::dvec3 reach_of_ball(const glm::dmat3& linear, double radius) noexcept {
    glm::dvec3 reach;
    for (int i = 0; i < 3; ++i) reach[i] = radius * glm::length(glm::dvec3(linear[0][i], linear[1][i], linear[2][i]));
    return reach;
}

CsgBox about(const glm::dvec3& centre, const glm::dvec3& reach) noexcept { return {centre - reach, centre + reach}; }

// Returns the bounds of {side z <= level} after an affine map. `side` is 1 or -1.
CsgBox half_space(const glm::dmat3& linear, const glm::dvec3& translation, double level, double side) noexcept {
    HRBFNPR_ASSERT(level >= 0.0 && std::abs(side) == 1.0);
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

// Computes the singular values: it rotates pairs of columns until all columns are perpendicular [Hestenes 1958].
StretchFactors stretch_factors(const glm::dmat3& linear) noexcept {
    const double size = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
    if (!(size > 0.0 && std::isfinite(size))) return {0.0, size};
    glm::dmat3 m = linear / size;
    constexpr int most_sweeps = 30;
    bool turned = true;
    for (int sweep = 0; sweep < most_sweeps && turned; ++sweep) {
        turned = false;
        for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
            const double slant = glm::dot(m[p], m[q]);
            if (std::abs(slant) <= 1e-16 * glm::length(m[p]) * glm::length(m[q])) continue;
            turned = true;
            const double ratio = 0.5 * (glm::dot(m[q], m[q]) - glm::dot(m[p], m[p])) / slant;
            const double tangent = std::copysign(1.0, ratio) / (std::abs(ratio) + std::hypot(1.0, ratio));
            const double c = 1.0 / std::hypot(1.0, tangent);
            const glm::dvec3 column = m[p];
            m[p] = c * (column - tangent * m[q]);
            m[q] = c * (tangent * column + m[q]);
        }
    }
    const double a = glm::length(m[0]);
    const double b = glm::length(m[1]);
    const double d = glm::length(m[2]);
    return {size * std::min({a, b, d}), size * std::max({a, b, d})};
}

BlendJet Blend::minimum(double a, double b) const noexcept {
    return exponent == 0.0 ? polynomial_minimum(a, b, radius) : elliptic_minimum(a, b, radius, exponent);
}

// A blend differs from the lower operand only where both operands are within its radius.
CsgReach reach_of_minimum(const CsgReach& a, const CsgReach& b, const Blend& blend) noexcept {
    CsgReach reach{hull(a.inside, b.inside), common(a.outside, b.outside), std::max(a.slope, b.slope)};
    if (blend.radius == 0.0) return reach;
    const double deep = blend.depth();
    const CsgBox both =
        common(a.inside.grown(a.slope * (blend.radius + deep)), b.inside.grown(b.slope * (blend.radius + deep)));
    const CsgBox added = common(both, reach.inside.grown(reach.slope * deep));
    if (!added.empty()) reach.inside = hull(reach.inside, added);
    return reach;
}

CsgReach reach_of_maximum(const CsgReach& a, const CsgReach& b, const Blend& blend) noexcept {
    return reach_of_minimum(a.complement(), b.complement(), blend).complement();
}

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

Jet CsgShape::jet(std::int32_t sheet, const glm::dvec3& p) const noexcept {
    HRBFNPR_ASSERT(sheet >= 0 && sheet < sheets());
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

// Returns the bounds of {f <= level} after an affine map.
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
    // If f grows by `level`, the side of the cone moves outward by level / slant.x, and the ends move by `level` along
    // the axis. So the side becomes longer.
    const double outward = level / slant_.x;
    const double along = outward * std::abs(slant_.y);
    const glm::dvec3 up = linear[2] * (half_.z + level);
    return hull(about(translation - up, reach_of_disc(linear, radius_ + outward + along)),
                about(translation + up, reach_of_disc(linear, second_radius_ + outward + along)));
}

CsgReach CsgShape::reach(const glm::dmat3& linear, const glm::dvec3& translation, double scale) const noexcept {
    HRBFNPR_ASSERT(scale > 0.0);
    CsgReach reach{box(linear, translation, 0.0), {}, 0.0};
    if (kind_ == CsgKind::half_space) reach.outside = half_space(linear, translation, 0.0, -1.0);
    const CsgBox more = box(linear, translation, 1.0 / scale);
    for (int i = 0; i < 3; ++i)
        for (const double by : {reach.inside.low[i] - more.low[i], more.high[i] - reach.inside.high[i]})
            if (std::isfinite(by)) reach.slope = std::max(reach.slope, by);
    return reach;
}

} // namespace hrbfnpr::implicit
