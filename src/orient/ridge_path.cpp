// SPDX-License-Identifier: MIT
#include "orient/ridge_path.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

constexpr double path_begin = 1.0;
constexpr double path_factor = 3.1622776601683795;
// With less energy per degree of freedom the ridge is high enough for the signs.
constexpr double trusted_below = 0.0095;
// ... and the directions are smooth.
constexpr double path_settled = 0.004;
// Share of equal signs.
constexpr double path_same_signs = 0.97;

} // namespace

RidgeFit follow_ridges(const base::Runtime& runtime, const Cloud& cloud, const Near& near, double most,
                       const VecArray* given, const Effort& effort, const base::Progress& progress) {
    const base::Progress unseen = progress.part(0.0, 0.0);
    RidgeFit best{least_energy(runtime, *cloud.tree, cloud.rank, near, path_begin, given, effort, unseen)};
    best.roughest = best.fitted.energy;
    double ridge = path_begin;
    const auto next_fit = [&](const LeastEnergy& last) {
        progress.update(std::log(ridge) / std::log(path_factor * most));
        ridge *= path_factor;
        return least_energy(runtime, *cloud.tree, cloud.rank, near, ridge, &last.normal, {2, false, false}, unseen);
    };
    const auto ends = [&](const LeastEnergy& last) {
        return last.energy < path_settled || ridge * path_factor > 1.01 * most;
    };
    while (best.fitted.energy > trusted_below && !ends(best.fitted)) best.fitted = next_fit(best.fitted);
    LeastEnergy last(runtime.memory);
    for (const LeastEnergy* before = &best.fitted; !ends(*before); before = &last) {
        last = next_fit(*before);
        const double alike = share_alike(last.normal, best.fitted.normal);
        best.steadiness = std::min(best.steadiness, alike);
        runtime.log(base::LogLevel::debug, "orient: ridge %.0f: energy %.4f, signs alike %.3f", ridge, last.energy,
                    alike);
        if (alike < path_same_signs) return best;
    }
    if (last.form != nullptr) best.fitted = std::move(last);
    progress.update(1.0);
    return best;
}

VecArray smooth_directions(const base::Runtime& runtime, const geometry::PointTree& tree, const Near& near,
                           const VecArray& normal, double deviation) {
    VecArray smooth(runtime.memory, tree.size());
    runtime.parallel.for_chunks(tree.size(), 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t at = begin; at < end; ++at) {
            const glm::dvec3 own = normal[at];
            glm::dvec3 sum = own;
            for (const std::int32_t other : near.of(at)) {
                const glm::dvec3 between = tree.points()[other] - tree.points()[at];
                const double alike = glm::dot(own, normal[other]);
                if (alike > 0.0)
                    sum +=
                        alike * std::exp(-0.5 * glm::dot(between, between) / (deviation * deviation)) * normal[other];
            }
            smooth.set(at, glm::normalize(sum));
        }
    });
    return smooth;
}

} // namespace hrbfnpr::orient
