// SPDX-License-Identifier: MIT
#include "geometry/tangent_frame.h"
#include "published/growth.h"
#include "published/tuning.h"
#include "surface/curvature.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::published {
namespace {

constexpr std::int64_t stroke_children = 2;
constexpr std::int32_t sets = 2;

std::int64_t stroke_count(const Start& start) noexcept { return sets * start.position.size(); }

// v in the plane across n, unit; zero if v is (nearly) along n.
glm::dvec3 in_plane(const glm::dvec3& v, const glm::dvec3& n) noexcept {
    const glm::dvec3 flat = v - glm::dot(v, n) * n;
    const double length = glm::length(flat);
    return length > 1e-6 ? flat / length : glm::dvec3(0.0);
}

glm::dvec3 combing_direction(std::int32_t set, const glm::dvec3& n) noexcept {
    const geometry::TangentFrame frame = geometry::combing_frame(n);
    return set == 0 ? frame.r : frame.u;
}

// Euler: the normal curvature in the tangent direction d.
double bend_along(const glm::dvec3& d, const surface::Curvature& c) noexcept {
    const double first = glm::dot(d, c.d1);
    const double second = glm::dot(d, c.d2);
    return c.k1 * first * first + c.k2 * second * second;
}

// From a mark along its direction d, a signed distance s on the osculating circle of curvature k
// [NPAR 5.1, Figure 4]: sin(s k)/k d + (1 - cos(s k))/k n. Its centre is at n / k: k is negative
// where the surface bends away from the normal. Not beyond a quarter of the circle: farther on it
// comes back, and what curvature tells of the surface ended long before.
glm::dvec3 on_osculating_circle(double s, double k, const glm::dvec3& d, const glm::dvec3& n) noexcept {
    constexpr double quarter = 1.5707963267948966;
    const double angle = std::clamp(s * k, -quarter, quarter);
    if (std::abs(s * k) > quarter) s = std::copysign(quarter / std::abs(k), s);
    if (std::abs(angle) < 1e-4) // the series: no division by a k that may be 0
        return s * ((1.0 - angle * angle / 6.0) * d + 0.5 * angle * (1.0 - angle * angle / 12.0) * n);
    return s / angle * (std::sin(angle) * d + (1.0 - std::cos(angle)) * n);
}

class Strokes {
public:
    Strokes(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
            marks::LayerReport& report)
        : site_(site), start_(start), settings_(settings), marks_(marks), report_(report), settler_(site),
          parent_(site.memory()), side_(site.memory()), landed_(site.memory()), landed_normal_(site.memory()),
          given_(site.memory()), curvature_(site.memory()) {}

    // Returns whether the budget cut the level.
    bool place_seeds(const base::Progress& progress);
    bool refine(std::int32_t level, double rho, const base::Progress& progress);

private:
    [[nodiscard]] bool by_curvature() const noexcept { return settings_.directions == Directions::principal; }
    // Whether directions come from `curvature_`, which holds nothing else if a function gives them: with confidence 1,
    // or 0 where the function gives none.
    [[nodiscard]] bool measured() const noexcept { return settings_.directions != Directions::combing; }
    void measure(const geometry::VecArray& position, const geometry::VecArray& normal, const base::Progress& progress);
    // A stroke and a place along it make a mark.
    [[nodiscard]] static std::uint64_t key(std::uint32_t stroke, std::int32_t place) noexcept {
        return static_cast<std::uint64_t>(stroke) << 32U | static_cast<std::uint32_t>(place);
    }
    [[nodiscard]] glm::dvec3 direction(std::int32_t set, const glm::dvec3& n, const surface::Curvature& c,
                                       const glm::dvec3& before) const noexcept;
    void append(const glm::dvec3& position, const glm::dvec3& normal, std::uint32_t stroke, std::int32_t place,
                std::uint8_t level, const surface::Curvature& c, const glm::dvec3& before);
    void append_placed(std::uint8_t level, std::int32_t finest, const base::Progress& progress);
    void reserve(std::int64_t count, const base::Progress& progress);

    const marks::Site& site_;
    const Start& start_;
    const GrowthSettings& settings_;
    marks::Marks& marks_;
    marks::LayerReport& report_;
    marks::Settler settler_;
    base::Array<std::int64_t> parent_; // the mark that each start of the chunk comes from
    base::Array<std::int8_t> side_;    // 1 if the start lies onward along the stroke, -1 if back
    geometry::VecArray landed_, landed_normal_, given_;
    base::Array<surface::Curvature> curvature_;
};

// `before`: the direction of the mark that this one was placed from, zero for a seed. Fields of
// directions have no sign; a stroke keeps its own, or it would fold back on itself.
glm::dvec3 Strokes::direction(std::int32_t set, const glm::dvec3& n, const surface::Curvature& c,
                              const glm::dvec3& before) const noexcept {
    glm::dvec3 field = measured() ? (set == 0 ? c.d1 : c.d2) : combing_direction(set, n);
    // Zero where the caller's field has none, or the gradient vanishes by the curvature's evaluation but not by the
    // projection's.
    if (!(glm::dot(field, field) > 0.5)) field = combing_direction(set, n);
    const glm::dvec3 onward = in_plane(before, n);
    if (glm::dot(onward, onward) < 0.5) return field;
    if (glm::dot(field, onward) < 0.0) field = -field;
    if (!measured()) return field;
    const double weight = glm::smoothstep(published_tuning.unsure, published_tuning.sure, c.confidence);
    return glm::normalize(weight * field + (1.0 - weight) * onward); // no more than 90 degrees apart
}

void Strokes::append(const glm::dvec3& position, const glm::dvec3& normal, std::uint32_t stroke, std::int32_t place,
                     std::uint8_t level, const surface::Curvature& c, const glm::dvec3& before) {
    const glm::dvec3 d = direction(static_cast<std::int32_t>(stroke & 1U), normal, c, before);
    marks_.position.push_back(position);
    marks_.normal.push_back(normal);
    marks_.direction.push_back(d);
    marks_.key.push_back(key(stroke, place));
    marks_.stroke.push_back(stroke);
    marks_.place.push_back(place);
    marks_.level.push_back(level);
    if (!by_curvature()) return;
    marks_.bend.push_back(bend_along(d, c));
    marks_.curvature.push_back(
        {marks::held_curvature(c.k1), marks::held_curvature(c.k2), static_cast<float>(c.confidence)});
}

void Strokes::measure(const geometry::VecArray& position, const geometry::VecArray& normal,
                      const base::Progress& progress) {
    if (by_curvature()) surface::principal_curvatures(site_.runtime, site_.implicit, position, curvature_, progress);
    if (settings_.directions != Directions::function) return;
    marks::directions_at(site_, settings_.function, position, normal, given_, progress);
    curvature_.resize(position.size());
    for (std::int64_t i = 0; i < position.size(); ++i) {
        surface::Curvature& c = curvature_[i];
        c = {};
        c.d1 = given_[i];
        c.d2 = glm::cross(normal[i], given_[i]);
        c.confidence = glm::dot(c.d1, c.d1) > 0.5 ? 1.0 : 0.0;
    }
}

// A seed of a stroke is its middle; stroke i belongs to set i % 2.
bool Strokes::place_seeds(const base::Progress& progress) {
    const std::int64_t count = stroke_count(start_);
    measure(start_.position, start_.normal, progress);
    const auto key_of = [](std::int64_t i) { return key(static_cast<std::uint32_t>(i), 0); };
    const marks::Thinning thinning(site_, count, settings_.budget > 0 ? settings_.budget : count,
                                   marks::stream_of(marks::Kind::hatch), key_of, progress);
    reserve(settings_.budget > 0 ? std::min(settings_.budget, count) : count, progress);
    for (std::int64_t i = 0; i < count; ++i) {
        if (i % marks::chunk_size == 0) progress.check();
        if (!thinning.keeps(key_of(i))) continue;
        const std::int64_t from = i / sets;
        append(start_.position[from], start_.normal[from], static_cast<std::uint32_t>(i), 0, 0,
               measured() ? curvature_[from] : surface::Curvature{}, glm::dvec3(0.0));
    }
    marks::LevelReport& level = report_.of(0);
    level.attempted = count;
    level.placed = marks_.count();
    level.dropped_budget = count - marks_.count();
    return thinning.active();
}

bool Strokes::refine(std::int32_t level, double rho, const base::Progress& progress) {
    HRBFNPR_ASSERT(level > 0 && level <= settings_.levels && rho > 0.0);
    marks::LevelReport& report = report_.of(level);
    const std::int64_t parents = marks_.count();
    // Places are numbered in steps of the last level that was asked for.
    const auto finest = static_cast<std::int32_t>(marks::grown_count(1, 3, settings_.levels - level));
    const std::int64_t room =
        settings_.budget > 0 ? std::max<std::int64_t>(0, settings_.budget - parents) : stroke_children * parents;
    const auto key_of = [&](std::int64_t i) {
        const std::int64_t parent = i / stroke_children;
        return key(marks_.stroke[parent], marks_.place[parent] + (i % stroke_children == 0 ? -finest : finest));
    };
    const marks::Thinning thinning(site_, stroke_children * parents, room, marks::stream_of(marks::Kind::hatch), key_of,
                                   progress);
    reserve(parents + std::min(room, stroke_children * parents), progress);
    constexpr std::int64_t parents_of_chunk = marks::chunk_size / stroke_children;
    for (std::int64_t begin = 0; begin < parents; begin += parents_of_chunk) {
        const std::int64_t end = std::min(parents, begin + parents_of_chunk);
        settler_.start.clear();
        parent_.clear();
        side_.clear();
        for (std::int64_t parent = begin; parent < end; ++parent)
            for (const std::int8_t side : {std::int8_t{-1}, std::int8_t{1}}) {
                if (!thinning.keeps(key(marks_.stroke[parent], marks_.place[parent] + side * finest))) {
                    ++report.attempted;
                    ++report.dropped_budget;
                    continue;
                }
                const glm::dvec3 d = marks_.direction[parent];
                const glm::dvec3 offset =
                    by_curvature() ? on_osculating_circle(side * rho, marks_.bend[parent], d, marks_.normal[parent])
                                   : side * rho * d;
                settler_.start.push_back(marks_.position[parent] + offset);
                parent_.push_back(parent);
                side_.push_back(side);
            }
        const auto all = static_cast<double>(parents);
        const base::Progress part = progress.part(static_cast<double>(begin) / all, static_cast<double>(end) / all);
        // What lands farther from its start than a step belongs to another part of the surface.
        settler_.settle(rho, report, part.part(0.0, 0.5));
        append_placed(static_cast<std::uint8_t>(level), finest, part.part(0.5, 1.0));
    }
    return thinning.active();
}

void Strokes::append_placed(std::uint8_t level, std::int32_t finest, const base::Progress& progress) {
    landed_.clear();
    landed_normal_.clear();
    for (std::int64_t i = 0; i < settler_.start.size(); ++i) {
        if (!settler_.placed(i)) continue;
        landed_.push_back(settler_.position(i));
        landed_normal_.push_back(settler_.normal(i));
    }
    measure(landed_, landed_normal_, progress);
    std::int64_t at = 0;
    for (std::int64_t i = 0; i < settler_.start.size(); ++i) {
        if (!settler_.placed(i)) continue;
        const std::int64_t parent = parent_[i];
        append(settler_.position(i), settler_.normal(i), marks_.stroke[parent],
               marks_.place[parent] + side_[i] * finest, level, measured() ? curvature_[at] : surface::Curvature{},
               marks_.direction[parent]);
        ++at;
    }
}

void Strokes::reserve(std::int64_t count, const base::Progress& progress) {
    make_room(count, progress, marks_.position, marks_.normal, marks_.direction, marks_.key, marks_.stroke,
              marks_.place, marks_.level);
    if (by_curvature()) make_room(count, progress, marks_.bend, marks_.curvature);
}

} // namespace

void grow_strokes(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                  marks::LayerReport& report, const base::Progress& progress) {
    report.full_count = marks::grown_count(sets * start.full_count, 1 + stroke_children, settings.levels);
    report.step = settings.step;
    marks::require_room(settings.layer, marks::grown_count(stroke_count(start), 1 + stroke_children, settings.levels),
                        settings.levels, settings.budget);
    Strokes strokes(site, start, settings, marks, report);
    const auto work = static_cast<double>(marks::grown_count(1, 1 + stroke_children, settings.levels));
    const bool full = strokes.place_seeds(progress.part(0.0, 1.0 / work));
    refine_levels(
        settings, 1 + stroke_children, full, report, progress,
        [&](std::int32_t level, double rho, const base::Progress& part) { return strokes.refine(level, rho, part); });
    // Places were numbered for all levels; number them for those that were taken.
    const auto unused =
        static_cast<std::int32_t>(marks::grown_count(1, 1 + stroke_children, settings.levels - report.levels));
    const auto middle = static_cast<std::int32_t>((marks::grown_count(1, 1 + stroke_children, report.levels) - 1) / 2);
    for (std::int32_t& place : marks.place) place = place / unused + middle;
}

} // namespace hrbfnpr::published
