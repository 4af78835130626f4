// SPDX-License-Identifier: MIT
// What a feature line is the zero line of, at one point, and how strong the line is there.
#pragma once

#include "features/shape.h"

#include <cstdint>

namespace hrbfnpr::curves {

enum class FeatureKind : std::uint8_t {
    suggestive_contour, // [DeCarlo et al. 2003]
    ridge,              // convex; [Ohtake, Belyaev & Seidel 2004]
    valley,
    apparent_ridge, // [Judd, Durand & Adelson 2007]
    parabolic,      // K = 0
    isophote,       // n . l = level
    section,        // plane . p = level
    level           // a function of the caller = level
};

[[nodiscard]] constexpr bool depends_on_view(FeatureKind kind) noexcept {
    return kind == FeatureKind::suggestive_contour || kind == FeatureKind::apparent_ridge ||
           kind == FeatureKind::isophote;
}
// Whether g changes its sign with that of a principal direction.
[[nodiscard]] constexpr bool is_directed(FeatureKind kind) noexcept {
    return kind == FeatureKind::ridge || kind == FeatureKind::valley || kind == FeatureKind::apparent_ridge;
}
// Whether g comes from curvatures.
[[nodiscard]] constexpr bool needs_shape(FeatureKind kind) noexcept {
    return kind != FeatureKind::section && kind != FeatureKind::level;
}

struct FeatureValue {
    double g = 1.0;
    double strength = -1.0;   // without a unit; not positive: no line here, whatever g is
    double facing = 1.0;      // view-dependent kinds: n . v, v the direction to the eye or light; else 1
    glm::dvec3 along{0.0};    // directed kinds: the unit direction that g is a derivative along; both have one sign
    glm::dvec3 gradient{0.0}; // of g along the surface, where derivatives up to the third give it; else 0
};

// `towards`: the eye or the light, a place (w = 1) or the direction to it (w = 0).
// `unit`: the length that makes strengths pure numbers, the model's diagonal.
// Not for sections and levels of a caller's function.
//
//   kind                 g                                      strength
//   suggestive_contour   radial curvature times sin^2           its derivative towards the eye, times sin, unit^2
//   ridge, valley        C(d, d, d) of the larger curvature     (|k| - |k'|) unit; of a ridge k < 0
//   apparent_ridge       derivative of q1^2 along t1            q1 unit
//   parabolic            k1 k2 unit^2                           |grad K| unit^3
//   isophote             n . l                                  |grad (n . l)| unit
//
// sin is that of the angle between the normal and the view: without it the first strength grows without bound where
// the surface faces the eye.  It is that of the side that `towards` looks at also where that is the inside.  Whether a
// ridge is one, and not a line of least curvature, is for the caller to see.
[[nodiscard]] FeatureValue feature_value(FeatureKind kind, const ShapePoint& shape, const glm::dvec3& position,
                                         const glm::dvec4& towards, double unit) noexcept;

} // namespace hrbfnpr::curves
