// SPDX-License-Identifier: MIT
#include "geometry/farthest_order.h"
#include "orient/least_energy.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

// Energies per degree of freedom of clean clouds are 1e-7 (smooth) to 0.006 (sharp edges), of noisy ones above 0.018,
// and 0.026 of points without any order.
constexpr double clean_below = 0.012;
// ... but of clean ones much too thin for their spacing, too.  Other signs have a higher energy there, and one as low
// where the noise decides.
constexpr double no_order_above = 0.02;
constexpr double noisy_rival = 1.05;
constexpr double same_signs = 0.9;
// The ridge is the least of 10, 10^1.5, ... with less.
constexpr double settled_below = 0.0025;
constexpr double first_ridge = 10.0;
constexpr double factor = 3.1622776601683795;
constexpr int most_ridges = 11;

// Fewer places get more starts: by three of them rivals may be missed.
constexpr std::int64_t few = 1500;
constexpr std::int64_t fewest_to_measure = 48;
constexpr std::int64_t patch_size = 2048;
constexpr int patches = 3;

struct Patch {
    std::unique_ptr<geometry::PointTree> tree;
    base::Array<std::int64_t> rank;
};

// Consecutive places lie together.
[[nodiscard]] Patch patch_at(const base::Runtime& runtime, const Cloud& cloud, std::int64_t begin, std::int64_t end,
                             const base::Progress& progress) {
    geometry::VecArray position(runtime.memory);
    for (std::int64_t at = begin; at < end; ++at) position.push_back(cloud.point(at));
    Patch patch{std::make_unique<geometry::PointTree>(position, progress), base::Array<std::int64_t>(runtime.memory)};
    const geometry::FarthestOrder order = geometry::farthest_order(patch.tree->points(), 0, base::Progress());
    patch.rank.resize(patch.tree->size());
    for (std::int64_t k = 0; k < order.order.size(); ++k) patch.rank[order.order[k]] = k;
    return patch;
}

[[nodiscard]] Noise noise_of(const base::Runtime& runtime, const geometry::PointTree& tree,
                             const base::Array<std::int64_t>& rank, const base::Progress& progress) {
    const base::Progress unseen = progress.part(0.0, 0.0);
    const Near near(runtime, tree, 32, progress);
    LeastEnergy clean = least_energy(runtime, tree, rank, near, 0.0, nullptr, {2, true, true}, unseen);
    if (clean.energy < clean_below) return {};
    if (tree.size() < few) clean = least_energy(runtime, tree, rank, near, 0.0, nullptr, {6, true, true}, unseen);
    const bool clear = clean.rival > noisy_rival;
    if (clean.energy < clean_below || (clean.energy > no_order_above && clear)) return {};
    LeastEnergy fitted(runtime.memory);
    Noise noise;
    noise.ridge = first_ridge;
    for (int k = 1; k < most_ridges; ++k, noise.ridge *= factor) {
        fitted = least_energy(runtime, tree, rank, near, noise.ridge, nullptr, {1, true, false}, unseen);
        runtime.log(base::LogLevel::debug, "orient: ridge %.0f: energy %.4f", noise.ridge, fitted.energy);
        if (fitted.energy < settled_below) break;
    }
    // Few points of thin tubes, whose signs were clear, and are lost by a ridge.
    if (clear && share_alike(clean.normal, fitted.normal) < same_signs) return {};
    noise.deviation = std::sqrt(noise.ridge * fitted.energy);
    return noise;
}

} // namespace

Noise measure_noise(const base::Runtime& runtime, const Cloud& cloud, const base::Progress& progress) {
    if (cloud.size() < fewest_to_measure) return {};
    if (cloud.size() <= 2 * patch_size) return noise_of(runtime, *cloud.tree, cloud.rank, progress);
    std::array<Noise, patches> found;
    for (int k = 0; k < patches; ++k) {
        const std::int64_t begin = (2 * k + 1) * (cloud.size() - patch_size) / (2 * patches);
        const Patch patch = patch_at(runtime, cloud, begin, begin + patch_size, progress);
        found[static_cast<std::size_t>(k)] = noise_of(runtime, *patch.tree, patch.rank, progress);
    }
    std::sort(found.begin(), found.end(), [](const Noise& a, const Noise& b) { return a.deviation < b.deviation; });
    return found[patches / 2];
}

} // namespace hrbfnpr::orient
