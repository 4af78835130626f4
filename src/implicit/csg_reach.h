// SPDX-License-Identifier: MIT
// How far a solid and what is outside of it reach, and how steep f is: bounds that are known without evaluating it.
#pragma once

#include "implicit/csg_shapes.h"

#include <utility>

namespace hrbfnpr::implicit {

struct CsgReach {
    CsgBox inside;      // {f <= 0} is in it
    CsgBox outside;     // {f >= 0} is
    double slope = 1.0; // {f <= level} is in `inside` grown by this times a level above 0, {f >= -level} likewise

    [[nodiscard]] CsgReach turned() const noexcept { return {outside, inside, slope}; }
    // Of f + add.
    [[nodiscard]] CsgReach shifted(double add) const noexcept {
        CsgReach reach = *this;
        (add < 0.0 ? reach.inside : reach.outside) = (add < 0.0 ? inside : outside).grown(slope * std::abs(add));
        return reach;
    }
    // Where f = 0 may be.
    [[nodiscard]] CsgBox surface() const noexcept { return common(inside, outside); }
};

[[nodiscard]] inline CsgReach reach_of(const CsgShape& shape, const glm::dmat3& linear, const glm::dvec3& translation,
                                       double scale) noexcept {
    CsgReach reach{shape.box(linear, translation, 0.0), shape.box_outside(linear, translation, 0.0), 0.0};
    const CsgBox more = shape.box(linear, translation, 1.0 / scale);
    for (int i = 0; i < 3; ++i)
        for (const double by : {reach.inside.low[i] - more.low[i], more.high[i] - reach.inside.high[i]})
            if (std::isfinite(by)) reach.slope = std::max(reach.slope, by);
    return reach;
}

// Beyond the lower of two a blend adds something only where both are within its radius.
[[nodiscard]] inline CsgReach reach_of_minimum(const CsgReach& a, const CsgReach& b, const Blend& blend) noexcept {
    CsgReach reach{hull(a.inside, b.inside), common(a.outside, b.outside), std::max(a.slope, b.slope)};
    if (blend.radius == 0.0) return reach;
    const double deep = blend.depth();
    const CsgBox both =
        common(a.inside.grown(a.slope * (blend.radius + deep)), b.inside.grown(b.slope * (blend.radius + deep)));
    const CsgBox added = common(both, reach.inside.grown(reach.slope * deep));
    if (!added.empty()) reach.inside = hull(reach.inside, added);
    return reach;
}

[[nodiscard]] inline CsgReach reach_of_maximum(const CsgReach& a, const CsgReach& b, const Blend& blend) noexcept {
    return reach_of_minimum(a.turned(), b.turned(), blend).turned();
}

} // namespace hrbfnpr::implicit
