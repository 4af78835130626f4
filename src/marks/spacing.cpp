// SPDX-License-Identifier: MIT
#include "marks/spacing.h"

#include "geometry/cell_set.h"
#include "geometry/point_tree.h"

#include <cmath>

namespace hrbfnpr::marks {
namespace {

// Fewer marks than this say little of an area by the cells they occupy.
constexpr std::int64_t fewest_for_cells = 512;
constexpr double marks_per_cell = 8.0;

std::int64_t occupied_cells(base::Memory& memory, const geometry::VecArray& points, const geometry::CellGrid& grid,
                            const base::Progress& progress) {
    geometry::CellSet cells(memory);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        if (i % 65536 == 0) progress.check();
        cells.insert(geometry::CellGrid::pack(grid.cell_of(points[i])));
    }
    return cells.size();
}

} // namespace

NeighbourDistances neighbour_distances(const base::Runtime& runtime, const geometry::VecArray& points,
                                       const base::Progress& progress) {
    const geometry::PointTree tree(points, progress);
    base::Array<double> distance(runtime.memory, points.size());
    runtime.parallel.for_chunks(points.size(), 1024, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t at = begin; at < end; ++at) distance[at] = tree.nearest_other(at);
    });
    // Points that coincide say nothing of the spacing of the others.
    const double smallest = 1e-9 * tree.bounds().diagonal();
    double sum = 0.0;
    double sum_of_squares = 0.0;
    std::int64_t used = 0;
    for (const double d : distance) {
        if (!(d > smallest) || !std::isfinite(d)) continue;
        sum += d;
        sum_of_squares += d * d;
        ++used;
    }
    if (used == 0) return {};
    const double mean = sum / static_cast<double>(used);
    const double variance = std::max(0.0, sum_of_squares / static_cast<double>(used) - mean * mean);
    return {mean, std::sqrt(variance) / mean};
}

// Cells of a grid of side h that a surface of area A meets: 1.5 A / h^2, the mean of
// |nx| + |ny| + |nz| over all normals being 1.5.  The finest grid whose occupied cells hold
// `marks_per_cell` marks on average is used; a part of the cells that the surface cuts only at a
// corner hold none then, which the factor 1.25 in place of 1.5 allows for (measured: tests).
double covered_spacing(const base::Runtime& runtime, const geometry::VecArray& points, const base::Progress& progress) {
    const auto count = static_cast<double>(points.size());
    // The mean distance to the nearest other one of few, evenly spread marks is 0.87 of it.
    if (points.size() < fewest_for_cells) return 1.15 * neighbour_distances(runtime, points, progress).mean;
    geometry::Bounds box;
    for (std::int64_t i = 0; i < points.size(); ++i) box.extend(points[i]);
    const glm::dvec3 size = box.size();
    const double longest = std::max({size.x, size.y, size.z});
    if (!(longest > 0.0)) return 0.0;
    double area = longest * longest;
    for (int level = 1; level < geometry::CellGrid::bits; ++level) {
        const double side = longest / static_cast<double>(std::int64_t{1} << level);
        // Half a cell off the box, so that a flat side of it does not lie between two layers of cells.
        const geometry::CellGrid grid{box.min - 0.5 * side, side};
        const auto cells = static_cast<double>(occupied_cells(runtime.memory, points, grid, progress));
        if (count < marks_per_cell * cells) break;
        area = cells * side * side / 1.25;
    }
    return std::sqrt(area / count);
}

} // namespace hrbfnpr::marks
