// SPDX-License-Identifier: MIT
// Points sorted into the cells of a grid, for queries with many small balls of the same radius. A tree is slow for such
// queries.
#pragma once

#include "base/operation.h"
#include "geometry/cell_grid.h"
#include "geometry/vec_array.h"

namespace hrbfnpr::geometry {

class PointGrid {
public:
    // `radius` is the radius of all later queries.
    PointGrid(const VecArray& points, double radius, const base::Progress& progress = {});

    [[nodiscard]] std::int64_t size() const noexcept { return index_.size(); }
    [[nodiscard]] std::int64_t bytes() const noexcept { return begin_.bytes() + index_.bytes() + cell_.bytes(); }
    // Returns the original index of the point at position `at` of the grid's order.
    [[nodiscard]] std::int64_t index(std::int64_t at) const noexcept { return index_[at]; }
    // Returns `values` in the grid's order, so that values that are visited together are close in memory.
    [[nodiscard]] VecArray in_order(const VecArray& values, const base::Progress& progress = {}) const;

    // Calls visit(at) once for every point within the radius of p, or of some place in a box, and for some points
    // farther away. The order in which two points are visited does not depend on p or on the box.
    template <class Visit>
    void around(const glm::dvec3& p, Visit&& visit) const {
        around(Bounds{p, p}, visit);
    }
    template <class Visit>
    void around(const Bounds& box, Visit&& visit) const;
    [[nodiscard]] bool any_around(const glm::dvec3& p) const {
        bool any = false;
        around(p, [&](std::int64_t) { any = true; });
        return any;
    }

private:
    [[nodiscard]] std::int64_t bucket(std::uint64_t cell) const noexcept {
        return static_cast<std::int64_t>(hash_bits(cell) & static_cast<std::uint64_t>(begin_.size() - 2));
    }

    double radius_;
    CellGrid grid_; // cells are two radii wide, so a ball meets at most eight
    // Where each bucket begins in the order, and the end; the size is a power of two plus 1.
    base::Array<std::int64_t> begin_;
    base::Array<std::int64_t> index_;
    base::Array<std::uint64_t> cell_; // the cell of each point in the order; needed because cells may share a bucket
};

template <class Visit>
void PointGrid::around(const Bounds& box, Visit&& visit) const {
    const CellGrid::Cell low = grid_.cell_of(box.min - radius_);
    const CellGrid::Cell high = grid_.cell_of(box.max + radius_);
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
        for (std::int64_t y = low[1]; y <= high[1]; ++y)
            for (std::int64_t x = low[0]; x <= high[0]; ++x) {
                const std::uint64_t cell = CellGrid::pack({x, y, z});
                const std::int64_t b = bucket(cell);
                for (std::int64_t at = begin_[b]; at < begin_[b + 1]; ++at)
                    if (cell_[at] == cell) visit(at);
            }
}

} // namespace hrbfnpr::geometry
