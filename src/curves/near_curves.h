// SPDX-License-Identifier: MIT
// Whether a curve passes by a place.
#pragma once

#include "base/runtime.h"
#include "curves/curves.h"
#include "geometry/point_grid.h"

namespace hrbfnpr::curves {

class NearCurves {
public:
    // Of curves whose pieces are no longer than `longest`, up to the distance `farthest`; they must outlive it.
    NearCurves(base::Memory& memory, const Curves& curves, double longest, double farthest);

    // A curve that runs the way `along` within this distance of the place, and is not `but`; -1: none does.
    [[nodiscard]] std::int64_t passing(const glm::dvec3& place, const glm::dvec3& along, double distance,
                                       std::int64_t but = -1) const;

private:
    [[nodiscard]] double distance_to(std::int64_t point, const glm::dvec3& place) const noexcept;

    const Curves& curves_;
    base::Array<std::int32_t> curve_; // of each point
    geometry::PointGrid grid_;
};

} // namespace hrbfnpr::curves
