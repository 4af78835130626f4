// SPDX-License-Identifier: MIT
#include "generate/make_seeds.h"

#include "base/random.h"
#include "marks/assemble.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::generate {
namespace {

// Nearest-neighbour distances of a mesh's vertices vary by 0.2 to 0.4 of their mean, those of
// independent random points by 0.52: from there on samples are no "well distributed" seeds.
constexpr double well_spread_variation = 0.5;
// Marks of the blue-noise order are found from any point of each sheet: a finer grid misses fewer sheets.
constexpr std::int32_t automatic_box_resolution = 16;

// In diagonals from the bounds: beside such a distance floats would not tell the model's own marks apart.
constexpr double farthest_seed = 1e4;

// Collects what settles of a stream of starting points, a chunk at a time.
class Collector {
public:
    Collector(const marks::Site& site, marks::Seeds& seeds, double stray_limit, const base::Progress& progress)
        : settler_(site), seeds_(seeds), stray_limit_(stray_limit), progress_(progress) {}

    void add(const glm::dvec3& start, double fraction) {
        settler_.start.push_back(start);
        if (settler_.start.size() >= marks::chunk_size) flush(fraction);
    }
    void flush(double fraction) {
        settler_.settle(stray_limit_, seeds_.report, progress_.part(before_, fraction));
        before_ = fraction;
        for (std::int64_t i = 0; i < settler_.start.size(); ++i) {
            if (!settler_.placed(i)) continue;
            seeds_.position.push_back(settler_.position(i));
            seeds_.normal.push_back(settler_.normal(i));
        }
        settler_.start.clear();
    }

private:
    marks::Settler settler_;
    marks::Seeds& seeds_;
    double stray_limit_;
    base::Progress progress_;
    double before_ = 0.0;
};

// A random vector of length up to `longest`, uniform in that ball: a random direction
// (Archimedes' cylinder) times the cube root of a random share of the volume.
glm::dvec3 in_ball(const std::array<double, 4>& u, double longest) noexcept {
    const double z = 2.0 * u[0] - 1.0;
    const double angle = 2.0 * 3.14159265358979323846 * u[1];
    const double flat = std::sqrt(std::max(0.0, 1.0 - z * z));
    return longest * std::cbrt(u[2]) * glm::dvec3(flat * std::cos(angle), flat * std::sin(angle), z);
}

// A box of no thickness (coplanar samples, a single one) still gets one layer of cells.
struct Box {
    glm::dvec3 corner;
    double side;
    std::array<std::int64_t, 3> cells;
};

Box box_of(const implicit::Implicit& implicit, std::int32_t resolution) {
    const geometry::Bounds& bounds = implicit.bounds();
    const glm::dvec3 size = bounds.size();
    double longest = std::max({size.x, size.y, size.z});
    if (!(longest > 0.0)) longest = implicit.diagonal();
    Box box{};
    box.side = longest / resolution;
    glm::dvec3 covered;
    for (int axis = 0; axis < 3; ++axis) {
        // A side that is a whole number of cells up to rounding has that number of cells.
        const auto cells = static_cast<std::int64_t>(std::ceil(size[axis] / box.side - 1e-9));
        box.cells[static_cast<std::size_t>(axis)] = std::max<std::int64_t>(1, cells);
        covered[axis] = box.side * static_cast<double>(box.cells[static_cast<std::size_t>(axis)]);
    }
    box.corner = bounds.centre() - 0.5 * covered;
    return box;
}

void seeds_in_box(const marks::Site& site, const Settings& settings, std::int32_t resolution, marks::Seeds& seeds,
                  const base::Progress& progress) {
    const Box box = box_of(site.implicit, resolution);
    const double diagonal = std::sqrt(3.0) * box.side;
    Collector collector(site, seeds, diagonal, progress);
    const std::int64_t count = box.cells[0] * box.cells[1] * box.cells[2];
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t row = i / box.cells[0];
        const std::int64_t layer = row / box.cells[1];
        const glm::dvec3 cell(static_cast<double>(i % box.cells[0]), static_cast<double>(row % box.cells[1]),
                              static_cast<double>(layer));
        const glm::dvec3 jitter =
            in_ball(base::uniform4(site.random_seed, static_cast<std::uint64_t>(i), base::Purpose::box_jitter),
                    settings.seeds.box_jitter * box.side);
        collector.add(box.corner + box.side * (cell + 0.5) + jitter,
                      static_cast<double>(i + 1) / static_cast<double>(count));
    }
    collector.flush(1.0);
    seeds.step = diagonal; // "the voxel diameter"
}

// The average empty-ball diameter.  The largest ball that holds no seed inside and has a seed and its
// nearest neighbour as the ends of a diameter is as wide as their distance; so it is the mean of those.
double empty_ball_diameter(const marks::Site& site, const marks::Seeds& seeds, const base::Progress& progress) {
    const double mean = marks::neighbour_distances(site.runtime, seeds.position, progress).mean;
    return mean > 0.0 ? mean : 0.1 * site.implicit.diagonal(); // a single seed: about ten steps across
}

// Samples and given points lie on the surface or are meant to be near it, but a smoothed fit may
// pass the samples by: they are projected like all others, with the model's diagonal as the limit.
template <class PositionOf>
void seeds_at(const marks::Site& site, std::int64_t count, PositionOf position_of, marks::Seeds& seeds,
              const base::Progress& progress) {
    Collector collector(site, seeds, site.implicit.diagonal(), progress.part(0.0, 0.9));
    for (std::int64_t i = 0; i < count; ++i)
        collector.add(position_of(i), static_cast<double>(i + 1) / static_cast<double>(count));
    collector.flush(1.0);
    seeds.step = empty_ball_diameter(site, seeds, progress.part(0.9, 1.0));
}

void seeds_at_points(const marks::Site& site, const base::InView& points, marks::Seeds& seeds,
                     const base::Progress& progress) {
    if (points.empty())
        fail(Status::invalid_argument, "seed_points is empty: seed_source POINTS needs at least one point");
    const auto position = [&](std::int64_t i) {
        const glm::dvec3 p(points.get(i, 0), points.get(i, 1), points.get(i, 2));
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            fail(Status::invalid_argument, "seed_points[%lld] is not finite", static_cast<long long>(i));
        const geometry::Bounds near = site.implicit.bounds().grown(farthest_seed * site.implicit.diagonal());
        if (!near.contains(p))
            fail(Status::invalid_argument,
                 "seed_points[%lld] is more than %g diagonals away from the model's bounds: leave it out",
                 static_cast<long long>(i), farthest_seed);
        return p;
    };
    seeds_at(site, points.count, position, seeds, progress);
}

void seeds_at_samples(const marks::Site& site, const SampleHint& samples, marks::Seeds& seeds,
                      const base::Progress& progress) {
    if (samples.position.empty())
        fail(Status::invalid_argument, "seed_source SAMPLES needs a model that was fitted to samples: use AUTO or BOX");
    const double* p = samples.position.data();
    const auto position = [p](std::int64_t i) { return glm::dvec3(p[3 * i], p[3 * i + 1], p[3 * i + 2]); };
    seeds_at(site, static_cast<std::int64_t>(samples.position.size() / 3), position, seeds, progress);
}

bool well_spread(const marks::Site& site, const SampleHint& samples, const base::Progress& progress) {
    geometry::VecArray points(site.memory());
    for (std::size_t i = 0; i + 2 < samples.position.size(); i += 3)
        points.push_back({samples.position[i], samples.position[i + 1], samples.position[i + 2]});
    return marks::neighbour_distances(site.runtime, points, progress).variation < well_spread_variation;
}

marks::SeedSource choose(const marks::Site& site, const SampleHint& samples, const Settings& settings,
                         const base::Progress& progress) {
    if (settings.seeds.source != marks::SeedSource::automatic) return settings.seeds.source;
    if (samples.position.empty()) return marks::SeedSource::box;
    // The blue-noise order only needs a seed on each sheet; how the seeds are spread does not matter.
    if (settings.distribution == marks::Distribution::blue_noise) return marks::SeedSource::samples;
    return well_spread(site, samples, progress) ? marks::SeedSource::samples : marks::SeedSource::box;
}

void require_some(const marks::Seeds& seeds) {
    if (!seeds.position.empty()) return;
    const marks::LevelReport& r = seeds.report;
    fail(Status::not_converged,
         "none of %lld seeds reached the surface (%lld did not converge, %lld strayed, %lld degenerate): pass "
         "seed_points near the surface, or raise projection_tolerance or box_resolution",
         static_cast<long long>(r.attempted), static_cast<long long>(r.dropped_not_converged),
         static_cast<long long>(r.dropped_strayed), static_cast<long long>(r.dropped_degenerate));
}

} // namespace

marks::Seeds make_seeds(const marks::Site& site, const SampleHint& samples, const Settings& settings,
                        const base::Progress& progress) {
    marks::Seeds seeds(site.memory());
    seeds.source = choose(site, samples, settings, progress);
    const bool finer = settings.distribution == marks::Distribution::blue_noise &&
                       settings.seeds.source == marks::SeedSource::automatic;
    const std::int32_t resolution =
        finer ? std::max(settings.seeds.box_resolution, automatic_box_resolution) : settings.seeds.box_resolution;
    switch (seeds.source) {
    case marks::SeedSource::samples: seeds_at_samples(site, samples, seeds, progress); break;
    case marks::SeedSource::points: seeds_at_points(site, settings.seeds.points, seeds, progress); break;
    case marks::SeedSource::automatic:
    case marks::SeedSource::box: seeds_in_box(site, settings, resolution, seeds, progress); break;
    }
    require_some(seeds);
    if (settings.seeds.initial_step > 0.0) seeds.step = settings.seeds.initial_step;
    return seeds;
}

} // namespace hrbfnpr::generate
