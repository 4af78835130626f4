// SPDX-License-Identifier: MIT
#include "marks/from_arrays.h"

#include "base/format.h"
#include "geometry/tangent_frame.h"
#include "geometry/unit.h"
#include "marks/assemble.h"
#include "marks/size.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstring>

namespace hrbfnpr::marks {
namespace {

using base::InView;

long long number(std::int64_t i) noexcept { return static_cast<long long>(i); }

// So that its square is neither 0 nor infinite.
glm::dvec3 of_moderate_length(const glm::dvec3& v) noexcept {
    return v / geometry::unit_for(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

void store_vector(base::Array<float>& array, std::int64_t i, const glm::dvec3& v) noexcept {
    for (int axis = 0; axis < 3; ++axis) array[3 * i + axis] = static_cast<float>(v[axis]);
}

// Copies one layer's arrays, checking every number; `place` is that of the layer in the list.
class Importer {
public:
    Importer(const LayerArrays& arrays, std::int64_t place, std::uint64_t random_seed, Layer& layer)
        : arrays_(arrays), place_(place), random_seed_(layer_seed(random_seed, Kind::own, place)), layer_(layer),
          count_(arrays.position.count) {}

    void positions(geometry::VecArray& result) const;
    void rest(const geometry::VecArray& positions);
    void relative_positions(const geometry::VecArray& positions, const glm::dvec3& origin);

private:
    // "point_set_desc.layers[1].rank[3] is ..."
    [[noreturn]] [[gnu::format(printf, 4, 5)]] void refuse(const char* name, std::int64_t i, const char* format,
                                                           ...) const;
    void check_count(const InView& view, const char* name, bool needed) const;
    [[nodiscard]] double finite(const InView& view, const char* name, std::int64_t i, std::uint32_t component) const;
    [[nodiscard]] glm::dvec3 vector(const InView& view, const char* name, std::int64_t i) const {
        return {finite(view, name, i, 0), finite(view, name, i, 1), finite(view, name, i, 2)};
    }
    [[nodiscard]] glm::dvec3 normal(std::int64_t i) const;
    [[nodiscard]] glm::dvec3 direction(std::int64_t i, const glm::dvec3& n) const;
    [[nodiscard]] float rank(std::int64_t i, std::int64_t stroke) const;
    [[nodiscard]] float width(std::int64_t i) const;
    void strokes();
    [[nodiscard]] std::uint32_t direction_of_stroke(std::int64_t stroke) const;
    void number_strokes();
    void direct_along(const geometry::VecArray& positions);
    void report();

    const LayerArrays& arrays_;
    std::int64_t place_;
    std::uint64_t random_seed_;
    Layer& layer_;
    std::int64_t count_;
};

void Importer::refuse(const char* name, std::int64_t i, const char* format, ...) const {
    char why[160];
    std::va_list arguments;
    va_start(arguments, format);
    base::format_text(why, sizeof why, format, arguments);
    va_end(arguments);
    fail(Status::invalid_argument, "point_set_desc.layers[%lld].%s[%lld] is %s", number(place_), name, number(i), why);
}

void Importer::check_count(const InView& view, const char* name, bool needed) const {
    if (view.count == count_ || (view.empty() && !needed)) return;
    fail(Status::invalid_argument, "point_set_desc.layers[%lld].%s has %lld elements and .position has %lld: %s",
         number(place_), name, number(view.count), number(count_),
         needed ? "every mark needs one" : "give one for each mark or leave it empty");
}

double Importer::finite(const InView& view, const char* name, std::int64_t i, std::uint32_t component) const {
    const double value = view.get(i, component);
    if (!std::isfinite(value)) refuse(name, i, "not finite");
    // It would become infinite in the set.
    if (std::abs(value) > 3.4e38) refuse(name, i, "%g, which a float cannot hold: scale the marks", value);
    return value;
}

glm::dvec3 Importer::normal(std::int64_t i) const {
    const glm::dvec3 n = of_moderate_length(vector(arrays_.normal, "normal", i));
    const double length = glm::length(n);
    if (!(length > 0.0) || !std::isfinite(length)) refuse("normal", i, "zero: every mark needs a normal");
    return n / length;
}

// Made tangent: a stroke has no part along its normal.
glm::dvec3 Importer::direction(std::int64_t i, const glm::dvec3& n) const {
    if (arrays_.direction.empty()) return geometry::stipple_frame(n).u;
    const glm::dvec3 d = of_moderate_length(vector(arrays_.direction, "direction", i));
    const glm::dvec3 tangent = d - glm::dot(d, n) * n;
    const double length = glm::length(tangent);
    if (!(length > 1e-6 * glm::length(d))) refuse("direction", i, "zero or along the normal: it must be tangent");
    return tangent / length;
}

// All marks of a stroke have the same where none is given.
float Importer::rank(std::int64_t i, std::int64_t stroke) const {
    if (arrays_.rank.empty())
        return random_rank(random_seed_, static_cast<std::uint64_t>(stroke >= 0 ? stroke : i), layer_.kind);
    const double u = arrays_.rank.get(i, 0);
    if (!(u >= 0.0 && u <= 1.0)) refuse("rank", i, "outside [0,1)");
    return rank_of(u);
}

float Importer::width(std::int64_t i) const {
    const double width = arrays_.width.get(i, 0);
    const auto rounded = static_cast<float>(width);
    if (!(rounded > 0.0F && width <= 1.0)) refuse("width", i, "outside (0,1]");
    return rounded;
}

void Importer::positions(geometry::VecArray& result) const {
    check_count(arrays_.normal, "normal", true);
    check_count(arrays_.direction, "direction", false);
    check_count(arrays_.curvature, "curvature", false);
    check_count(arrays_.rank, "rank", false);
    check_count(arrays_.level, "level", false);
    check_count(arrays_.width, "width", false);
    if (count_ > most_marks)
        fail(Status::invalid_argument, "point_set_desc.layers[%lld].position has %lld elements, and %lld are the most",
             number(place_), number(count_), number(most_marks));
    result.resize(count_);
    for (std::int64_t i = 0; i < count_; ++i) result.set(i, vector(arrays_.position, "position", i));
}

void Importer::strokes() {
    const InView& first = arrays_.stroke_first;
    const std::int64_t strokes = first.empty() ? 0 : first.count - 1;
    for (std::int64_t s = 0; s < first.count; ++s) {
        const double now = first.get(s, 0);
        const bool rises = s == 0 ? now == 0.0 : now > first.get(s - 1, 0);
        const bool ends = s == strokes ? now == static_cast<double>(count_) : now < static_cast<double>(count_);
        if (!rises || !ends)
            refuse("stroke_first", s, "%.0f; it must rise from 0 to the %lld marks", now, number(count_));
    }
    if (strokes > 0)
        for (std::int64_t s = 0; s <= strokes; ++s)
            layer_.stroke_first.push_back(static_cast<std::uint32_t>(first.get(s, 0)));
    const std::int64_t directions = arrays_.stroke_direction.count;
    if (!arrays_.stroke_direction.empty() && directions != strokes)
        fail(Status::invalid_argument,
             "point_set_desc.layers[%lld].stroke_direction has %lld elements and .stroke_first tells of %lld strokes: "
             "give one for each stroke or leave it empty",
             number(place_), number(directions), number(strokes));
}

std::uint32_t Importer::direction_of_stroke(std::int64_t stroke) const {
    if (arrays_.stroke_direction.empty()) return 0;
    const auto direction = static_cast<std::uint32_t>(arrays_.stroke_direction.get(stroke, 0));
    if (direction > 1) refuse("stroke_direction", stroke, "%u; it must be 0 or 1", direction);
    return direction;
}

void Importer::number_strokes() {
    layer_.stroke.resize(2 * count_);
    for (std::int64_t s = 0; s < layer_.strokes(); ++s) {
        const std::uint32_t own = 2 * static_cast<std::uint32_t>(s) + direction_of_stroke(s);
        for (std::uint32_t i = layer_.stroke_first[s]; i < layer_.stroke_first[s + 1]; ++i) {
            layer_.stroke[2 * std::int64_t{i}] = own;
            layer_.stroke[2 * std::int64_t{i} + 1] = i - layer_.stroke_first[s];
        }
    }
    if (layer_.has_strokes()) return;
    for (std::int64_t i = 0; i < count_; ++i) layer_.stroke[2 * i] = 2 * static_cast<std::uint32_t>(i);
}

// Central differences along the stroke; a mark that has no neighbour elsewhere keeps its basis.
void Importer::direct_along(const geometry::VecArray& positions) {
    for (std::int64_t s = 0; s < layer_.strokes(); ++s) {
        const std::int64_t begin = layer_.stroke_first[s];
        const std::int64_t last = std::int64_t{layer_.stroke_first[s + 1]} - 1;
        for (std::int64_t i = begin; i <= last; ++i) {
            const glm::dvec3 n = normal(i);
            const glm::dvec3 d =
                of_moderate_length(positions[std::min(i + 1, last)] - positions[std::max(i - 1, begin)]);
            const glm::dvec3 tangent = d - glm::dot(d, n) * n;
            const double length = glm::length(tangent);
            if (length > 1e-6 * glm::length(d)) store_vector(layer_.direction, i, tangent / length);
        }
    }
}

void Importer::rest(const geometry::VecArray& positions) {
    strokes();
    number_strokes();
    layer_.normal.resize(3 * count_);
    layer_.direction.resize(3 * count_);
    layer_.rank.resize(count_);
    layer_.level.resize(count_);
    if (!arrays_.curvature.empty()) layer_.curvature.resize(3 * count_);
    if (!arrays_.width.empty()) layer_.width.resize(count_);
    for (std::int64_t i = 0; i < count_; ++i) {
        const glm::dvec3 n = normal(i);
        store_vector(layer_.normal, i, n);
        store_vector(layer_.direction, i, direction(i, n));
        if (!arrays_.curvature.empty()) store_vector(layer_.curvature, i, vector(arrays_.curvature, "curvature", i));
        layer_.rank[i] = rank(i, layer_.has_strokes() ? std::int64_t{layer_.stroke[2 * i] / 2} : -1);
        if (!arrays_.width.empty()) layer_.width[i] = width(i);
        if (!arrays_.level.empty()) layer_.level[i] = static_cast<std::uint8_t>(arrays_.level.get(i, 0));
    }
    if (arrays_.direction.empty()) direct_along(positions);
    report();
}

void Importer::report() {
    layer_.report.full_count = count_;
    for (const std::uint8_t level : layer_.level) {
        layer_.report.levels = std::max<std::int32_t>(layer_.report.levels, level);
        LevelReport& counted = layer_.report.of(level);
        ++counted.attempted;
        ++counted.placed;
    }
}

void Importer::relative_positions(const geometry::VecArray& positions, const glm::dvec3& origin) {
    layer_.position.resize(3 * count_);
    for (std::int64_t i = 0; i < count_; ++i) store_vector(layer_.position, i, positions[i] - origin);
}

template <class T>
void copy(const base::Array<T>& from, base::Array<T>& to) {
    to.resize_for_overwrite(from.size());
    if (!from.empty()) std::memcpy(to.data(), from.data(), sizeof(T) * static_cast<std::size_t>(from.size()));
}

// All but its clusters.
void copy(const Layer& from, Layer& to) {
    to.name = from.name;
    to.progressive = from.progressive;
    copy(from.position, to.position);
    copy(from.normal, to.normal);
    copy(from.direction, to.direction);
    copy(from.curvature, to.curvature);
    copy(from.rank, to.rank);
    copy(from.level, to.level);
    copy(from.stroke, to.stroke);
    copy(from.width, to.width);
    copy(from.tone_normal, to.tone_normal);
    copy(from.stroke_first, to.stroke_first);
    copy(from.stroke_order, to.stroke_order);
    to.report.full_count = from.report.full_count;
    to.report.levels = from.report.levels;
    to.report.step = from.report.step;
    to.report.seconds = from.report.seconds;
    copy(from.report.level, to.report.level);
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
    for (const Layer& layer : base.layers) copy(layer, set.layers.add(runtime.memory, layer.kind));
    return set;
}

// Where there are marks already their origin stays, and so does what is known of the area.
void measure_all(const base::Runtime& runtime, const base::List<geometry::VecArray>& positions,
                 std::int64_t largest_before, PointSet& set) {
    if (largest_before == 0) {
        base::Array<const geometry::VecArray*> all(runtime.memory);
        for (const geometry::VecArray& of_layer : positions) all.push_back(&of_layer);
        return measure(runtime, all.span(), 0.0, set, {});
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
        Importer importer(arrays[i], static_cast<std::int64_t>(i), random_seed, layer);
        importer.positions(positions.add(runtime.memory));
        importer.rest(positions.back());
        marks += layer.count();
    }
    if (marks == 0)
        fail(Status::invalid_argument,
             "there is no mark: give point_set_desc.layers[0].position and .normal, or those of another layer");
    measure_all(runtime, positions, largest_before, set);
    if (const double side = set.bounds.longest_side(); side > 0.0) require_size("the marks are", side, "positions");
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        const auto place = static_cast<std::int64_t>(i);
        Importer(arrays[i], place, random_seed, set.layers[copied + place])
            .relative_positions(positions[place], set.origin);
    }
    return set;
}

} // namespace hrbfnpr::marks
