// SPDX-License-Identifier: MIT
#include "marks/assemble.h"

#include "base/long_array.h"
#include "base/random.h"
#include "geometry/cell_set.h"
#include "geometry/point_grid.h"
#include "geometry/point_tree.h"
#include "geometry/tangent_frame.h"
#include "marks/tuning.h"
#include "surface/creased.h"
#include "surface/curvature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::marks {
namespace {

void resize(Layer& layer, std::int64_t count, bool with_curvature, bool with_width, const base::Progress& progress) {
    base::resize_long(layer.position, 3 * count, progress);
    base::resize_long(layer.normal, 3 * count, progress);
    base::resize_long(layer.direction, 3 * count, progress);
    if (with_curvature) base::resize_long(layer.curvature, 3 * count, progress);
    base::resize_long(layer.rank, count, progress);
    base::resize_long(layer.level, count, progress);
    base::resize_long(layer.stroke, 2 * count, progress);
    if (with_width) base::resize_long(layer.width, count, progress);
}

void compute_curvature(const Site& site, const Marks& marks, base::Array<float>& result,
                       const base::Progress& progress) {
    geometry::VecArray points(site.memory());
    base::Array<surface::Curvature> curvature(site.memory());
    const auto all = static_cast<double>(marks.count());
    for (std::int64_t begin = 0; begin < marks.count(); begin += chunk_size) {
        const std::int64_t end = std::min(marks.count(), begin + chunk_size);
        points.clear();
        for (std::int64_t i = begin; i < end; ++i) points.push_back(marks.position[i]);
        surface::principal_curvatures(site.runtime, site.implicit, points, curvature,
                                      progress.part(static_cast<double>(begin) / all, static_cast<double>(end) / all));
        for (std::int64_t i = begin; i < end; ++i) {
            const surface::Curvature& c = curvature[i - begin];
            set_vector(result, i, {held_curvature(c.k1), held_curvature(c.k2), c.confidence});
        }
    }
}

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

float random_rank(std::uint64_t random_seed, std::uint64_t key, Kind kind) noexcept {
    return rank_of(base::uniform4(random_seed, key, base::Purpose::rank, stream_of(kind))[0]);
}

void assemble(const Site& site, const Marks& marks, const AssembleSettings& settings, const glm::dvec3& origin,
              Layer& result, const base::Progress& progress) {
    const std::int64_t count = marks.count();
    HRBFNPR_ASSERT(marks.normal.size() == count && marks.key.size() == count && marks.level.size() == count);
    HRBFNPR_ASSERT(marks.stroke.size() == count && marks.place.size() == count);
    HRBFNPR_ASSERT(!settings.strokes || marks.direction.size() == count);
    resize(result, count, settings.with_curvature, !marks.width.empty(), progress);
    for (std::int64_t i = 0; i < count; ++i) {
        if (i % 16384 == 0) progress.check();
        const glm::dvec3 n = marks.normal[i];
        set_vector(result.position, i, marks.position[i] - origin);
        set_vector(result.normal, i, n);
        set_vector(result.direction, i, settings.strokes ? marks.direction[i] : geometry::stipple_frame(n).u);
        // Rank 1 first: a mark is shown where its rank is at least tau.
        const float own = !marks.rank.empty() ? marks.rank[i]
                          : result.progressive
                              ? rank_of(1.0 - (static_cast<double>(i) + 0.5) / static_cast<double>(count))
                              : random_rank(site.random_seed, marks.key[i], result.kind);
        result.rank[i] = settings.part[settings.strokes ? marks.stroke[i] & 1U : 0U].rank(own);
        if (!marks.width.empty()) result.width[i] = marks.width[i];
        result.level[i] = marks.level[i];
        result.stroke[2 * i] = settings.strokes ? marks.stroke[i] : 2 * marks.stroke[i];
        result.stroke[2 * i + 1] = static_cast<std::uint32_t>(marks.place[i]);
        if (!marks.curvature.empty())
            for (std::size_t k = 0; k < 3; ++k)
                result.curvature[3 * i + static_cast<std::int64_t>(k)] = marks.curvature[i][k];
    }
    if (settings.with_curvature && marks.curvature.empty()) compute_curvature(site, marks, result.curvature, progress);
    if (settings.strokes) index_strokes(result, progress);
    progress.update(1.0);
}

void measure(const base::Runtime& runtime, std::span<const geometry::VecArray* const> positions, double area,
             PointSet& set, const base::Progress& progress) {
    HRBFNPR_ASSERT(!positions.empty());
    const geometry::VecArray* largest = positions.front();
    for (const geometry::VecArray* layer : positions) {
        if (layer->size() > largest->size()) largest = layer;
        for (std::int64_t i = 0; i < layer->size(); ++i) set.bounds.extend((*layer)[i]);
    }
    if (set.bounds.empty()) return; // no mark: an origin or a spacing would be 0 / 0
    set.origin = set.bounds.centre();
    set.spacing = area > 0.0 ? std::sqrt(area / static_cast<double>(largest->size()))
                             : covered_spacing(runtime, *largest, progress);
}

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
// that many marks on average is used; a part of the cells that the surface cuts only at a
// corner hold none then, which the factor 1.25 in place of 1.5 allows for (measured: tests).
double covered_spacing(const base::Runtime& runtime, const geometry::VecArray& points, const base::Progress& progress) {
    const auto count = static_cast<double>(points.size());
    // The mean distance to the nearest other one of few, evenly spread marks is 0.87 of it.
    if (points.size() < marks_tuning.fewest_for_cells)
        return 1.15 * neighbour_distances(runtime, points, progress).mean;
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
        if (count < marks_tuning.marks_a_cell * cells) break;
        area = cells * side * side / 1.25;
    }
    return std::sqrt(area / count);
}

void soften_normals(const Site& site, const Marks& marks, double length, double spacing, base::Array<float>& result,
                    const base::Progress& progress) {
    HRBFNPR_ASSERT(length > 0.0 && spacing > 0.0);
    const double radius = marks_tuning.tone_reach * length;
    const double within = std::numbers::pi * radius * radius / (spacing * spacing);
    const auto each = static_cast<std::int64_t>(std::clamp(within / marks_tuning.tone_marks, 1.0, 1e6));
    const base::Array<std::int32_t> sheet =
        surface::sheets_at(site.runtime, site.implicit, marks.position, progress.part(0.0, 0.0));
    geometry::VecArray some(site.memory()); // the marks that are averaged
    geometry::VecArray some_normals(site.memory());
    for (std::int64_t i = 0; i < marks.count(); i += each) {
        some.push_back(marks.position[i]);
        some_normals.push_back(marks.normal[i]);
    }
    const geometry::PointGrid grid(some, radius, progress);
    const geometry::VecArray position = grid.in_order(some, progress);
    const geometry::VecArray normal = grid.in_order(some_normals, progress);
    // The mark's own normal counts once, so that there is always one. Most places are too far away: that is asked
    // first.
    const auto averaged = [&](std::int64_t i) {
        const glm::dvec3 place = marks.position[i];
        const glm::dvec3 own = marks.normal[i];
        glm::dvec3 sum = own;
        grid.around(place, [&](std::int64_t at) {
            const glm::dvec3 way = position[at] - place;
            const double square = glm::dot(way, way);
            if (!(square < radius * radius)) return;
            const double agree = glm::dot(own, normal[at]);
            const double height = glm::dot(way, own);
            const double steepest = marks_tuning.tone_steepest;
            if (!(agree > 0.0) || height * height > steepest * steepest * square) return;
            if (!sheet.empty() && surface::is_creased(sheet[i], sheet[grid.index(at) * each], own, normal[at])) return;
            const double near = 1.0 - square / (radius * radius);
            sum += near * near * agree * normal[at];
        });
        return glm::normalize(sum);
    };
    result.resize(3 * marks.count());
    site.runtime.parallel.for_chunks(marks.count(), chunk_size, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            if ((i - begin) % 256 == 0) progress.check();
            set_vector(result, i, averaged(i));
        }
    });
}

} // namespace hrbfnpr::marks
