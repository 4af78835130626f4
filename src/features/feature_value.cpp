// SPDX-License-Identifier: MIT
#include "features/feature_value.h"

#include "surface/curvature.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// The direction v to the eye: unit, in the tangent basis and along the normal.
struct LookedFrom {
    glm::dvec2 w;
    double facing;   // n . v
    double nearness; // 1 / distance; 0: infinitely far

    LookedFrom(const ShapePoint& shape, const glm::dvec3& position, const glm::dvec4& towards) noexcept {
        const glm::dvec3 v = glm::dvec3(towards) - towards.w * position;
        const double length = glm::length(v);
        const double inverse = length > 0.0 ? 1.0 / length : 0.0;
        w = shape.in_tangent(inverse * v);
        facing = glm::dot(shape.normal, inverse * v);
        nearness = std::abs(towards.w) * inverse;
    }
    // The derivative of w along the surface, a symmetric map: D_u n = -bend(u), and v turns by
    // -(u - v (v . u)) / distance.
    [[nodiscard]] glm::dvec2 turn(const ShapePoint& shape, const glm::dvec2& u) const noexcept {
        return facing * shape.bend(u) - nearness * (u - glm::dot(w, u) * w);
    }
    [[nodiscard]] glm::dvec2 gradient_of_facing(const ShapePoint& shape) const noexcept {
        return nearness * facing * w - shape.bend(w);
    }
};

// With B = -II, so that a ball has B > 0, the line is B(w, w) = 0 where D_w (B(w, w)) > 0; there
//   D_w (B(w, w)) = -C(w, w, w) - 2 (n . v) |B w|^2   [DeCarlo 2003, appendix].
FeatureValue suggestive(const ShapePoint& shape, const LookedFrom& view, double unit) noexcept {
    const glm::dvec2 bent = shape.bend(view.w);
    const double sine2 = glm::dot(view.w, view.w);
    const double rise = -glm::dot(shape.change(view.w, view.w), view.w) - 2.0 * view.facing * glm::dot(bent, bent);
    FeatureValue value;
    value.g = -glm::dot(bent, view.w);
    value.strength = sine2 > 1e-12 ? rise / sine2 * unit * unit : 0.0;
    value.facing = view.facing;
    value.gradient = shape.in_space(-shape.change(view.w, view.w) - 2.0 * view.turn(shape, bent));
    return value;
}

// Both signs of curvature have their own direction: where |k1| = |k2| nothing changes over.
FeatureValue crest(const ShapePoint& shape, bool convex, double unit) noexcept {
    FeatureValue value;
    value.along = convex ? shape.d2() : shape.d1;
    value.g = convex ? shape.c[3] : shape.c[0];
    value.strength = (convex ? -shape.k2 - std::abs(shape.k1) : shape.k1 - std::abs(shape.k2)) * unit;
    return value;
}

// What the normal turns by along a unit of the image is Q = II P^-1, where P takes tangent vectors to the image plane
// through the point.  P shortens w by n . v, so that P^-1 P^-T = M = I + w w^T / (n . v)^2.  q1^2 is the larger
// eigenvalue of Q Q^T = II M II, with x its eigenvector; t1 = Q^T x / q1 stands on the surface at s = M II x / q1.
//   D_s q1^2 = 2 q1 C(x, s, s) + y^T (D_s M) y,     y = II x
FeatureValue apparent_ridge(const ShapePoint& shape, const LookedFrom& view, double unit) noexcept {
    FeatureValue value;
    value.facing = view.facing;
    const double facing = std::copysign(std::max(std::abs(view.facing), 1e-6), view.facing);
    const double inverse = 1.0 / facing;
    const glm::dvec2 m = inverse * view.w; // M = I + m m^T
    const glm::dvec2 bm = shape.bend(m);
    const surface::Eigen2 eigen =
        surface::symmetric_eigen2(shape.k1 * shape.k1 + bm.x * bm.x, bm.x * bm.y, shape.k2 * shape.k2 + bm.y * bm.y);
    const glm::dvec2 x(eigen.cosine, eigen.sine);
    const glm::dvec2 y = shape.bend(x);
    const glm::dvec2 qs = y + glm::dot(m, y) * m; // q1 s
    const double length = glm::length(qs);
    if (!(length > 0.0)) return value;
    const glm::dvec2 s = qs / length;
    const double facing_change = glm::dot(view.gradient_of_facing(shape), s);
    const glm::dvec2 m_change = inverse * (view.turn(shape, s) - facing_change * m);
    value.g = 2.0 * (glm::dot(shape.change(x, s), qs) + glm::dot(y, m_change) * glm::dot(y, m));
    value.g *= std::abs(facing * facing * facing); // of the size of a curvature
    value.along = shape.in_space(s);
    value.strength = std::sqrt(eigen.high) * unit;
    return value;
}

FeatureValue parabolic(const ShapePoint& shape, double unit) noexcept {
    const glm::dvec2 gradient =
        shape.k2 * glm::dvec2(shape.c[0], shape.c[1]) + shape.k1 * glm::dvec2(shape.c[2], shape.c[3]);
    return {shape.k1 * shape.k2 * unit * unit, glm::length(gradient) * unit * unit * unit, 1.0, glm::dvec3(0.0),
            unit * unit * shape.in_space(gradient)};
}

} // namespace

FeatureValue feature_value(FeatureKind kind, const ShapePoint& shape, const glm::dvec3& position,
                           const glm::dvec4& towards, double unit) noexcept {
    if (shape.normal == glm::dvec3(0.0)) return {};
    switch (kind) {
    case FeatureKind::suggestive_contour: return suggestive(shape, LookedFrom(shape, position, towards), unit);
    case FeatureKind::ridge: return crest(shape, true, unit);
    case FeatureKind::valley: return crest(shape, false, unit);
    case FeatureKind::apparent_ridge: return apparent_ridge(shape, LookedFrom(shape, position, towards), unit);
    case FeatureKind::parabolic: return parabolic(shape, unit);
    case FeatureKind::isophote: {
        const LookedFrom view(shape, position, towards);
        const glm::dvec2 gradient = view.gradient_of_facing(shape);
        return {view.facing, glm::length(gradient) * unit, view.facing, glm::dvec3(0.0), shape.in_space(gradient)};
    }
    case FeatureKind::section:
    case FeatureKind::level: break;
    }
    return {};
}

} // namespace hrbfnpr::curves
