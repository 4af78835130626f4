// SPDX-License-Identifier: MIT
#include "generate/generate.h"

#include "base/assert.h"
#include "base/random.h"
#include "generate/tuning.h"
#include "marks/assemble.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::generate {
namespace {

// Projects starting points, chunk by chunk. A point becomes a seed if it lands within `stray_limit` of its start.
void settle_seeds(const marks::Site& site, const geometry::VecArray& start, double stray_limit, marks::Seeds& seeds) {
    HRBFNPR_ASSERT(stray_limit > 0.0);
    marks::MarkProjector projector(site);
    const auto share = [&](std::int64_t i) { return static_cast<double>(i) / static_cast<double>(start.size()); };
    for (std::int64_t begin = 0; begin < start.size(); begin += marks::chunk_size) {
        const std::int64_t end = std::min(start.size(), begin + marks::chunk_size);
        projector.start.clear();
        for (std::int64_t i = begin; i < end; ++i) projector.start.push_back(start[i]);
        projector.project(stray_limit, seeds.report, site.work.part(share(begin), share(end)));
        for (std::int64_t i = 0; i < projector.start.size(); ++i) {
            if (!projector.placed(i)) continue;
            seeds.position.push_back(projector.position(i));
            seeds.normal.push_back(projector.normal(i));
        }
    }
}

// Returns a random vector that is uniformly distributed in a ball of radius `longest`: a random direction (by
// Archimedes' cylinder) times the cube root of a random share of the volume.
glm::dvec3 in_ball(const std::array<double, 4>& u, double longest) noexcept {
    const double z = 2.0 * u[0] - 1.0;
    const double angle = 2.0 * 3.14159265358979323846 * u[1];
    const double flat = std::sqrt(std::max(0.0, 1.0 - z * z));
    return longest * std::cbrt(u[2]) * glm::dvec3(flat * std::cos(angle), flat * std::sin(angle), z);
}

// Makes seeds from a jittered grid in the box. A flat box (coplanar samples, or a single sample) gets one layer of
// cells.
void seeds_in_box(const marks::Site& site, const Settings& settings, std::int32_t resolution, marks::Seeds& seeds) {
    HRBFNPR_ASSERT(resolution > 0);
    const geometry::Bounds& bounds = site.implicit.bounds();
    const glm::dvec3 size = bounds.size();
    const double longest = std::max({size.x, size.y, size.z});
    const double side = (longest > 0.0 ? longest : site.implicit.diagonal()) / resolution;
    std::array<std::int64_t, 3> cells{};
    glm::dvec3 covered;
    for (int axis = 0; axis < 3; ++axis) {
        // If a side of the box is a whole number of cells long, up to rounding errors, this number of cells is used.
        std::int64_t& number = cells[static_cast<std::size_t>(axis)];
        number = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(size[axis] / side - 1e-9)));
        covered[axis] = side * static_cast<double>(number);
    }
    const glm::dvec3 corner = bounds.centre() - 0.5 * covered;
    geometry::VecArray start(site.memory());
    for (std::int64_t i = 0; i < cells[0] * cells[1] * cells[2]; ++i) {
        const std::int64_t row = i / cells[0];
        const glm::dvec3 cell(static_cast<double>(i % cells[0]), static_cast<double>(row % cells[1]),
                              static_cast<double>(row / cells[1]));
        const auto random = base::uniform4(site.random_seed, static_cast<std::uint64_t>(i), base::Purpose::box_jitter);
        start.push_back(corner + side * (cell + 0.5) + in_ball(random, settings.seeds.box_jitter * side));
    }
    seeds.step = std::sqrt(3.0) * side; // the article's "voxel diameter"
    settle_seeds(site, start, seeds.step, seeds);
}

// Makes seeds from samples or from given points. These are on the surface or near it, because a smoothed fit may not
// pass through its samples. So they are projected like all seeds, with the model's diagonal as the limit. The article's
// step is the mean diameter of empty balls. For each seed, the ball touches the seed and its nearest neighbour at the
// ends of a diameter, and has no seed inside. So the step is the mean distance to the nearest neighbour.
void seeds_at(const marks::Site& site, const geometry::VecArray& start, marks::Seeds& seeds) {
    settle_seeds(site.part(0.0, 0.9), start, site.implicit.diagonal(), seeds);
    const double mean = marks::neighbour_distances(site.work.part(0.9, 1.0), seeds.position).mean;
    seeds.step = mean > 0.0 ? mean : generate_tuning.step_of_one_seed * site.implicit.diagonal();
}

[[nodiscard]] geometry::VecArray given_points(const marks::Site& site, const base::InView& points) {
    if (points.empty())
        fail(Status::invalid_argument, "seed_points is empty; seed_source POINTS needs at least one point");
    const geometry::Bounds near =
        site.implicit.bounds().grown(generate_tuning.farthest_seed * site.implicit.diagonal());
    geometry::VecArray given(site.memory());
    for (std::int64_t i = 0; i < points.count; ++i) {
        const glm::dvec3 p(points.get(i, 0), points.get(i, 1), points.get(i, 2));
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            fail(Status::invalid_argument, "seed_points[%lld] is not finite; remove it", static_cast<long long>(i));
        if (!near.contains(p))
            fail(Status::invalid_argument,
                 "seed_points[%lld] is more than %g diagonals away from the model's bounding box; remove it",
                 static_cast<long long>(i), generate_tuning.farthest_seed);
        given.push_back(p);
    }
    return given;
}

[[nodiscard]] geometry::VecArray sample_points(const marks::Site& site, const SampleHint& samples) {
    HRBFNPR_ASSERT(samples.position.size() % 3 == 0);
    geometry::VecArray points(site.memory());
    for (std::size_t i = 0; i + 2 < samples.position.size(); i += 3)
        points.push_back({samples.position[i], samples.position[i + 1], samples.position[i + 2]});
    return points;
}

[[nodiscard]] marks::SeedSource choose(const marks::Site& site, const SampleHint& samples, const Settings& settings) {
    if (settings.seeds.source != marks::SeedSource::automatic) return settings.seeds.source;
    if (samples.position.empty()) return marks::SeedSource::box;
    // BLUE_NOISE needs only one seed on each sheet of the surface. How the seeds are spread does not matter.
    if (settings.distribution == marks::Distribution::blue_noise) return marks::SeedSource::samples;
    const auto distances = marks::neighbour_distances(site.work, sample_points(site, samples));
    return distances.variation < generate_tuning.well_spread_variation ? marks::SeedSource::samples
                                                                       : marks::SeedSource::box;
}

} // namespace

marks::Seeds make_seeds(const marks::Site& site, const SampleHint& samples, const Settings& settings) {
    marks::Seeds seeds(site.memory());
    seeds.source = choose(site, samples, settings);
    const bool finer = settings.distribution == marks::Distribution::blue_noise &&
                       settings.seeds.source == marks::SeedSource::automatic;
    const std::int32_t resolution =
        finer ? std::max(settings.seeds.box_resolution, generate_tuning.automatic_box_resolution)
              : settings.seeds.box_resolution;
    switch (seeds.source) {
    case marks::SeedSource::samples:
        if (samples.position.empty())
            fail(Status::invalid_argument,
                 "seed_source is SAMPLES, which needs a model that is a fit; use AUTO or BOX");
        seeds_at(site, sample_points(site, samples), seeds);
        break;
    case marks::SeedSource::points: seeds_at(site, given_points(site, settings.seeds.points), seeds); break;
    case marks::SeedSource::automatic:
    case marks::SeedSource::box: seeds_in_box(site, settings, resolution, seeds); break;
    }
    const marks::LevelReport& r = seeds.report;
    if (seeds.position.empty())
        fail(Status::not_converged,
             "none of %lld seeds reached the surface (%lld did not converge, %lld strayed, %lld degenerate); give "
             "seed_points near the surface, or raise projection_tolerance or box_resolution",
             static_cast<long long>(r.attempted), static_cast<long long>(r.dropped_not_converged),
             static_cast<long long>(r.dropped_strayed), static_cast<long long>(r.dropped_degenerate));
    if (settings.seeds.initial_step > 0.0) seeds.step = settings.seeds.initial_step;
    return seeds;
}

} // namespace hrbfnpr::generate
