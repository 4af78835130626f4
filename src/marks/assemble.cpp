// SPDX-License-Identifier: MIT
#include "marks/assemble.h"

#include "marks/fields.h"

#include "base/format.h"
#include "base/long_array.h"
#include "base/random.h"
#include "geometry/cell_set.h"
#include "geometry/point_grid.h"
#include "geometry/point_tree.h"
#include "geometry/tangent_frame.h"
#include "geometry/unit.h"
#include "marks/normal_loops.h"
#include "marks/tuning.h"
#include "surface/creased.h"
#include "surface/curvature.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
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

void compute_curvature(const Site& site, const Marks& marks, base::Array<float>& result) {
    geometry::VecArray points(site.memory());
    base::Array<surface::Curvature> curvature(site.memory());
    const auto all = static_cast<double>(marks.count());
    for (std::int64_t begin = 0; begin < marks.count(); begin += chunk_size) {
        const std::int64_t end = std::min(marks.count(), begin + chunk_size);
        points.clear();
        for (std::int64_t i = begin; i < end; ++i) points.push_back(marks.position[i]);
        surface::principal_curvatures(site.work.part(static_cast<double>(begin) / all, static_cast<double>(end) / all),
                                      site.implicit, points, curvature);
        for (std::int64_t i = begin; i < end; ++i) {
            const surface::Curvature& c = curvature[i - begin];
            set_vector(result, i, {clamped_curvature(c.k1), clamped_curvature(c.k2), c.confidence});
        }
    }
}

std::int64_t occupied_cells(base::Memory& memory, const geometry::VecArray& points, const geometry::CellGrid& grid,
                            const base::Progress& progress) {
    geometry::CellSet cells(memory);
    for (const std::int64_t i : progress.over(points.size())) {
        cells.insert(geometry::CellGrid::pack(grid.cell_of(points[i])));
    }
    return cells.size();
}

// The marks whose normals are averaged: one of `each` marks, sorted into a grid.
class AveragedMarks {
public:
    AveragedMarks(const Site& site, const Marks& marks, const base::Array<std::int32_t>& sheets, std::int64_t each,
                  double radius)
        : radius_(radius), grid_(some(site, marks.position, each), radius, site.work),
          position_(grid_.in_order(some(site, marks.position, each), site.work)),
          normal_(grid_.in_order(some(site, marks.normal, each), site.work)), sheet_(site.memory()) {
        if (sheets.empty()) return;
        sheet_.resize_for_overwrite(grid_.size());
        for (const std::int64_t at : site.work.over(grid_.size())) {
            sheet_[at] = static_cast<double>(sheets[grid_.index(at) * each]);
        }
    }

    [[nodiscard]] PointsWithNormals points() const noexcept {
        return {position_.x.data(),
                position_.y.data(),
                position_.z.data(),
                normal_.x.data(),
                normal_.y.data(),
                normal_.z.data(),
                sheet_.empty() ? nullptr : sheet_.data()};
    }

    // Finds the marks in a box that is larger by the radius. Each mark is written, and kept if it is in the box,
    // because branches would be mispredicted.
    void find_around(const geometry::Bounds& box, base::Array<std::int32_t>& found) const {
        const glm::dvec3 centre = box.centre();
        const glm::dvec3 half = 0.5 * box.size() + radius_;
        found.resize_for_overwrite(std::max<std::int64_t>(found.size(), 1));
        std::int64_t count = 0;
        grid_.around(box, [&](std::int64_t at) {
            if (count == found.size()) found.resize(2 * count);
            found[count] = static_cast<std::int32_t>(at);
            const glm::dvec3 away = glm::abs(position_[at] - centre);
            count += static_cast<std::int64_t>(away.x <= half.x) & static_cast<std::int64_t>(away.y <= half.y) &
                     static_cast<std::int64_t>(away.z <= half.z);
        });
        found.resize(count);
    }

private:
    [[nodiscard]] static geometry::VecArray some(const Site& site, const geometry::VecArray& all, std::int64_t each) {
        geometry::VecArray some(site.memory());
        for (std::int64_t i = 0; i < all.size(); i += each) some.push_back(all[i]);
        return some;
    }

    double radius_;
    geometry::PointGrid grid_;
    geometry::VecArray position_, normal_;
    base::Array<double> sheet_; // empty if the surface is smooth
};

// Returns the sums for the marks begin to end - 1 with their own normals. Lanes without a mark repeat the first mark.
[[nodiscard]] NormalSums sums_for(const Marks& marks, const base::Array<std::int32_t>& sheet, std::int64_t begin,
                                  std::int64_t end) noexcept {
    NormalSums sums;
    for (std::int64_t lane = 0; lane < NormalSums::size; ++lane) {
        const std::int64_t i = begin + lane < end ? begin + lane : begin;
        const glm::dvec3 place = marks.position[i];
        const glm::dvec3 normal = marks.normal[i];
        sums.x[lane] = place.x;
        sums.y[lane] = place.y;
        sums.z[lane] = place.z;
        sums.nx[lane] = sums.sum_x[lane] = normal.x;
        sums.ny[lane] = sums.sum_y[lane] = normal.y;
        sums.nz[lane] = sums.sum_z[lane] = normal.z;
        sums.sheet[lane] = sheet.empty() ? 0.0 : static_cast<double>(sheet[i]);
    }
    return sums;
}

} // namespace

float random_rank(std::uint64_t random_seed, std::uint64_t key, Kind kind) noexcept {
    return rank_of(base::uniform4(random_seed, key, base::Purpose::rank, stream_of(kind))[0]);
}

void assemble(const Site& site, const Marks& marks, const AssembleSettings& settings, const glm::dvec3& origin,
              Layer& result) {
    const std::int64_t count = marks.count();
    HRBFNPR_ASSERT(marks.normal.size() == count && marks.key.size() == count && marks.level.size() == count);
    HRBFNPR_ASSERT(marks.stroke.size() == count && marks.place.size() == count);
    HRBFNPR_ASSERT(!settings.strokes || marks.direction.size() == count);
    resize(result, count, settings.with_curvature, !marks.width.empty(), site.work);
    for (const std::int64_t i : site.work.over(count)) {
        const glm::dvec3 n = marks.normal[i];
        set_vector(result.position, i, marks.position[i] - origin);
        set_vector(result.normal, i, n);
        set_vector(result.direction, i, settings.strokes ? marks.direction[i] : geometry::stipple_frame(n).u);
        // The first mark gets the highest rank, because a mark is shown if its rank is at least the tone.
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
    if (settings.with_curvature && marks.curvature.empty()) compute_curvature(site, marks, result.curvature);
    if (settings.strokes) index_strokes(result, site.work);
    site.work.update(1.0);
}

void measure(const base::Work& work, std::span<const geometry::VecArray* const> positions, double area,
             std::int64_t whole, PointSet& set) {
    HRBFNPR_ASSERT(!positions.empty());
    const geometry::VecArray* largest = positions.front();
    for (const geometry::VecArray* layer : positions) {
        if (layer->size() > largest->size()) largest = layer;
        for (std::int64_t i = 0; i < layer->size(); ++i) set.bounds.extend((*layer)[i]);
    }
    if (set.bounds.empty()) return; // without marks, the origin and the spacing would be 0 / 0
    set.origin = set.bounds.centre();
    set.spacing = area > 0.0 ? std::sqrt(area / static_cast<double>(whole)) : covered_spacing(work, *largest);
}

NeighbourDistances neighbour_distances(const base::Work& work, const geometry::VecArray& points) {
    const geometry::PointTree tree(points, work);
    base::Array<double> distance(work.memory, points.size());
    work.for_chunks(points.size(), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t at = begin; at < end; ++at) distance[at] = tree.nearest_other(at);
    });
    // Distances of 0 between coincident points are ignored, because they say nothing about the spacing on the surface.
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

// Estimates the spacing from the cells of a grid that hold points. A surface of area A passes through about 1.5 A / h^2
// cells of a grid of side h, because the mean of |nx| + |ny| + |nz| over all normals is 1.5. The function chooses the
// finest grid whose occupied cells hold marks_a_cell marks on average. Some cells that the surface cuts only at a
// corner hold no mark, so the factor is 1.25 instead of 1.5 (measured by tests).
double covered_spacing(const base::Work& work, const geometry::VecArray& points) {
    const auto count = static_cast<double>(points.size());
    // For few, evenly spread marks, the mean distance to the nearest other mark is 0.87 spacings.
    if (points.size() < marks_tuning.fewest_for_cells) return 1.15 * neighbour_distances(work, points).mean;
    geometry::Bounds box;
    for (std::int64_t i = 0; i < points.size(); ++i) box.extend(points[i]);
    const glm::dvec3 size = box.size();
    const double longest = std::max({size.x, size.y, size.z});
    if (!(longest > 0.0)) return 0.0;
    double area = longest * longest;
    for (int level = 1; level < geometry::CellGrid::bits; ++level) {
        const double side = longest / static_cast<double>(std::int64_t{1} << level);
        // The grid starts half a cell outside the box, so that a flat side of the box does not lie between two layers
        // of cells.
        const geometry::CellGrid grid{box.min - 0.5 * side, side};
        const auto cells = static_cast<double>(occupied_cells(work.memory, points, grid, work));
        if (count < marks_tuning.marks_a_cell * cells) break;
        area = cells * side * side / 1.25;
    }
    return std::sqrt(area / count);
}

// Consecutive marks are mostly on one stroke and near each other, so several of them are averaged together. Each mark's
// own normal is included once, so that there is at least one normal.
void average_normals(const Site& site, const Marks& marks, double length, double spacing, base::Array<float>& result) {
    HRBFNPR_ASSERT(length > 0.0 && spacing > 0.0);
    const double radius = marks_tuning.tone_reach * length;
    const double within = std::numbers::pi * radius * radius / (spacing * spacing);
    const auto each = static_cast<std::int64_t>(std::clamp(within / marks_tuning.tone_marks, 1.0, 1e6));
    const base::Array<std::int32_t> sheet = surface::sheets_at(site.work, site.implicit, marks.position);
    const AveragedMarks some(site, marks, sheet, each, radius);
    const NormalLimits limits{radius * radius, marks_tuning.tone_steepest * marks_tuning.tone_steepest,
                              surface::smooth_cosine};
    const NormalLoops loops = normal_loops(site.work.instruction_set);
    result.resize(3 * marks.count());
    site.work.for_chunks(marks.count(), chunk_size, [&](std::int64_t begin, std::int64_t end) {
        base::Array<std::int32_t> near(site.memory());
        for (std::int64_t i = begin, next = begin; i < end; i = next) {
            site.work.check();
            geometry::Bounds box;
            next = std::min(end, i + NormalSums::size);
            for (std::int64_t k = i; k < next; ++k) {
                if (glm::distance(marks.position[k], marks.position[i]) > radius && k > i)
                    next = k;
                else
                    box.extend(marks.position[k]);
            }
            NormalSums sums = sums_for(marks, sheet, i, next);
            some.find_around(box, near);
            loops.add_normals(some.points(), near.data(), near.size(), limits, sums);
            for (std::int64_t k = i; k < next; ++k) {
                const std::int64_t lane = k - i;
                set_vector(result, k, glm::normalize(glm::dvec3(sums.sum_x[lane], sums.sum_y[lane], sums.sum_z[lane])));
            }
        }
    });
}

// ---- Ready-made marks

namespace {

using base::InView;

long long as_long_long(std::int64_t i) noexcept { return static_cast<long long>(i); }

// Reads and checks the numbers of one layer. `place` is the layer's index in the list of layers.
class LayerReader {
public:
    LayerReader(const LayerArrays& arrays, std::int64_t place) noexcept : arrays_(arrays), place_(place) {}

    // Fails with the message "point_set_desc.layers[1].rank[3] is REASON"; `format` and its arguments give REASON.
    HRBFNPR_PRINTF_LIKE(4, 5)
    [[noreturn]] void refuse(const char* name, std::int64_t i, const char* format, ...) const {
        char why[160];
        std::va_list arguments;
        va_start(arguments, format);
        base::format_text(why, sizeof why, format, arguments);
        va_end(arguments);
        fail(Status::invalid_argument, "point_set_desc.layers[%lld].%s[%lld] is %s", as_long_long(place_), name,
             as_long_long(i), why);
    }

    void check_counts() const {
        const auto check = [&](const InView& view, const char* name, bool needed) {
            if (view.count == count() || (view.empty() && !needed)) return;
            fail(Status::invalid_argument,
                 "point_set_desc.layers[%lld].%s has %lld elements, but position has %lld; %s", as_long_long(place_),
                 name, as_long_long(view.count), as_long_long(count()),
                 needed ? "give one for each mark" : "give one for each mark, or none");
        };
        check(arrays_.normal, "normal", true);
        check(arrays_.direction, "direction", false);
        check(arrays_.curvature, "curvature", false);
        check(arrays_.rank, "rank", false);
        check(arrays_.level, "level", false);
        check(arrays_.width, "width", false);
        if (count() > most_marks)
            fail(Status::invalid_argument,
                 "point_set_desc.layers[%lld].position has %lld elements; at most %lld are allowed",
                 as_long_long(place_), as_long_long(count()), as_long_long(most_marks));
    }

    [[nodiscard]] std::int64_t count() const noexcept { return arrays_.position.count; }

    [[nodiscard]] glm::dvec3 vector(const InView& view, const char* name, std::int64_t i) const {
        glm::dvec3 v(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            v[axis] = view.get(i, static_cast<std::uint32_t>(axis));
            if (!std::isfinite(v[axis])) refuse(name, i, "not finite; every number must be");
            // A larger number would become infinite when stored as a float.
            if (std::abs(v[axis]) > 3.4e38) refuse(name, i, "%g, too large for a float; use a larger unit", v[axis]);
        }
        return v;
    }

    [[nodiscard]] glm::dvec3 normal(std::int64_t i) const {
        const glm::dvec3 given = vector(arrays_.normal, "normal", i);
        const glm::dvec3 size = glm::abs(given);
        // The normal is scaled so that its square is finite.
        const glm::dvec3 n = given / geometry::unit_for(std::max({size.x, size.y, size.z}));
        const double length = glm::length(n);
        if (!(length > 0.0) || !std::isfinite(length)) refuse("normal", i, "zero; every mark needs a normal");
        return n / length;
    }

    // Returns the tangent part of a stroke's direction, as a unit vector.
    [[nodiscard]] glm::dvec3 direction(std::int64_t i, const glm::dvec3& n) const {
        const glm::dvec3 tangent = tangent_part(vector(arrays_.direction, "direction", i), n);
        if (tangent == glm::dvec3(0.0)) refuse("direction", i, "zero or parallel to the normal; it must be tangent");
        return tangent;
    }

    [[nodiscard]] float rank(std::int64_t i) const {
        const double u = arrays_.rank.get(i, 0);
        if (!(u >= 0.0 && u <= 1.0)) refuse("rank", i, "not in [0,1); choose a number from 0 to below 1");
        return rank_of(u);
    }

    [[nodiscard]] float width(std::int64_t i) const {
        const double width = arrays_.width.get(i, 0);
        const auto rounded = static_cast<float>(width);
        if (!(rounded > 0.0F && width <= 1.0)) refuse("width", i, "not in (0,1]; choose a number above 0, up to 1");
        return rounded;
    }

    // Fills stroke_first and stroke of the layer.
    void read_strokes(Layer& layer) const;

private:
    [[nodiscard]] std::uint32_t direction_of_stroke(std::int64_t stroke) const {
        if (arrays_.stroke_direction.empty()) return 0;
        const auto direction = static_cast<std::uint32_t>(arrays_.stroke_direction.get(stroke, 0));
        if (direction > 1) refuse("stroke_direction", stroke, "%u; it must be 0 or 1", direction);
        return direction;
    }

    const LayerArrays& arrays_;
    std::int64_t place_;
};

void LayerReader::read_strokes(Layer& layer) const {
    const InView& first = arrays_.stroke_first;
    const std::int64_t strokes = first.empty() ? 0 : first.count - 1;
    for (std::int64_t s = 0; s < first.count; ++s) {
        const double now = first.get(s, 0);
        const bool rises = s == 0 ? now == 0.0 : now > first.get(s - 1, 0);
        const bool ends = s == strokes ? now == static_cast<double>(count()) : now < static_cast<double>(count());
        if (!rises || !ends)
            refuse("stroke_first", s, "%.0f; the numbers must increase from 0 to the number of marks, %lld", now,
                   as_long_long(count()));
        if (strokes > 0) layer.stroke_first.push_back(static_cast<std::uint32_t>(now));
    }
    const std::int64_t directions = arrays_.stroke_direction.count;
    if (!arrays_.stroke_direction.empty() && directions != strokes)
        fail(Status::invalid_argument,
             "point_set_desc.layers[%lld].stroke_direction has %lld elements, but stroke_first has %lld strokes; give "
             "one for each stroke, or none",
             as_long_long(place_), as_long_long(directions), as_long_long(strokes));
    layer.stroke.resize(2 * count());
    for (std::int64_t s = 0; s < strokes; ++s) {
        const std::uint32_t own = 2 * static_cast<std::uint32_t>(s) + direction_of_stroke(s);
        for (std::uint32_t i = layer.stroke_first[s]; i < layer.stroke_first[s + 1]; ++i) {
            layer.stroke[2 * std::int64_t{i}] = own;
            layer.stroke[2 * std::int64_t{i} + 1] = i - layer.stroke_first[s];
        }
    }
    for (std::int64_t i = 0; strokes == 0 && i < count(); ++i) layer.stroke[2 * i] = 2 * static_cast<std::uint32_t>(i);
}

// If no directions are given, sets the directions of marks along their strokes by central differences. A mark without a
// neighbour at another place keeps the direction of a stipple.
void set_directions_along(const geometry::VecArray& positions, const LayerReader& reader, Layer& layer) {
    for (std::int64_t s = 0; s < layer.strokes(); ++s) {
        const std::int64_t begin = layer.stroke_first[s];
        const std::int64_t last = std::int64_t{layer.stroke_first[s + 1]} - 1;
        for (std::int64_t i = begin; i <= last; ++i) {
            const glm::dvec3 way = positions[std::min(i + 1, last)] - positions[std::max(i - 1, begin)];
            const glm::dvec3 tangent = tangent_part(way, reader.normal(i));
            if (tangent != glm::dvec3(0.0)) set_vector(layer.direction, i, tangent);
        }
    }
}

// Reads all arrays of a layer. Returns the positions as given, and fills the other arrays of `layer`.
geometry::VecArray read_layer(base::Memory& memory, const LayerArrays& arrays, std::int64_t place,
                              std::uint64_t random_seed, Layer& layer) {
    const LayerReader reader(arrays, place);
    reader.check_counts();
    const std::int64_t count = reader.count();
    geometry::VecArray positions(memory, count);
    for (std::int64_t i = 0; i < count; ++i) positions.set(i, reader.vector(arrays.position, "position", i));
    reader.read_strokes(layer);
    layer.normal.resize(3 * count);
    layer.direction.resize(3 * count);
    layer.rank.resize(count);
    layer.level.resize(count);
    if (!arrays.curvature.empty()) layer.curvature.resize(3 * count);
    if (!arrays.width.empty()) layer.width.resize(count);
    const std::uint64_t seed = layer_seed(random_seed, Kind::own, place);
    for (std::int64_t i = 0; i < count; ++i) {
        const glm::dvec3 n = reader.normal(i);
        set_vector(layer.normal, i, n);
        set_vector(layer.direction, i,
                   arrays.direction.empty() ? geometry::stipple_frame(n).u : reader.direction(i, n));
        if (!arrays.curvature.empty()) set_vector(layer.curvature, i, reader.vector(arrays.curvature, "curvature", i));
        // If no ranks are given, all marks of a stroke have the same rank.
        const std::int64_t key = layer.has_strokes() ? std::int64_t{layer.stroke[2 * i] / 2} : i;
        layer.rank[i] =
            arrays.rank.empty() ? random_rank(seed, static_cast<std::uint64_t>(key), layer.kind) : reader.rank(i);
        if (!arrays.width.empty()) layer.width[i] = reader.width(i);
        if (!arrays.level.empty()) layer.level[i] = static_cast<std::uint8_t>(arrays.level.get(i, 0));
        layer.report.levels = std::max<std::int32_t>(layer.report.levels, layer.level[i]);
        LevelReport& counted = layer.report.of(layer.level[i]);
        ++counted.attempted;
        ++counted.placed;
    }
    layer.report.full_count = count;
    if (arrays.direction.empty()) set_directions_along(positions, reader, layer);
    return positions;
}

// Copies a layer, except its clusters.
void copy(const Layer& from, Layer& to) {
    to.name = from.name;
    to.progressive = from.progressive;
    to.whole = from.whole;
    to.tone_begin = from.tone_begin;
    copy_arrays(from, to, &Layer::position, &Layer::normal, &Layer::direction, &Layer::curvature, &Layer::rank,
                &Layer::level, &Layer::stroke, &Layer::width, &Layer::tone_normal, &Layer::stroke_first,
                &Layer::stroke_order);
    to.report.full_count = from.report.full_count;
    to.report.levels = from.report.levels;
    to.report.step = from.report.step;
    to.report.seconds = from.report.seconds;
    copy_array(from.report.level, to.report.level);
    for (const MarkField& field : from.fields) to.fields.add(copy_of(field, to.fields.memory()));
}

PointSet copy_of(const base::Runtime& runtime, const PointSet& base) {
    PointSet set(runtime.memory);
    set.distribution = base.distribution;
    set.seed_source = base.seed_source;
    set.origin = base.origin;
    set.bounds = base.bounds;
    set.spacing = base.spacing;
    set.seeds = base.seeds;
    set.seconds_seeds = base.seconds_seeds;
    set.seconds_total = base.seconds_total;
    copy_array(base.still, set.still);
    for (const Layer& layer : base.layers) copy(layer, set.layers.add(runtime.memory, layer.kind));
    return set;
}

// Computes the bounds, origin and spacing of the whole set. If the set had marks before, its origin does not change,
// and its spacing is scaled as if the area of the surface were unchanged.
void measure_all(const base::Runtime& runtime, const base::List<geometry::VecArray>& positions,
                 std::int64_t largest_before, PointSet& set) {
    if (largest_before == 0) {
        base::Array<const geometry::VecArray*> all(runtime.memory);
        for (const geometry::VecArray& of_layer : positions) all.push_back(&of_layer);
        return measure(runtime, all.span(), 0.0, 0, set);
    }
    std::int64_t largest = largest_before;
    for (const geometry::VecArray& of_layer : positions) {
        for (std::int64_t i = 0; i < of_layer.size(); ++i) set.bounds.extend(of_layer[i]);
        largest = std::max(largest, of_layer.size());
    }
    if (largest > largest_before)
        set.spacing *= std::sqrt(static_cast<double>(largest_before) / static_cast<double>(largest));
}

} // namespace

PointSet from_arrays(const base::Runtime& runtime, const PointSet* base, std::span<const LayerArrays> arrays,
                     std::uint64_t random_seed) {
    PointSet set = base != nullptr ? copy_of(runtime, *base) : PointSet(runtime.memory);
    const std::int64_t copied = set.layers.size();
    const std::int64_t largest_before = set.largest();
    base::List<geometry::VecArray> positions(runtime.memory);
    std::int64_t marks = set.count();
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        Layer& layer = set.layers.add(runtime.memory, arrays[i].kind);
        if (arrays[i].name[0] != '\0') layer.name = arrays[i].name;
        positions.add(read_layer(runtime.memory, arrays[i], static_cast<std::int64_t>(i), random_seed, layer));
        marks += layer.count();
    }
    if (marks == 0)
        fail(Status::invalid_argument,
             "no layer has a mark; give point_set_desc.layers[0].position and normal, or those of another layer");
    measure_all(runtime, positions, largest_before, set);
    if (const double side = set.bounds.longest_side(); side > 0.0) require_size("the marks are", side, "positions");
    for (std::int64_t k = 0; k < positions.size(); ++k) {
        Layer& layer = set.layers[copied + k];
        layer.position.resize(3 * positions[k].size());
        for (std::int64_t i = 0; i < positions[k].size(); ++i)
            set_vector(layer.position, i, positions[k][i] - set.origin);
    }
    return set;
}

} // namespace hrbfnpr::marks
