// SPDX-License-Identifier: MIT
#include "marks/site.h"

#include "geometry/long_vec_array.h"
#include "geometry/unit.h"
#include "implicit/evaluate_all.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::marks {
namespace {

constexpr std::int64_t call_size = 4096; // places that the caller's function is asked for at a time

} // namespace

void Settler::settle(double stray_limit, LevelReport& report, const base::Progress& progress) {
    const std::int64_t count = start.size();
    resize_long(projection_.position, count, progress);
    for (std::int64_t i = 0; i < count; ++i) projection_.position.set(i, start[i]);
    surface::ProjectionSettings settings;
    settings.tolerance = site_.projection_tolerance;
    surface::project(site_.runtime, site_.implicit, settings, projection_, progress);

    placed_.resize(count);
    report.attempted += count;
    for (std::int64_t i = 0; i < count; ++i) {
        placed_[i] = 0;
        switch (projection_.status[i]) {
        case surface::ProjectionStatus::not_converged: ++report.dropped_not_converged; continue;
        case surface::ProjectionStatus::zero_gradient:
        case surface::ProjectionStatus::not_finite: ++report.dropped_degenerate; continue;
        case surface::ProjectionStatus::converged: break;
        }
        if (glm::distance(projection_.position[i], start[i]) > stray_limit) {
            ++report.dropped_strayed;
            continue;
        }
        placed_[i] = 1;
        ++report.placed;
    }
    drop_beyond_end(report);
}

// Where the surface is not borne out by its samples.
void Settler::drop_beyond_end(LevelReport& report) {
    if (site_.implicit.domain() == nullptr) return;
    constexpr std::int64_t grain = 256;
    site_.runtime.parallel.for_chunks(placed_.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            if (placed_[i] != 0 && !site_.implicit.holds(projection_.position[i], projection_.gradient[i]))
                placed_[i] = beyond;
    });
    for (std::int64_t i = 0; i < placed_.size(); ++i)
        if (placed_[i] == beyond) drop(i, report.dropped_strayed, report);
}

glm::dvec3 Settler::normal(std::int64_t i) const noexcept { return glm::normalize(projection_.gradient[i]); }

void Settler::drop(std::int64_t i, std::int64_t& reason, LevelReport& report) noexcept {
    HRBFNPR_ASSERT(placed_[i] != 0 && report.placed > 0);
    placed_[i] = 0;
    --report.placed;
    ++reason;
}

void evaluate(const Site& site, const geometry::VecArray& points, FieldSamples& fields,
              const base::Progress& progress) {
    const std::int64_t count = points.size();
    fields.value.resize_for_overwrite(count);
    for (base::Array<double>* of : {&fields.gradient.x, &fields.gradient.y, &fields.gradient.z})
        of->resize_for_overwrite(count);
    implicit::FieldBatch all;
    all.value = fields.value.data();
    all.gradient = {fields.gradient.x.data(), fields.gradient.y.data(), fields.gradient.z.data()};
    implicit::evaluate_all(site.runtime, site.implicit, points, all, progress);
}

glm::dvec3 tangent_part(const glm::dvec3& d, const glm::dvec3& n) noexcept {
    const glm::dvec3 moderate = d / geometry::unit_for(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}));
    const glm::dvec3 tangent = moderate - glm::dot(moderate, n) * n;
    const double length = glm::length(tangent);
    return length > 1e-6 * glm::length(moderate) ? tangent / length : glm::dvec3(0.0);
}

void directions_at(const Site& site, const DirectionFunction& field, const geometry::VecArray& positions,
                   const geometry::VecArray& normals, geometry::VecArray& directions, const base::Progress& progress) {
    const std::int64_t all = positions.size();
    HRBFNPR_ASSERT(normals.size() == all && field.function != nullptr);
    directions.resize(all);
    progress.check();
    base::Array<double> packed(site.memory(), 9 * std::min(all, call_size));
    for (std::int64_t begin = 0; begin < all; begin += call_size) {
        progress.update(static_cast<double>(begin) / static_cast<double>(all));
        const std::int64_t count = std::min(call_size, all - begin);
        double* const places = packed.data();
        double* const sides = places + 3 * count;
        double* const result = sides + 3 * count;
        for (std::int64_t i = 0; i < count; ++i)
            for (int c = 0; c < 3; ++c) {
                places[3 * i + c] = site.unit * positions[begin + i][c];
                sides[3 * i + c] = normals[begin + i][c];
                result[3 * i + c] = 0.0;
            }
        if (const std::int32_t code = field.function(field.user, count, places, sides, result); code != 0)
            fail(Status::callback, "direction_function returned %d; it must return 0 unless it failed",
                 static_cast<int>(code));
        for (std::int64_t i = 0; i < count; ++i) {
            const glm::dvec3 d(result[3 * i], result[3 * i + 1], result[3 * i + 2]);
            if (!std::isfinite(d.x) || !std::isfinite(d.y) || !std::isfinite(d.z))
                fail(Status::callback,
                     "direction_function gave %g %g %g as a direction; it must be finite, or 0 0 0 where there is none",
                     d.x, d.y, d.z);
            directions.set(begin + i, tangent_part(d, normals[begin + i]));
        }
    }
}

void require_size(const char* what, double size, const char* remedy) {
    if (size >= smallest_size && size <= largest_size) return;
    fail(Status::invalid_argument,
         "%s %.3g across; marks are float and can be placed where that is from %g to %g: scale the %s, by about %.0g",
         what, size, smallest_size, largest_size, remedy, std::clamp(1.0 / size, 1e-300, 1e300));
}

} // namespace hrbfnpr::marks
