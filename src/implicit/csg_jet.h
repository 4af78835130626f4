// SPDX-License-Identifier: MIT
// A value with its derivatives, and what blends make of two.
#pragma once

#include "geometry/vec.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::implicit {

// Hessian order: xx xy xz yy yz zz.
struct CsgJet {
    double value = 0.0;
    glm::dvec3 gradient{0.0};
    std::array<double, 6> hessian{};
};

// A function of two numbers a and b, with its derivatives.
struct BlendJet {
    double value = 0.0;
    double by_a = 0.0, by_b = 0.0;
    double by_aa = 0.0, by_ab = 0.0, by_bb = 0.0;
};

[[nodiscard]] inline BlendJet only_a(double a) noexcept { return {a, 1.0, 0.0, 0.0, 0.0, 0.0}; }
[[nodiscard]] inline BlendJet only_b(double b) noexcept { return {b, 0.0, 1.0, 0.0, 0.0, 0.0}; }
// NaN stays one.
[[nodiscard]] inline bool takes_lower(double a, double b) noexcept { return b < a || std::isnan(b); }

// min(a, b) - R/6 (1 - |a - b|/R)^3 where |a - b| < R: twice continuously differentiable, bounded as the blends of
// Barthe, Wyvill and de Groot ("Controllable binary CSG operators for soft objects", 2004) are.
[[nodiscard]] inline BlendJet polynomial_minimum(double a, double b, double radius) noexcept {
    const double u = a - b;
    if (std::abs(u) >= radius) return u < 0.0 ? only_a(a) : only_b(b);
    const double h = 1.0 - std::abs(u) / radius;
    const double slope = std::copysign(0.5 - 0.5 * h * h, u);
    const double bend = h / radius;
    return {std::min(a, b) - radius / 6.0 * h * h * h, 0.5 - slope, 0.5 + slope, -bend, bend, -bend};
}

// max(R, min(a, b)) - (A^p + B^p)^(1/p), A = max(0, R - a), B = max(0, R - b): Ricci's super-ellipse ("A constructive
// geometry for computer graphics", 1973) of densities that end at the distance R.
[[nodiscard]] inline BlendJet elliptic_minimum(double a, double b, double radius, double p) noexcept {
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

struct Blend {
    double radius = 0.0;
    double exponent = 0.0;

    [[nodiscard]] BlendJet minimum(double a, double b) const noexcept {
        return exponent == 0.0 ? polynomial_minimum(a, b, radius) : elliptic_minimum(a, b, radius, exponent);
    }
    [[nodiscard]] BlendJet maximum(double a, double b) const noexcept {
        const BlendJet m = minimum(-a, -b);
        return {-m.value, m.by_a, m.by_b, -m.by_aa, -m.by_ab, -m.by_bb};
    }
    // By how much of the radius it may pass the lower of two.
    [[nodiscard]] double depth() const noexcept {
        return radius * (exponent == 0.0 ? 1.0 / 6.0 : 1.0 - std::pow(0.5, 1.0 / exponent));
    }
    // What it may lengthen gradients by.
    [[nodiscard]] double steepness() const noexcept { return exponent == 0.0 ? 1.0 : std::pow(2.0, 1.0 / exponent); }
};

} // namespace hrbfnpr::implicit
