// SPDX-License-Identifier: MIT
#include "orient/coarser.h"

#include "geometry/along_curves.h"

#include <algorithm>
#include <array>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

constexpr std::int64_t coarsest = 64;
constexpr std::int64_t neighbours_of_first = 32;
constexpr std::int64_t blended_of_first = 3;

// By the inverse squares of the distances to the nearest.
glm::dvec3 blend_at(const geometry::PointTree& tree, const VecArray& normal, const glm::dvec3& p) noexcept {
    std::array<std::int64_t, static_cast<std::size_t>(blended_of_first)> found;
    const auto any = [](std::int64_t /*at*/) { return true; };
    const auto there = static_cast<std::size_t>(tree.nearest(p, blended_of_first, any, any, found.data()));
    glm::dvec3 sum(0.0);
    for (std::size_t k = 0; k < there; ++k) {
        const glm::dvec3 between = tree.points()[found[k]] - p;
        sum += normal[found[k]] / std::max(glm::dot(between, between), 1e-12);
    }
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : normal[found[0]];
}

VecArray blend(const base::Runtime& runtime, const First& first, const VecArray& normal,
               const geometry::PointTree& finer) {
    VecArray all(runtime.memory, finer.size());
    for (std::int64_t at = 0; at < finer.size(); ++at) all.set(at, blend_at(*first.tree, normal, finer.points()[at]));
    return all;
}

} // namespace

First::First(const base::Runtime& runtime, const Cloud& cloud, std::int64_t count, const base::Progress& progress)
    : rank(runtime.memory, count), place(runtime.memory, count) {
    VecArray points(runtime.memory);
    base::Array<std::int64_t> places(runtime.memory);
    for (std::int64_t at = 0; at < cloud.size(); ++at) {
        if (cloud.rank[at] >= count) continue;
        points.push_back(cloud.point(at));
        places.push_back(at);
    }
    tree = std::make_unique<geometry::PointTree>(points, progress);
    for (std::int64_t at = 0; at < count; ++at) {
        place[at] = places[tree->index(at)];
        rank[at] = cloud.rank[place[at]];
    }
}

VecArray First::pick(const VecArray& normal) const {
    VecArray own(normal.memory(), place.size());
    for (std::int64_t at = 0; at < place.size(); ++at) own.set(at, normal[place[at]]);
    return own;
}

std::int64_t coarsest_of(std::int64_t count) noexcept {
    while (count >= 2 * coarsest) count /= 2;
    return count;
}

bool is_of_curves(const Cloud& cloud) { return cloud.size() >= 2 * coarsest && geometry::along_curves(*cloud.tree); }

std::vector<Begin> begin_from_coarser(const base::Runtime& runtime, const Cloud& cloud, std::int64_t most,
                                      const base::Progress& progress) {
    std::vector<Begin> levels;
    for (std::int64_t count = coarsest_of(cloud.size()); 3 * count < 2 * std::min(cloud.size(), most); count *= 2) {
        const First level(runtime, cloud, count, progress);
        Begin begin(runtime.memory);
        Effort effort{6, true, true};
        if (!levels.empty()) {
            begin.normal = level.pick(levels.back().normal);
            begin.agreement = levels.back().agreement;
            effort = {2, false, false, &begin};
        }
        const Near near(runtime, *level.tree, std::min(neighbours_of_first, count - 1), progress);
        const LeastEnergy found =
            least_energy(runtime, *level.tree, level.rank, near, 0.0, nullptr, effort, progress.part(0.0, 0.0));
        Begin& reached = levels.emplace_back(runtime.memory);
        reached.normal = blend(runtime, level, found.normal, *cloud.tree);
        reached.energy = found.energy;
        reached.apart = cloud.apart[count / 2];
        reached.agreement = found.agreement;
    }
    return levels;
}

} // namespace hrbfnpr::orient
