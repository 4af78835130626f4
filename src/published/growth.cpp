// SPDX-License-Identifier: MIT
// Both recursions have the same steps. place_seeds() thins the seeds to fit into the budget. For each further level,
// refine_level() thins the children of all marks, projects them onto the surface and appends them.
#include "published/growth.h"

#include "base/random.h"
#include "geometry/long_vec_array.h"
#include "geometry/tangent_frame.h"
#include "published/tuning.h"
#include "surface/curvature.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::published {
namespace {

// ---- Steps of both recursions

struct Growth {
    const marks::Site& site;
    const GrowthSettings& settings;
    marks::Marks& grown;
    marks::LayerReport& report;
    marks::Kind kind;
    std::int64_t children; // the number of children of a mark in the next level
    marks::MarkProjector projector{site};
    base::Array<std::int64_t> child{site.memory()}; // for each of the projector's starts, its index among all children

    [[nodiscard]] bool by_curvature() const noexcept {
        return kind == marks::Kind::hatch && settings.directions == Directions::principal;
    }
};

// Reserves room for `count` marks in each growing column. Checks for cancellation between columns, because growing a
// column takes long.
void make_room(Growth& growth, std::int64_t count, const base::Progress& progress) {
    marks::Marks& marks = growth.grown;
    const auto make = [&](auto&... column) { (make_room_long(column, count, progress), ...); };
    make(marks.position, marks.normal, marks.key, marks.stroke, marks.place, marks.level);
    if (growth.kind == marks::Kind::hatch) make(marks.direction);
    if (growth.by_curvature()) make(marks.curvature_along, marks.curvature);
}

// Calls append(i) for the seeds that fit into the budget. Returns whether seeds were left out.
template <class KeyOf, class Append>
bool place_seeds(Growth& growth, std::int64_t count, const KeyOf& key_of, const Append& append,
                 const base::Progress& progress) {
    const std::int64_t room = growth.settings.budget > 0 ? growth.settings.budget : count;
    const marks::Thinning thinning(growth.site.with(progress), count, room, marks::stream_of(growth.kind), key_of);
    make_room(growth, std::min(room, count), progress);
    for (const std::int64_t i : progress.over(count)) {
        if (thinning.keeps(key_of(i))) append(i);
    }
    marks::LevelReport& level = growth.report.of(0);
    level.attempted = count;
    level.placed = growth.grown.count();
    level.dropped_budget = count - growth.grown.count();
    return thinning.active();
}

// Projects the children that fit into the budget, chunk by chunk. Child i belongs to mark i / children, and starts at
// start_of(i). It is dropped if it lands farther than `stray_limit` from its start. append(progress) takes the
// projected points of a chunk. Returns whether the budget cut the level.
template <class KeyOf, class StartOf, class Append>
bool refine_level(Growth& growth, std::int32_t number, double stray_limit, const KeyOf& key_of, const StartOf& start_of,
                  const Append& append, const base::Progress& progress) {
    HRBFNPR_ASSERT(number > 0 && number <= growth.settings.levels && stray_limit > 0.0);
    marks::LevelReport& report = growth.report.of(number);
    const std::int64_t parents = growth.grown.count();
    const std::int64_t all = growth.children * parents;
    const std::int64_t room =
        growth.settings.budget > 0 ? std::max<std::int64_t>(0, growth.settings.budget - parents) : all;
    const marks::Thinning thinning(growth.site.with(progress), all, room, marks::stream_of(growth.kind), key_of);
    make_room(growth, parents + std::min(room, all), progress);
    for (std::int64_t begin = 0; begin < all; begin += marks::chunk_size) {
        const std::int64_t end = std::min(all, begin + marks::chunk_size);
        growth.projector.start.clear();
        growth.child.clear();
        for (std::int64_t i = begin; i < end; ++i) {
            if (!thinning.keeps(key_of(i))) {
                ++report.attempted;
                ++report.dropped_budget;
                continue;
            }
            growth.projector.start.push_back(start_of(i));
            growth.child.push_back(i);
        }
        const base::Progress part = progress.part(static_cast<double>(begin) / static_cast<double>(all),
                                                  static_cast<double>(end) / static_cast<double>(all));
        growth.projector.project(stray_limit, report, part.part(0.0, 0.5));
        append(part.part(0.5, 1.0));
    }
    return thinning.active();
}

// Refines level by level until the budget cuts a level. The step of a level is a third of the previous step.
// refine(level, step, progress) returns whether the budget cut the level. `full` tells whether the budget already cut
// level 0.
template <class Refine>
void refine_levels(const Growth& growth, bool full, const base::Progress& progress, const Refine& refine) {
    HRBFNPR_ASSERT(growth.children > 0 && growth.settings.levels >= 0);
    const auto grown = [&](std::int32_t level) {
        return static_cast<double>(marks::grown_count(1, 1 + growth.children, level));
    };
    const double all = grown(growth.settings.levels);
    double step = growth.settings.step;
    for (std::int32_t level = 1; level <= growth.settings.levels && !full; ++level) {
        full = refine(level, step, progress.part(grown(level - 1) / all, grown(level) / all));
        growth.report.levels = level;
        step /= 3.0;
    }
}

// ---- Stipples

// The largest random change of a child's offset, as a share of rho. The article gives this value.
constexpr double jitter = 0.125;

// Returns the offset at which a child starts, for a mark with this normal, in units of rho: i r + j u in the tangent
// plane. i and j are +-1 + U(-1/8, 1/8), drawn at random for each child. [NPAR 5.2]
[[nodiscard]] glm::dvec3 stipple_offset(const glm::dvec3& normal, std::int64_t child, std::uint64_t seed,
                                        std::uint64_t key) noexcept {
    const auto u = base::uniform4(seed, key, base::Purpose::stipple_jitter);
    const double i = (child & 1) != 0 ? 1.0 : -1.0;
    const double j = (child & 2) != 0 ? 1.0 : -1.0;
    const geometry::TangentFrame frame = geometry::stipple_frame(normal);
    return (i + jitter * (2.0 * u[0] - 1.0)) * frame.r + (j + jitter * (2.0 * u[1] - 1.0)) * frame.u;
}

void append_stipple(const glm::dvec3& position, const glm::dvec3& normal, std::uint64_t key, std::uint32_t seed,
                    std::int32_t level, marks::Marks& marks) {
    marks.position.push_back(position);
    marks.normal.push_back(normal);
    marks.key.push_back(key);
    marks.stroke.push_back(seed);
    marks.place.push_back(0);
    marks.level.push_back(static_cast<std::uint8_t>(level));
}

// ---- Strokes

constexpr std::int32_t direction_count = 2;

// Returns the normal curvature in the tangent direction d by Euler's formula.
[[nodiscard]] double normal_curvature_along(const glm::dvec3& d, const surface::Curvature& c) noexcept {
    const double first = glm::dot(d, c.d1);
    const double second = glm::dot(d, c.d2);
    return c.k1 * first * first + c.k2 * second * second;
}

// Returns the offset from a mark along its direction d by a signed distance s, on the osculating circle of curvature k
// [NPAR 5.1, Figure 4]: sin(s k)/k d + (1 - cos(s k))/k n. The circle's centre is at n / k. k is negative where the
// surface bends away from the normal. The offset is limited to a quarter of the circle: farther on, the circle returns,
// and the curvature describes the surface only near the mark.
[[nodiscard]] glm::dvec3 on_osculating_circle(double s, double k, const glm::dvec3& d, const glm::dvec3& n) noexcept {
    constexpr double quarter = 1.5707963267948966;
    const double angle = std::clamp(s * k, -quarter, quarter);
    if (std::abs(s * k) > quarter) s = std::copysign(quarter / std::abs(k), s);
    if (std::abs(angle) < 1e-4) // a series avoids dividing by k, which may be 0
        return s * ((1.0 - angle * angle / 6.0) * d + 0.5 * angle * (1.0 - angle * angle / 12.0) * n);
    return s / angle * (std::sin(angle) * d + (1.0 - std::cos(angle)) * n);
}

// Returns the curvatures at places. Directions of the caller's function replace the principal directions. Their
// confidence is 1, or 0 where the function gives none. Combing strokes do not use curvatures, so they get default
// values.
[[nodiscard]] base::Array<surface::Curvature> measure_curvatures(const Growth& growth,
                                                                 const geometry::VecArray& position,
                                                                 const geometry::VecArray& normal,
                                                                 const base::Progress& progress) {
    const marks::Site& site = growth.site;
    base::Array<surface::Curvature> curvature(site.memory());
    if (growth.by_curvature()) {
        surface::principal_curvatures({site.work, progress}, site.implicit, position, curvature);
        return curvature;
    }
    curvature.resize(position.size());
    if (growth.settings.directions != Directions::function) return curvature;
    geometry::VecArray given(site.memory());
    marks::directions_at(site.with(progress), growth.settings.function, position, normal, given);
    for (std::int64_t i = 0; i < position.size(); ++i) {
        surface::Curvature& c = curvature[i];
        c = {};
        c.d1 = given[i];
        c.d2 = glm::cross(normal[i], given[i]);
        c.confidence = glm::dot(c.d1, c.d1) > 0.5 ? 1.0 : 0.0;
    }
    return curvature;
}

// Returns the direction of a stroke at a mark. `before` is the direction at the previous mark, or 0 for a seed.
// Direction fields have no sign, so the sign is chosen to continue the stroke. Otherwise the stroke would fold back on
// itself.
[[nodiscard]] glm::dvec3 stroke_direction(bool combing, std::uint32_t set, const glm::dvec3& n,
                                          const surface::Curvature& c, const glm::dvec3& before) noexcept {
    glm::dvec3 field = set == 0 ? c.d1 : c.d2;
    // The field is 0 where the caller's function gives no direction. It is also 0 where the gradient is 0 when
    // curvatures are evaluated, although it was not 0 in the projection.
    if (combing || !(glm::dot(field, field) > 0.5))
        field = set == 0 ? geometry::combing_frame(n).r : geometry::combing_frame(n).u;
    const glm::dvec3 flat = before - glm::dot(before, n) * n; // `before` projected onto the plane perpendicular to n
    const double length = glm::length(flat);
    if (!(length > 1e-6)) return field;
    const glm::dvec3 onward = flat / length;
    if (glm::dot(field, onward) < 0.0) field = -field;
    if (combing) return field;
    const double weight =
        glm::smoothstep(published_tuning.no_confidence, published_tuning.full_confidence, c.confidence);
    return glm::normalize(weight * field + (1.0 - weight) * onward); // the two directions differ by at most 90 degrees
}

// Returns a key for random numbers from a mark's stroke and the mark's position along it.
[[nodiscard]] std::uint64_t stroke_key(std::uint32_t stroke, std::int32_t place) noexcept {
    return static_cast<std::uint64_t>(stroke) << 32U | static_cast<std::uint32_t>(place);
}

void append_stroke_mark(Growth& growth, const glm::dvec3& position, const glm::dvec3& normal, std::uint32_t stroke,
                        std::int32_t place, std::int32_t level, const surface::Curvature& c, const glm::dvec3& before) {
    marks::Marks& marks = growth.grown;
    const glm::dvec3 d =
        stroke_direction(growth.settings.directions == Directions::combing, stroke & 1U, normal, c, before);
    marks.position.push_back(position);
    marks.normal.push_back(normal);
    marks.direction.push_back(d);
    marks.key.push_back(stroke_key(stroke, place));
    marks.stroke.push_back(stroke);
    marks.place.push_back(place);
    marks.level.push_back(static_cast<std::uint8_t>(level));
    if (!growth.by_curvature()) return;
    marks.curvature_along.push_back(normal_curvature_along(d, c));
    marks.curvature.push_back(
        {marks::clamped_curvature(c.k1), marks::clamped_curvature(c.k2), static_cast<float>(c.confidence)});
}

} // namespace

void grow_stipples(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                   marks::LayerReport& report) {
    Growth growth{site, settings, marks, report, marks::Kind::stipples, 4};
    const std::int64_t seeds = start.position.size();
    report.full_count = marks::grown_count(start.full_count, 5, settings.levels);
    report.step = settings.step;
    marks::require_room(settings.layer, marks::grown_count(seeds, 5, settings.levels), settings.levels,
                        settings.budget);
    const bool full = place_seeds(
        growth, seeds, [](std::int64_t i) { return static_cast<std::uint64_t>(i); },
        [&](std::int64_t i) {
            append_stipple(start.position[i], start.normal[i], static_cast<std::uint64_t>(i),
                           static_cast<std::uint32_t>(i), 0, marks);
        },
        site.work);
    // The number of marks before a level if no mark had been dropped.
    auto full_count = static_cast<std::uint64_t>(seeds);
    refine_levels(growth, full, site.work, [&](std::int32_t level, double rho, const base::Progress& part) {
        // In a full tree of n marks, the mark with key k has children with the keys n + 4 k + {0, 1, 2, 3}.
        const auto key_of = [&](std::int64_t i) {
            return full_count + 4 * marks.key[i / 4] + static_cast<std::uint64_t>(i % 4);
        };
        const auto start_of = [&](std::int64_t i) {
            return marks.position[i / 4] +
                   rho * stipple_offset(marks.normal[i / 4], i % 4, site.random_seed, key_of(i));
        };
        const auto append = [&](const base::Progress&) {
            for (std::int64_t i = 0; i < growth.child.size(); ++i)
                if (growth.projector.placed(i))
                    append_stipple(growth.projector.position(i), growth.projector.normal(i), key_of(growth.child[i]),
                                   marks.stroke[growth.child[i] / 4], level, marks);
        };
        // The largest distance of a start from its parent. If a child lands farther from its start than this, it is on
        // another part of the surface.
        const double stray_limit = std::sqrt(2.0) * (1.0 + jitter) * rho;
        const bool cut = refine_level(growth, level, stray_limit, key_of, start_of, append, part);
        full_count *= 5;
        return cut;
    });
}

void grow_strokes(const marks::Site& site, const Start& start, const GrowthSettings& settings, marks::Marks& marks,
                  marks::LayerReport& report) {
    Growth growth{site, settings, marks, report, marks::Kind::hatch, 2};
    const std::int64_t seeds = direction_count * start.position.size();
    report.full_count = marks::grown_count(direction_count * start.full_count, 3, settings.levels);
    report.step = settings.step;
    marks::require_room(settings.layer, marks::grown_count(seeds, 3, settings.levels), settings.levels,
                        settings.budget);
    const auto work = static_cast<double>(marks::grown_count(1, 3, settings.levels));
    const base::Work first = site.work.part(0.0, 1.0 / work);
    const base::Array<surface::Curvature> at_seeds = measure_curvatures(growth, start.position, start.normal, first);
    // A seed is the middle of its stroke. Stroke i belongs to direction set i % 2.
    const bool full = place_seeds(
        growth, seeds, [](std::int64_t i) { return stroke_key(static_cast<std::uint32_t>(i), 0); },
        [&](std::int64_t i) {
            append_stroke_mark(growth, start.position[i / direction_count], start.normal[i / direction_count],
                               static_cast<std::uint32_t>(i), 0, 0, at_seeds[i / direction_count], glm::dvec3(0.0));
        },
        first);
    geometry::VecArray landed(site.memory());
    geometry::VecArray landed_normal(site.memory());
    refine_levels(growth, full, site.work, [&](std::int32_t level, double rho, const base::Progress& part) {
        // A position along a stroke is counted in steps of the finest requested level. Each mark has one child behind
        // it and one child ahead of it.
        const auto finest = static_cast<std::int32_t>(marks::grown_count(1, 3, settings.levels - level));
        const auto place_of = [&](std::int64_t i) { return marks.place[i / 2] + (i % 2 == 0 ? -finest : finest); };
        const auto key_of = [&](std::int64_t i) { return stroke_key(marks.stroke[i / 2], place_of(i)); };
        const auto start_of = [&](std::int64_t i) {
            const double s = i % 2 == 0 ? -rho : rho;
            const glm::dvec3 d = marks.direction[i / 2];
            return marks.position[i / 2] +
                   (growth.by_curvature()
                        ? on_osculating_circle(s, marks.curvature_along[i / 2], d, marks.normal[i / 2])
                        : s * d);
        };
        const auto append = [&](const base::Progress& rest) {
            landed.clear();
            landed_normal.clear();
            std::int64_t placed = 0;
            for (std::int64_t i = 0; i < growth.child.size(); ++i) {
                if (!growth.projector.placed(i)) continue;
                landed.push_back(growth.projector.position(i));
                landed_normal.push_back(growth.projector.normal(i));
                growth.child[placed++] = growth.child[i];
            }
            const base::Array<surface::Curvature> curvature = measure_curvatures(growth, landed, landed_normal, rest);
            for (std::int64_t k = 0; k < placed; ++k) {
                const std::int64_t parent = growth.child[k] / 2;
                append_stroke_mark(growth, landed[k], landed_normal[k], marks.stroke[parent], place_of(growth.child[k]),
                                   level, curvature[k], marks.direction[parent]);
            }
        };
        // If a child lands farther from its start than a step, it is on another part of the surface.
        return refine_level(growth, level, rho, key_of, start_of, append, part);
    });
    // Positions were numbered for all requested levels. They are renumbered for the levels that were grown.
    const auto unused = static_cast<std::int32_t>(marks::grown_count(1, 3, settings.levels - report.levels));
    const auto middle = static_cast<std::int32_t>((marks::grown_count(1, 3, report.levels) - 1) / 2);
    for (std::int32_t& place : marks.place) place = place / unused + middle;
}

} // namespace hrbfnpr::published
