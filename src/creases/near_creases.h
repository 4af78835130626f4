// SPDX-License-Identifier: MIT
// Whether places are on creases.
#pragma once

#include "creases/creases.h"
#include "geometry/point_grid.h"

#include <optional>

namespace hrbfnpr::curves {

class NearCreases {
public:
    // Of those whose angle is at least `least` degrees.  side: of the cells of their mesh.
    NearCreases(base::Memory& memory, const Creases& creases, double least, double side);

    // Whether one is no farther away than that, which half a side is the most of.
    [[nodiscard]] bool has(const glm::dvec3& place, double reach) const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept { return from_.bytes() + to_.bytes() + grid_->bytes(); }

private:
    double most_;
    geometry::VecArray from_, to_;            // pieces
    std::optional<geometry::PointGrid> grid_; // of their middles
};

} // namespace hrbfnpr::curves
