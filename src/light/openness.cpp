// SPDX-License-Identifier: MIT
// 1. choose_samples: one place of each cell of a grid, for each of six directions of normals
// 2. open_at: a place → how much of the sky it sees, by rays
// 3. interpolate: a place → the mean of the samples around it, or nothing if they differ or are too few
#include "light/light.h"

#include "base/assert.h"
#include "geometry/point_grid.h"
#include "geometry/tangent_frame.h"
#include "light/cell_sort.h"
#include "light/tuning.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::light {
namespace {

using geometry::VecArray;

constexpr std::int64_t places_a_task = 256;

// ---- Samples

struct Samples {
    base::Array<std::int32_t> place; // the index of each sample's place, cell by cell
    double spacing = 0.0;
};

// Chooses at most about `wanted` samples. The number of cells falls with the square of their side.
[[nodiscard]] Samples choose_samples(const base::Work& work, const Places& places, std::int64_t wanted) {
    const geometry::Bounds bounds = bounds_of(places.position);
    Samples samples{base::Array<std::int32_t>(work.memory)};
    samples.spacing = bounds.diagonal() / std::sqrt(static_cast<double>(std::max<std::int64_t>(wanted, 1)));
    for (int round = 0; round < 3 && samples.spacing > 0.0; ++round) {
        const base::Array<InCell> sorted = sort_into_cells(
            work, places.position.size(), {bounds.min, samples.spacing},
            [&](std::int64_t i) { return places.position[i]; }, [&](std::int64_t i) { return places.normal[i]; });
        samples.place.clear();
        for (std::int64_t i = 0; i < sorted.size(); ++i)
            if (i == 0 || !sorted[i].is_with(sorted[i - 1]))
                samples.place.push_back(static_cast<std::int32_t>(sorted[i].index));
        const double share = static_cast<double>(samples.place.size()) / static_cast<double>(wanted);
        if (share > 0.7 && share < 1.2) break;
        samples.spacing *= std::clamp(std::sqrt(share), 0.25, 4.0);
    }
    return samples;
}

// ---- Rays

[[nodiscard]] double open_at(const geometry::Bvh& casters, const Places& places, const Sky& sky,
                             std::int64_t place) noexcept {
    const glm::dvec3 normal = places.normal[place];
    const glm::dvec3 u = geometry::any_perpendicular(normal);
    const glm::dvec3 v = glm::cross(normal, u);
    const glm::dvec3 origin = places.position[place] + places.offset * normal;
    // Directions follow a spiral of golden angles on a disc. Each place turns it by another angle.
    constexpr double golden = 2.399963229728653;
    const double turn =
        2.0 * std::numbers::pi * 0x1p-64 * static_cast<double>(geometry::hash_bits(static_cast<std::uint64_t>(place)));
    double hidden = 0.0;
    for (std::int32_t k = 0; k < sky.rays; ++k) {
        const double squared = (k + 0.5) / sky.rays;
        const double angle = turn + golden * k;
        const double r = std::sqrt(squared);
        const glm::dvec3 direction =
            r * std::cos(angle) * u + r * std::sin(angle) * v + std::sqrt(1.0 - squared) * normal;
        const geometry::Bvh::Hit hit = casters.first_hit(origin, direction, 0.0, sky.reach);
        if (hit.face >= 0) hidden += 1.0 - hit.t / sky.reach;
    }
    return 1.0 - hidden / sky.rays;
}

// ---- Interpolation

struct SampledSky {
    const VecArray& position; // the places of the samples, in the order of the grid
    const VecArray& normal;
    const base::Array<double>& open;
    const geometry::PointGrid& grid;
    double spacing;
};

// Returns the mean of the samples around a place, or a negative number if they are too few or differ.
[[nodiscard]] double interpolate(const SampledSky& sampled, const glm::dvec3& place, const glm::dvec3& normal) {
    const double reach = light_tuning.kernel * sampled.spacing;
    double weight = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    sampled.grid.around(place, [&](std::int64_t at) {
        const glm::dvec3 off = sampled.position[at] - place;
        const double near = 1.0 - glm::dot(off, off) / (reach * reach);
        const double cosine = glm::dot(sampled.normal[at], normal);
        if (!(near > 0.0) || !(cosine > light_tuning.least_cosine) ||
            std::abs(glm::dot(off, normal)) > light_tuning.off_plane * sampled.spacing)
            return;
        const double w = near * near * (cosine - light_tuning.least_cosine) / (1.0 - light_tuning.least_cosine);
        weight += w;
        sum += w * sampled.open[at];
        squares += w * sampled.open[at] * sampled.open[at];
    });
    if (!(weight > light_tuning.least_weight)) return -1.0;
    const double mean = sum / weight;
    const double variance = squares / weight - mean * mean;
    return variance > light_tuning.most_spread * light_tuning.most_spread ? -1.0 : mean;
}

} // namespace

base::Array<float> find_openness(const base::Work& work, const geometry::Bvh& casters, const Places& places,
                                 const Sky& sky) {
    HRBFNPR_ASSERT(places.position.size() == places.normal.size() && sky.reach > 0.0 && sky.rays > 0);
    const std::int64_t count = places.position.size();
    base::Array<float> open(work.memory, count);
    const base::Work first = work.part(0.0, 0.5);
    const base::Work second = work.part(0.5, 1.0);
    Samples samples{base::Array<std::int32_t>(work.memory)};
    if (count > 2 * sky.samples) samples = choose_samples(first, places, sky.samples);
    const std::int64_t sampled_count = samples.place.size();
    base::Array<double> of_sample(work.memory, sampled_count);
    VecArray position(work.memory);
    VecArray normal(work.memory);
    for (const std::int32_t place : samples.place) {
        position.push_back(places.position[place]);
        normal.push_back(places.normal[place]);
    }
    first.for_chunks(sampled_count, places_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) of_sample[i] = open_at(casters, places, sky, samples.place[i]);
    });
    if (sampled_count == 0) {
        second.for_chunks(count, places_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) open[i] = static_cast<float>(open_at(casters, places, sky, i));
        });
        return open;
    }
    const geometry::PointGrid grid(position, light_tuning.kernel * samples.spacing);
    const VecArray in_grid = grid.in_order(position);
    const VecArray normal_in_grid = grid.in_order(normal);
    base::Array<double> open_in_grid(work.memory, sampled_count);
    for (std::int64_t at = 0; at < sampled_count; ++at) open_in_grid[at] = of_sample[grid.index(at)];
    const SampledSky sampled{in_grid, normal_in_grid, open_in_grid, grid, samples.spacing};
    second.for_chunks(count, places_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const double mean = interpolate(sampled, places.position[i], places.normal[i]);
            open[i] = static_cast<float>(mean >= 0.0 ? mean : open_at(casters, places, sky, i));
        }
    });
    return open;
}

} // namespace hrbfnpr::light
