// SPDX-License-Identifier: MIT
// The steps are:
//
//   measure_noise      finds the regularization that lowers the energy of the cloud, or of patches of it, enough
//   reduced            replaces the points of a large cloud by means, if the noise is large compared with their spacing
//   fit_even           fits clean points, or many noisy points: finds the least energy with that regularization
//   fit_noisy          fits few noisy points: finds the least energy as regularization rises, then averages directions
//   fit_curves         fits points along curves: finds the least energy of a few points, then of twice as many, and so
//                      on up to all points; each search starts from the normals of the search before
//   confidence_of      measures how well starts, regularizations and coarser clouds agree
#include "orient/normals_of_cloud.h"

#include "base/assert.h"
#include "geometry/farthest_order.h"
#include "orient/noisy_clouds.h"
#include "orient/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

constexpr double ridge_factor = 3.1622776601683795; // half a power of ten: sqrt(10)

// ---- Noise

struct Noise {
    double deviation = 0.0; // the standard deviation of the noise, in spacings
    double ridge = 0.0;     // the regularization for this noise; 0 for a clean cloud
};

// Returns places that follow each other in the order of the tree. They are close to each other in space.
[[nodiscard]] OrderedPoints patch_at(const base::Work& work, const Cloud& cloud, std::int64_t begin, std::int64_t end) {
    VecArray position(work.memory);
    for (std::int64_t at = begin; at < end; ++at) position.push_back(cloud.point(at));
    OrderedPoints patch(work.memory);
    patch.tree = std::make_unique<geometry::PointTree>(position, work);
    const geometry::FarthestOrder order = geometry::farthest_order(patch.tree->points(), 0, base::Progress());
    patch.rank.resize(patch.size());
    for (std::int64_t k = 0; k < patch.size(); ++k) patch.rank[order.order[k]] = k;
    return patch;
}

[[nodiscard]] Noise noise_of(const base::Work& work, const OrderedPoints& places) {
    const NeighbourLists near(work, *places.tree, tuning.most_neighbours);
    const auto fit = [&](double ridge, const StartOptions& options) {
        return least_energy(work.without_progress(), places, near, ridge, nullptr, options);
    };
    LeastEnergy clean = fit(0.0, {2, true, true});
    if (clean.energy < tuning.clean_below) return {};
    if (places.size() < tuning.few_to_measure) clean = fit(0.0, {6, true, true});
    const bool clear = clean.rival > tuning.noisy_rival;
    if (clean.energy < tuning.clean_below || (clean.energy > tuning.no_order_above && clear)) return {};
    LeastEnergy fitted(work.memory);
    Noise noise;
    noise.ridge = tuning.first_ridge;
    for (int k = 1; k < tuning.most_ridges; ++k, noise.ridge *= ridge_factor) {
        fitted = fit(noise.ridge, {1, true, false});
        work.runtime().log(base::LogLevel::debug, "orient: ridge %.0f: energy %.4f", noise.ridge, fitted.energy);
        if (fitted.energy < tuning.settled_below) break;
    }
    // Where few points lie on thin tubes, regularization changes signs that are certain without it. The cloud then
    // counts as clean.
    if (clear && share_alike(clean.normal, fitted.normal) < tuning.same_signs) return {};
    noise.deviation = std::sqrt(noise.ridge * fitted.energy);
    return noise;
}

[[nodiscard]] Noise measure_noise(const base::Work& work, const Cloud& cloud) {
    if (cloud.size() < tuning.fewest_to_measure) return {};
    if (cloud.size() <= 2 * tuning.patch_size) return noise_of(work, cloud);
    constexpr int patches = 3;
    std::array<Noise, patches> found;
    for (int k = 0; k < patches; ++k) {
        const std::int64_t begin = (2 * k + 1) * (cloud.size() - tuning.patch_size) / (2 * patches);
        found[static_cast<std::size_t>(k)] = noise_of(work, patch_at(work, cloud, begin, begin + tuning.patch_size));
    }
    std::sort(found.begin(), found.end(), [](const Noise& a, const Noise& b) { return a.deviation < b.deviation; });
    return found[patches / 2];
}

// ---- Confidence

[[nodiscard]] double confidence_of(double agreement, double energy, double noise) noexcept {
    const double order = std::clamp((tuning.no_order - energy) / (tuning.no_order - tuning.clean_below), 0.0, 1.0);
    return agreement * agreement * order * std::exp(-1.5 * noise * noise);
}

// Returns a confidence that is low if starts disagree, or if signs change with the regularization: signs are then more
// often wrong than right. Noise lowers the confidence further, because a noisy sheet cannot be distinguished from a
// wall three standard deviations thick.
[[nodiscard]] double confidence_of(const RidgeFit& found, double noise) noexcept {
    const double agreement = std::clamp(found.fitted.agreement, 0.0, 1.0);
    return confidence_of(agreement, found.roughest, noise) * agreement * agreement *
           std::exp(-(1.0 - found.steadiness) / tuning.unsteady - 0.5 * noise * noise);
}

// ---- Points all over a surface

// Returns the effort of the search: the more places, the fewer starts.
[[nodiscard]] StartOptions start_options_for(std::int64_t count) noexcept {
    if (count <= tuning.few_points) return {6, true, true};
    return {count <= tuning.many_points ? 3 : 1, false, count <= tuning.many_points};
}

void fit_even(const base::Work& work, const Cloud& cloud, const NeighbourLists& near, const Noise& noise,
              const VecArray* given, CloudNormals& result) {
    const auto fit = [&](double ridge, const VecArray* begin, const StartOptions& options, const base::Progress& part) {
        return least_energy({work, part}, cloud, near, ridge, begin, options);
    };
    result.fitted = fit(noise.ridge, given, start_options_for(cloud.size()), work);
    result.confidence =
        confidence_of(std::clamp(result.fitted.agreement, 0.0, 1.0), result.fitted.energy, noise.deviation);
    if (noise.ridge == 0.0 || cloud.size() > tuning.few_points) return;
    // A lower regularization should give the same signs. If it gives other signs, walls are as thin as the noise, and
    // the confidence is lowered.
    const LeastEnergy other = fit(tuning.softer * noise.ridge, nullptr, {1, false, false}, work.without_progress());
    result.confidence *= std::max(0.0, 2.0 * share_alike(result.fitted.normal, other.normal) - 1.0);
}

void fit_noisy(const base::Work& work, const Cloud& cloud, const NeighbourLists& near, const Noise& noise,
               const VecArray* given, CloudNormals& result) {
    RidgeFit found = follow_ridges(work, cloud, near, noise.ridge, given, {3, false, true});
    result.confidence = confidence_of(found, noise.deviation);
    work.runtime().log(base::LogLevel::debug,
                       "orient: energy %.4f, agreement %.3f, steadiness %.3f, noise %.3f, ridge %.0f", found.roughest,
                       found.fitted.agreement, found.steadiness, noise.deviation, noise.ridge);
    found.fitted.normal = smooth_directions(work, *cloud.tree, near, found.fitted.normal, tuning.smoothed_over);
    result.fitted = std::move(found.fitted);
}

// ---- Points along curves

// Returns normals at the points of a finer tree. Each is the mean of the normals at the three nearest first places,
// weighted by the inverse squares of their distances.
[[nodiscard]] VecArray blend(const base::Work& work, const CoarsePoints& first, const VecArray& normal,
                             const geometry::PointTree& finer) {
    constexpr std::size_t blended = 3;
    VecArray all(work.memory, finer.size());
    for_places(work, finer.size(), [&](std::int64_t at) {
        std::array<std::int64_t, blended> found;
        const glm::dvec3 p = finer.points()[at];
        const auto any = [](std::int64_t /*place*/) { return true; };
        const auto there = static_cast<std::size_t>(first.tree->nearest(p, blended, any, any, found.data()));
        glm::dvec3 sum(0.0);
        for (std::size_t k = 0; k < there; ++k) {
            const glm::dvec3 between = first.point(found[k]) - p;
            sum += normal[found[k]] / std::max(glm::dot(between, between), 1e-12);
        }
        const double length = glm::length(sum);
        all.set(at, length > 0.0 ? sum / length : normal[found[0]]);
    });
    return all;
}

// Returns the normals of least energy of ever denser levels of points. The first level has the first `spread_count`
// points, which spread over the whole surface. Each later level has twice as many points and starts from the normals of
// the level before. Without noise, the energy falls as points become denser. With noise it rises, because the noise is
// interpolated.
[[nodiscard]] std::vector<CoarseStart> begin_from_coarser(const base::Work& work, const Cloud& cloud) {
    std::vector<CoarseStart> levels;
    const std::int64_t most = std::min(cloud.size(), tuning.few_points);
    for (std::int64_t count = cloud.spread_count; 3 * count < 2 * most; count *= 2) {
        const CoarsePoints level(work, cloud, count);
        CoarseStart begin(work.memory);
        StartOptions options{6, true, true};
        if (!levels.empty()) {
            begin.normal = level.pick(levels.back().normal);
            begin.agreement = levels.back().agreement;
            options = {2, false, false, &begin};
        }
        const NeighbourLists near(work, *level.tree, tuning.most_neighbours);
        const LeastEnergy found = least_energy(work.without_progress(), level, near, 0.0, nullptr, options);
        CoarseStart& reached = levels.emplace_back(work.memory);
        reached.normal = blend(work, level, found.normal, *cloud.tree);
        reached.energy = found.energy;
        reached.spacing = cloud.rank_spacing[count / 2];
        reached.agreement = found.agreement;
    }
    HRBFNPR_ASSERT(!levels.empty());
    return levels;
}

// Returns the coarser cloud whose normals are better than those of all points, or null. It starts with the coarser
// cloud of least energy at unit spacing. It then prefers a coarser cloud that has less energy and nearly the same
// signs. With noise, a denser cloud has more energy, and its directions vary more.
[[nodiscard]] CoarseStart* start_to_keep(std::vector<CoarseStart>& coarser, double energy) noexcept {
    const auto least = std::min_element(coarser.begin(), coarser.end(), [](const CoarseStart& a, const CoarseStart& b) {
        return a.energy_at_unit_spacing() < b.energy_at_unit_spacing();
    });
    if (least->energy_at_unit_spacing() >= tuning.falling * energy) return nullptr;
    CoarseStart* best = &*least;
    for (CoarseStart& level : coarser)
        if (level.energy < best->energy && share_alike(level.normal, least->normal) > tuning.signs_of_level)
            best = &level;
    return best;
}

// A large cloud is fitted through its coarser clouds only.
void fit_curves(const base::Work& work, const Cloud& cloud, const NeighbourLists& near, const VecArray* given,
                CloudNormals& result) {
    std::vector<CoarseStart> coarser = begin_from_coarser(work.part(0.0, 0.5), cloud);
    double energy = std::numeric_limits<double>::infinity();
    if (cloud.size() <= tuning.few_points) {
        StartOptions options = start_options_for(cloud.size());
        options.begin = &coarser.back();
        result.fitted = least_energy(work.part(0.5, 1.0), cloud, near, 0.0, given, options);
        result.confidence = confidence_of(std::clamp(result.fitted.agreement, 0.0, 1.0), result.fitted.energy, 0.0);
        energy = result.fitted.energy * cloud.rank_spacing[cloud.size() / 2];
    }
    CoarseStart* const level = start_to_keep(coarser, energy);
    if (level == nullptr) return;
    result.fitted.normal = std::move(level->normal);
    result.fitted.energy = level->energy;
    result.fitted.agreement = level->agreement;
    result.confidence = level->agreement * level->agreement;
}

void fit(const base::Work& work, const Cloud& cloud, const NeighbourLists& near, const Noise& noise,
         const VecArray* given, CloudNormals& result) {
    if (cloud.is_of_curves())
        fit_curves(work, cloud, near, given, result);
    else if (noise.ridge > 0.0 && cloud.size() <= tuning.few_for_path)
        fit_noisy(work, cloud, near, noise, given, result);
    else
        fit_even(work, cloud, near, noise, given, result);
}

// Replaces the points by means, in the coordinates of the cloud. The spacing of the means suits their noise. Sets
// `noise` to the noise of the means.
[[nodiscard]] Cloud reduced(const base::Work& work, const Cloud& cloud, Noise& noise) {
    Cloud means(work.memory);
    const Cloud* last = &cloud;
    for (int k = 0; k < tuning.most_reductions && noise.deviation > tuning.noisiest && last->size() > tuning.few_points;
         ++k) {
        const std::int64_t count =
            std::partition_point(last->rank_spacing.begin(), last->rank_spacing.end(),
                                 [&](double distance) { return distance > tuning.means_apart * noise.deviation; }) -
            last->rank_spacing.begin();
        const glm::dvec3 centre = k == 0 ? glm::dvec3(0.0) : last->centre;
        const double spacing = k == 0 ? 1.0 : last->spacing;
        means = means_of(work, *last, std::max(tuning.fewest_means, count));
        means.centre = centre + spacing * means.centre;
        means.spacing *= spacing;
        last = &means;
        noise = measure_noise(work, means);
        work.runtime().log(base::LogLevel::debug, "orient: %lld means have a noise of %.2f spacings",
                           static_cast<long long>(means.size()), noise.deviation);
    }
    return means;
}

} // namespace

RidgeFit follow_ridges(const base::Work& work, const Cloud& cloud, const NeighbourLists& near, double most,
                       const VecArray* given, const StartOptions& options) {
    HRBFNPR_ASSERT(most > 0.0);
    double ridge = 1.0;
    RidgeFit best{least_energy(work.without_progress(), cloud, near, ridge, given, options)};
    best.roughest = best.fitted.energy;
    const auto next_fit = [&](const LeastEnergy& last) {
        work.update(std::log(ridge) / std::log(ridge_factor * most));
        ridge *= ridge_factor;
        return least_energy(work.without_progress(), cloud, near, ridge, &last.normal, {2, false, false});
    };
    const auto ends = [&](const LeastEnergy& last) {
        return last.energy < tuning.path_settled || ridge * ridge_factor > 1.01 * most;
    };
    while (best.fitted.energy > tuning.trusted_below && !ends(best.fitted)) best.fitted = next_fit(best.fitted);
    LeastEnergy last(work.memory);
    for (const LeastEnergy* before = &best.fitted; !ends(*before); before = &last) {
        last = next_fit(*before);
        const double alike = share_alike(last.normal, best.fitted.normal);
        best.steadiness = std::min(best.steadiness, alike);
        work.runtime().log(base::LogLevel::debug, "orient: ridge %.0f: energy %.4f, signs alike %.3f", ridge,
                           last.energy, alike);
        if (alike < tuning.path_same_signs) return best;
    }
    if (!last.normal.empty()) best.fitted = std::move(last);
    work.update(1.0);
    return best;
}

CloudNormals normals_of_cloud(const base::Work& work, const Cloud& cloud, const NeighbourLists& near,
                              const VecArray* given) {
    HRBFNPR_ASSERT(given == nullptr || given->size() == cloud.size());
    CloudNormals result(work.memory);
    Noise noise = measure_noise(work.part(0.0, 0.1), cloud);
    work.update(0.1);
    result.noise = noise.deviation;
    if (noise.deviation > tuning.noisiest && cloud.size() > tuning.few_points && !cloud.is_of_curves()) {
        const Cloud means = reduced(work.part(0.1, 0.2), cloud, noise);
        const NeighbourLists near_means(work, *means.tree, tuning.most_neighbours);
        fit(work.part(0.2, 0.95), means, near_means, noise, nullptr, result);
        result.fitted.normal = normals_by_means(work.part(0.95, 1.0), cloud, means, result.fitted.normal);
    } else {
        fit(work.part(0.1, 0.95), cloud, near, noise, given, result);
        if (noise.ridge > 0.0 && cloud.size() >= tuning.fewest_to_refine && cloud.size() <= tuning.few_points)
            refine_noisy(work.part(0.95, 1.0), *cloud.tree, result.fitted.normal);
    }
    work.update(1.0);
    return result;
}

} // namespace hrbfnpr::orient
