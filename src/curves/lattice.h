// SPDX-License-Identifier: MIT
// A region cut into equal cells that fill it, so that no function is asked beyond it.
#pragma once

#include "geometry/cell_grid.h"

namespace hrbfnpr::curves {

struct Lattice {
    using Cell = geometry::CellGrid::Cell;

    // Sides are at most as long as asked.
    Lattice(const geometry::Bounds& whole, double longest_side) noexcept : region(whole) {
        for (int axis = 0; axis < 3; ++axis) {
            const double wanted = std::ceil(whole.size()[axis] / longest_side);
            const std::int64_t count = std::max<std::int64_t>(1, geometry::whole(wanted, geometry::CellGrid::most));
            cells[static_cast<std::size_t>(axis)] = count;
            side[axis] = whole.size()[axis] / static_cast<double>(count);
        }
    }

    // Whether corners can be numbered, and cells have a volume.
    [[nodiscard]] bool valid() const noexcept {
        return glm::all(glm::greaterThan(side, glm::dvec3(0.0))) &&
               std::all_of(cells.begin(), cells.end(), [](auto n) { return n < geometry::CellGrid::most - 1; });
    }
    [[nodiscard]] bool inside(const Cell& cell) const noexcept {
        return cell[0] >= 0 && cell[0] < cells[0] && cell[1] >= 0 && cell[1] < cells[1] && cell[2] >= 0 &&
               cell[2] < cells[2];
    }
    [[nodiscard]] Cell cell_of(const glm::dvec3& p) const noexcept {
        const glm::dvec3 at = (p - region.min) / side;
        return {geometry::whole(at.x, cells[0] - 1), geometry::whole(at.y, cells[1] - 1),
                geometry::whole(at.z, cells[2] - 1)};
    }
    [[nodiscard]] glm::dvec3 corner(const Cell& at) const noexcept {
        const glm::dvec3 p = region.min + side * glm::dvec3(static_cast<double>(at[0]), static_cast<double>(at[1]),
                                                            static_cast<double>(at[2]));
        return glm::min(p, region.max);
    }
    // Of a corner: which coordinates are on the region's faces.
    [[nodiscard]] bool on_face(const Cell& at, int axis) const noexcept {
        const auto k = static_cast<std::size_t>(axis);
        return at[k] == 0 || at[k] == cells[k];
    }

    geometry::Bounds region;
    glm::dvec3 side{0.0};
    Cell cells{}; // along each axis
};

} // namespace hrbfnpr::curves
