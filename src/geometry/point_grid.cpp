// SPDX-License-Identifier: MIT
#include "geometry/point_grid.h"

#include "base/long_array.h"

#include <bit>

namespace hrbfnpr::geometry {
namespace {} // namespace

PointGrid::PointGrid(const VecArray& points, double radius, const base::Progress& progress)
    : radius_(radius), begin_(points.memory()), index_(points.memory()), cell_(points.memory()) {
    index_.resize_for_overwrite(points.size());
    cell_.resize_for_overwrite(points.size());
    Bounds box;
    for (std::int64_t i = 0; i < points.size(); ++i) box.extend(points[i]);
    if (points.empty()) box = {glm::dvec3(0.0), glm::dvec3(0.0)};
    // There are at most 2^21 cells per axis. Points beyond them share the last cells, which is slow but correct.
    grid_ = {box.min, std::max(2.0 * radius, 1e-6 * box.diagonal())};
    const auto buckets =
        static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(std::max<std::int64_t>(points.size(), 1))));
    base::resize_long(begin_, buckets + 1, progress);
    base::Array<std::uint64_t> cells(points.memory()); // the cell of each given point
    cells.resize_for_overwrite(points.size());
    // The counting sort keeps the order of the points within a bucket.
    for (const std::int64_t i : progress.over(points.size())) {
        cells[i] = CellGrid::pack(grid_.cell_of(points[i]));
        ++begin_[bucket(cells[i]) + 1];
    }
    progress.check();
    for (std::int64_t b = 0; b < buckets; ++b) begin_[b + 1] += begin_[b];
    progress.check();
    base::Array<std::int64_t> next(points.memory());
    next.resize_for_overwrite(buckets);
    for (std::int64_t b = 0; b < buckets; ++b) next[b] = begin_[b];
    for (const std::int64_t i : progress.over(points.size())) {
        const std::int64_t at = next[bucket(cells[i])]++;
        index_[at] = i;
        cell_[at] = cells[i];
    }
}

VecArray PointGrid::in_order(const VecArray& values, const base::Progress& progress) const {
    VecArray sorted(values.memory());
    for (base::Array<double>* const part : {&sorted.x, &sorted.y, &sorted.z}) part->resize_for_overwrite(size());
    for (const std::int64_t at : progress.over(size())) {
        sorted.set(at, values[index_[at]]);
    }
    return sorted;
}

} // namespace hrbfnpr::geometry
