// SPDX-License-Identifier: MIT
// Where g changes its sign between two places of the surface: there is a zero between them whatever Newton's steps do.
#pragma once

#include "curves/curve_points.h"

namespace hrbfnpr::curves {

// Places on the surface near each other: g < 0 at one, >= 0 at the other.
struct Straddle {
    glm::dvec3 negative, positive;
};

// By halving, on the surface: each point is within 2^-halvings of the places' distance of a zero of g.  Returns how
// many evaluations it took.
std::int64_t halve(const base::Runtime& runtime, const Level& level, const base::Array<Straddle>& places, int halvings,
                   base::Array<CurvePoint>& points, const base::Progress& progress);

// A step towards f = 0 along grad f.
inline void step_to_surface(CurvePoint& p) noexcept {
    p.position -= p.value / glm::dot(p.gradient, p.gradient) * p.gradient;
}

} // namespace hrbfnpr::curves
