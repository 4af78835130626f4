// SPDX-License-Identifier: MIT
// Whether a curve passes by a place.
#pragma once

#include "base/runtime.h"
#include "curves/curves.h"
#include "geometry/point_grid.h"

#include <cmath>

namespace hrbfnpr::curves {

class NearCurves {
public:
    // Of curves whose pieces are no longer than `longest`, up to the distance `farthest`; they must outlive it.
    NearCurves(base::Memory& memory, const Curves& curves, double longest, double farthest);

    // A place of a cubic.
    struct Foot {
        glm::dvec3 place{0.0};
        double distance = HUGE_VAL;
    };
    // The nearest of curves that run the way `along`.
    [[nodiscard]] Foot nearest(const glm::dvec3& place, const glm::dvec3& along) const;
    // One of them that is not `but`, within this distance of the place; -1: none is.
    [[nodiscard]] std::int64_t passing(const glm::dvec3& place, const glm::dvec3& along, double distance,
                                       std::int64_t but = -1) const;
    // The point beside which one passes; -1: none does.  Those beside `guess` are tried first: for places that follow
    // each other.
    [[nodiscard]] std::int64_t point_by(const glm::dvec3& place, const glm::dvec3& along, double distance,
                                        std::int64_t guess) const;

private:
    [[nodiscard]] bool passes(std::int64_t point, const glm::dvec3& place, const glm::dvec3& along,
                              double distance) const noexcept {
        return glm::dot(curves_.point[point].direction(), along) >= 0.0 &&
               foot_beside(point, place, distance).distance <= distance;
    }
    [[nodiscard]] Foot foot_beside(std::int64_t point, const glm::dvec3& place, double within) const noexcept;

    const Curves& curves_;
    base::Array<std::int32_t> curve_; // of each point
    geometry::PointGrid grid_;
};

} // namespace hrbfnpr::curves
