// SPDX-License-Identifier: MIT
#include "marks/site.h"

#include "geometry/long_vec_array.h"
#include "implicit/evaluate_all.h"

#include <cmath>

namespace hrbfnpr::marks {

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
    if (site_.implicit.extent() == nullptr) return;
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

} // namespace hrbfnpr::marks
