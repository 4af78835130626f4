// SPDX-License-Identifier: MIT
#include "orient/normals_of_cloud.h"

#include "orient/coarser.h"
#include "orient/means.h"
#include "orient/noisy_normals.h"
#include "orient/ridge_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

constexpr std::int64_t neighbours = 32;
// Clouds with more noise, in spacings, are replaced by means of so many points that it is less.
constexpr double noisiest = 0.55;
// ... which are so many deviations apart: nearer, they would be layers of the noise.
constexpr double means_apart = 2.0;
constexpr std::int64_t fewest_to_reduce = 6000;
constexpr std::int64_t fewest_means = 500;
constexpr int most_reductions = 3;
// Of noisy clouds with fewer the shape is no larger than what directions would be means over.
constexpr std::int64_t fewest_to_refine = 400;

// Fewer starts of more places.
constexpr std::int64_t few_points = 6000;
// Noisy ones with no more are fitted with several ridges.
constexpr std::int64_t few_for_path = 2000;
constexpr double smoothed_over = 1.5; // spacings
constexpr std::int64_t many = 150000;

constexpr Effort path_effort{3, false, true};

// Energies: see noise.cpp.
constexpr double sure_below = 0.012;
constexpr double no_order = 0.03;
// Without noise twice as many points along curves have 0.8 of the energy and less.
constexpr double falling = 1.2;
constexpr double signs_of_level = 0.97; // share of equal ones
// How far starts agree that need no warning.
constexpr double agreed = 0.9;
// Share of signs that change with the ridge: confidence falls by e with every so many.
constexpr double unsteady = 0.03;

[[nodiscard]] Effort effort_for(std::int64_t count) noexcept {
    if (count <= few_points) return {6, true, true};
    return {count <= many ? 3 : 1, false, count <= many};
}

// With less of a ridge the signs should be the same: they are not where walls are as thin as the noise.
constexpr double softer = 0.125;

[[nodiscard]] double sign_stability(const base::Runtime& runtime, const Cloud& cloud, const Near& near,
                                    const LeastEnergy& fitted, double ridge, const base::Progress& progress) {
    if (ridge == 0.0 || cloud.size() > few_points) return 1.0;
    const LeastEnergy other = least_energy(runtime, *cloud.tree, cloud.rank, near, softer * ridge, nullptr,
                                           {1, false, false}, progress.part(0.0, 0.0));
    return std::max(0.0, 2.0 * share_alike(fitted.normal, other.normal) - 1.0);
}

[[nodiscard]] double confidence_of(const LeastEnergy& fitted, double energy, double noise) noexcept {
    const double order = std::clamp((no_order - energy) / (no_order - sure_below), 0.0, 1.0);
    const double agreement = std::clamp(fitted.agreement, 0.0, 1.0);
    return agreement * agreement * order * std::exp(-1.5 * noise * noise);
}

// Starts that disagree, and signs that change with the ridge, were wrong signs more often than not; and a sheet as
// noisy may be a wall of three deviations.
[[nodiscard]] double confidence_of(const RidgeFit& found, double noise) noexcept {
    const double agreement = std::clamp(found.fitted.agreement, 0.0, 1.0);
    return confidence_of(found.fitted, found.roughest, noise) * agreement * agreement *
           std::exp(-(1.0 - found.steadiness) / unsteady - 0.5 * noise * noise);
}

// Of points along curves, the coarser cloud whose normals are to stay; null: none.  Noise has the more energy the
// nearer points are to each other, and directions that are off by it: if that of all points is no less than that of
// fewer, it is the one of least energy whose signs are those of these.  Where starts disagree on all points it is the
// finest that they agree on.
[[nodiscard]] Begin* to_stay(std::vector<Begin>& coarser, double energy, double confidence) noexcept {
    const auto least = std::min_element(coarser.begin(), coarser.end(),
                                        [](const Begin& a, const Begin& b) { return a.own_energy() < b.own_energy(); });
    if (least->own_energy() < falling * energy) {
        Begin* best = &*least;
        for (Begin& level : coarser)
            if (level.energy < best->energy && share_alike(level.normal, least->normal) > signs_of_level) best = &level;
        return best;
    }
    if (confidence > doubtful) return nullptr;
    const auto sure =
        std::find_if(coarser.rbegin(), coarser.rend(), [](const Begin& level) { return level.agreement > agreed; });
    return sure != coarser.rend() ? &*sure : nullptr;
}

void stay(Begin& level, CloudNormals& result) {
    result.fitted.normal = std::move(level.normal);
    result.fitted.energy = level.energy;
    result.fitted.agreement = level.agreement;
    result.confidence = level.agreement * level.agreement;
}

// Points along curves.  Of many the coarser clouds are enough.
void fit_curves(const base::Runtime& runtime, const Cloud& cloud, const Near& near, const VecArray* given,
                CloudNormals& result, const base::Progress& progress) {
    std::vector<Begin> coarser = begin_from_coarser(runtime, cloud, few_points, progress.part(0.0, 0.5));
    if (cloud.size() > few_points) {
        stay(*to_stay(coarser, std::numeric_limits<double>::infinity(), 0.0), result);
        return;
    }
    Effort effort = effort_for(cloud.size());
    effort.begin = &coarser.back();
    result.fitted = least_energy(runtime, *cloud.tree, cloud.rank, near, 0.0, given, effort, progress.part(0.5, 1.0));
    result.confidence = confidence_of(result.fitted, result.fitted.energy, 0.0);
    Begin* const level = to_stay(coarser, result.fitted.energy * cloud.apart[cloud.size() / 2], result.confidence);
    if (level != nullptr) stay(*level, result);
}

// Fits the cloud as its noise calls for.
void fit(const base::Runtime& runtime, const Cloud& cloud, const Near& near, const Noise& noise, const VecArray* given,
         CloudNormals& result, const base::Progress& progress) {
    if (is_of_curves(cloud)) {
        fit_curves(runtime, cloud, near, given, result, progress);
        return;
    }
    if (noise.ridge == 0.0 || cloud.size() > few_for_path) {
        result.fitted = least_energy(runtime, *cloud.tree, cloud.rank, near, noise.ridge, given,
                                     effort_for(cloud.size()), progress);
        result.confidence = confidence_of(result.fitted, result.fitted.energy, noise.deviation) *
                            sign_stability(runtime, cloud, near, result.fitted, noise.ridge, progress);
        return;
    }
    RidgeFit found = follow_ridges(runtime, cloud, near, noise.ridge, given, path_effort, progress);
    result.confidence = confidence_of(found, noise.deviation);
    runtime.log(base::LogLevel::debug, "orient: energy %.4f, agreement %.3f, steadiness %.3f, noise %.3f, ridge %.0f",
                found.roughest, found.fitted.agreement, found.steadiness, noise.deviation, noise.ridge);
    found.fitted.normal = smooth_directions(runtime, *cloud.tree, near, found.fitted.normal, smoothed_over);
    result.fitted = std::move(found.fitted);
}

} // namespace

CloudNormals normals_of_cloud(const base::Runtime& runtime, const Cloud& cloud, const Near& near, const VecArray* given,
                              const base::Progress& progress) {
    CloudNormals result(runtime.memory);
    Noise noise = measure_noise(runtime, cloud, progress.part(0.0, 0.1));
    progress.update(0.1);
    result.noise = noise.deviation;
    if (noise.deviation <= noisiest || cloud.size() <= fewest_to_reduce || is_of_curves(cloud)) {
        fit(runtime, cloud, near, noise, given, result, progress.part(0.1, 0.95));
        if (noise.ridge > 0.0 && cloud.size() >= fewest_to_refine && cloud.size() <= fewest_to_reduce)
            refine_noisy(runtime, *cloud.tree, result.fitted.normal, progress.part(0.95, 1.0));
        progress.update(1.0);
        return result;
    }
    Cloud means(runtime.memory);
    const Cloud* last = &cloud;
    for (int k = 0; k < most_reductions && noise.deviation > noisiest && last->size() > fewest_to_reduce; ++k) {
        const std::int64_t count =
            std::partition_point(last->apart.begin(), last->apart.end(),
                                 [&](double distance) { return distance > means_apart * noise.deviation; }) -
            last->apart.begin();
        // In the coordinates of the cloud that all began with.
        const glm::dvec3 centre = k == 0 ? glm::dvec3(0.0) : last->centre;
        const double spacing = k == 0 ? 1.0 : last->spacing;
        means = means_of(runtime, *last, std::max(fewest_means, count), progress);
        means.centre = centre + spacing * means.centre;
        means.spacing *= spacing;
        last = &means;
        noise = measure_noise(runtime, means, progress.part(0.1, 0.2));
        runtime.log(base::LogLevel::debug, "orient: %lld means have a noise of %.2f spacings",
                    static_cast<long long>(means.size()), noise.deviation);
    }
    const Near near_means(runtime, *means.tree, neighbours, progress);
    fit(runtime, means, near_means, noise, nullptr, result, progress.part(0.2, 0.95));
    result.fitted.normal = normals_by_means(runtime, cloud, means, result.fitted.normal, progress.part(0.95, 1.0));
    result.fitted.form.reset(); // it is the means'
    progress.update(1.0);
    return result;
}

} // namespace hrbfnpr::orient
