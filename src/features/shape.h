// SPDX-License-Identifier: MIT
// Curvatures of f = 0 and their derivatives at many points: measured once, then read for every view.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"
#include "implicit/shape_source.h"

#include <array>

namespace hrbfnpr::curves {

// Signs as in surface/curvature.h: k > 0 where the surface bends towards the normal grad f / |grad f|, so that a ball
// has k < 0.  All 0 where there is no gradient.
struct ShapePoint {
    glm::dvec3 normal{0.0};
    glm::dvec3 d1{0.0}; // of k1; that of k2 is d2()
    double k1 = 0.0;    // k1 >= k2
    double k2 = 0.0;
    std::array<double, 4> c{}; // C111 C112 C122 C222: derivatives of the second fundamental form

    [[nodiscard]] glm::dvec3 d2() const noexcept { return glm::cross(normal, d1); }
    // Tangent vectors in the basis d1, d2.
    [[nodiscard]] glm::dvec2 in_tangent(const glm::dvec3& v) const noexcept {
        return {glm::dot(v, d1), glm::dot(v, d2())};
    }
    [[nodiscard]] glm::dvec3 in_space(const glm::dvec2& t) const noexcept { return t.x * d1 + t.y * d2(); }
    // The second fundamental form, applied to one vector.
    [[nodiscard]] glm::dvec2 bend(const glm::dvec2& t) const noexcept { return {k1 * t.x, k2 * t.y}; }
    // C(u, v, .)
    [[nodiscard]] glm::dvec2 change(const glm::dvec2& u, const glm::dvec2& v) const noexcept {
        const double mixed = u.x * v.y + u.y * v.x;
        return {c[0] * u.x * v.x + c[1] * mixed + c[2] * u.y * v.y, c[1] * u.x * v.x + c[2] * mixed + c[3] * u.y * v.y};
    }
};

// Hessian xx xy xz yy yz zz; third xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz.
// Where k1 = k2 the directions are any, and C is in the same.
[[nodiscard]] ShapePoint shape_point(const glm::dvec3& gradient, const std::array<double, 6>& hessian,
                                     const std::array<double, 10>& third) noexcept;

// Of the points with these gradients of f; result is resized.  The same bits for any thread count.
void measure_shape(const base::Runtime& runtime, const implicit::ShapeSource& source,
                   const geometry::VecArray& position, const geometry::VecArray& gradient,
                   base::Array<ShapePoint>& result, const base::Progress& progress);

} // namespace hrbfnpr::curves
