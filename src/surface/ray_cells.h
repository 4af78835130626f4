// SPDX-License-Identifier: MIT
// Divides the search region of a prepared fit into cubes for casting many rays. A cube either contains no part of
// f = 0, or it has a bound on the second derivatives of f, which says how far a ray can go without a root.
#pragma once

#include "base/work.h"
#include "implicit/hrbf.h"
#include "implicit/prepared.h"

#include <array>

namespace hrbfnpr::surface {

class RayCells {
public:
    enum class Kind : std::uint8_t { outside, inside, crossed }; // f > 0 everywhere, f < 0 everywhere, or unknown

    struct Cell {
        double bend = 0.0;            // a bound on the second derivative along any line in the cell
        std::int32_t first_child = 0; // eight consecutive cells; 0: the cell is not divided
        Kind kind = Kind::crossed;
    };

    // A straight line in the region's coordinates. The direction is a unit vector.
    struct Line {
        glm::dvec3 start;
        glm::dvec3 direction;
        glm::dvec3 inverse; // 1 / direction
        glm::dvec3 nudge;   // a short way along each axis, in the sense of the direction
    };

    // The part of a line that lies in one cell.
    struct Part {
        const Cell* cell;
        double end; // the distance from the start of the line at which it leaves the cell
    };

    // Returns whether making cells and preparing the fit take less time than they save for this number of rays.
    [[nodiscard]] static bool pay(const implicit::HrbfData& data, std::int64_t rays) noexcept;

    // The object keeps references to `prepared` and `data`. Throws Error{out_of_memory, cancelled}.
    RayCells(const base::Work& work, const implicit::Prepared& prepared, const implicit::HrbfData& data);

    [[nodiscard]] const implicit::Prepared& prepared() const noexcept { return prepared_; }
    [[nodiscard]] const implicit::HrbfData& data() const noexcept { return data_; }
    [[nodiscard]] Line line(const glm::dvec3& start, const glm::dvec3& direction) const noexcept;
    // Returns the part of the line after the distance `from` from its start. The place must be in the region.
    [[nodiscard]] Part part(const Line& line, double from) const noexcept;
    // Returns an estimate of f's Lipschitz constant in the region, like lipschitz_estimate().
    [[nodiscard]] double lipschitz() const noexcept { return lipschitz_; }
    [[nodiscard]] const base::Array<Cell>& cells() const noexcept { return cells_; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return cells_.bytes(); }

private:
    class Builder;

    // A cell, and its place in the grid of its level.
    struct Found {
        std::int64_t cell;
        std::array<std::int32_t, 3> place;
        double width;
    };
    // Returns the smallest cell that contains a place, given in the region's coordinates.
    [[nodiscard]] Found find(const glm::dvec3& place) const noexcept;

    const implicit::Prepared& prepared_;
    const implicit::HrbfData& data_;
    glm::dvec3 corner_{0.0};             // the corner of the region with the lowest coordinates
    double width_ = 1.0;                 // width of the largest cells
    std::array<std::int32_t, 3> side_{}; // number of the largest cells along each axis
    base::Array<Cell> cells_;            // the largest cells come first
    double lipschitz_ = 0.0;
};

} // namespace hrbfnpr::surface
