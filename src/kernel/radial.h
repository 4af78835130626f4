// SPDX-License-Identifier: MIT
// The kernels as inline functions. They are for loops in which the kernel does not change.
#pragma once

#include "kernel/kernel.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::kernel {

// A point counts as lying at a centre if its squared distance from the centre is at most this. The unit is the square
// of the mean sample spacing. At smaller distances r^-3 would overflow. Doubles cannot represent another point so close
// to a sample.
inline constexpr double at_centre = 1e-60;

// Each kernel has a member at<order>(r2, r) with r2 = r * r. It sets phi and a always, b if the order is at least 1,
// and c if the order is 2; the other members stay 0. It has no branches, so that loops over points can be vectorised.

struct Triharmonic {
    explicit constexpr Triharmonic(double /*radius*/) noexcept {}

    template <int order>
    [[nodiscard]] Radial at(double r2, double r) const noexcept {
        Radial result{r2 * r, 3.0 * r, 0.0, 0.0};
        const double inverse = r2 > at_centre ? 1.0 / r : 0.0;
        if constexpr (order >= 1) result.b = 3.0 * inverse;
        if constexpr (order >= 2) result.c = -3.0 * inverse * inverse * inverse;
        return result;
    }
};

struct Gaussian {
    explicit constexpr Gaussian(double radius) noexcept : falloff_(1.0 / (radius * radius)) {}

    template <int order>
    [[nodiscard]] Radial at(double r2, double /*r*/) const noexcept {
        const double phi = std::exp(-0.5 * falloff_ * r2);
        Radial result{phi, -falloff_ * phi, 0.0, 0.0};
        if constexpr (order >= 1) result.b = -falloff_ * result.a;
        if constexpr (order >= 2) result.c = -falloff_ * result.b;
        return result;
    }

private:
    double falloff_;
};

struct WendlandC2 {
    explicit constexpr WendlandC2(double radius) noexcept : inverse_radius_(1.0 / radius) {}

    template <int order>
    [[nodiscard]] Radial at(double r2, double r) const noexcept {
        const double s = r * inverse_radius_;
        const double t = std::max(0.0, 1.0 - s);
        const double t2 = t * t;
        const double falloff = 20.0 * inverse_radius_ * inverse_radius_;
        Radial result{t2 * t2 * (4.0 * s + 1.0), -falloff * (t2 * t), 0.0, 0.0};
        const double inverse = r2 > at_centre ? 1.0 / r : 0.0;
        const double cubic = 3.0 * falloff * inverse_radius_; // 60 / radius^3
        if constexpr (order >= 1) result.b = cubic * t2 * inverse;
        if constexpr (order >= 2) result.c = -cubic * t * (1.0 + s) * (inverse * inverse * inverse);
        return result;
    }

private:
    double inverse_radius_;
};

// Calls f(kernel) with an object of the kernel's class.
template <class F>
decltype(auto) with_kernel(Kind kind, double radius, F&& f) {
    switch (kind) {
    case Kind::gaussian: return f(Gaussian(radius));
    case Kind::wendland_c2: return f(WendlandC2(radius));
    case Kind::triharmonic: break;
    }
    return f(Triharmonic(radius));
}

} // namespace hrbfnpr::kernel
