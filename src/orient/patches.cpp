// SPDX-License-Identifier: MIT
#include "orient/patches.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

constexpr std::size_t looked_at = 8;
constexpr double alike = 0.9;         // cosine of normals
constexpr double patch_beside = 0.35; // sine of the angle between a pair and the surface

} // namespace

Patches find_patches(const base::Runtime& runtime, const geometry::PointTree& tree, const Near& near,
                     const geometry::VecArray& normal) {
    Patches patches(runtime.memory);
    patches.cluster.resize(tree.size());
    patches.signs.resize(tree.size());
    std::fill(patches.cluster.begin(), patches.cluster.end(), -1);
    const std::size_t used = std::min(looked_at, static_cast<std::size_t>(near.each()));
    for (std::int64_t at = 0; at < tree.size(); ++at) {
        if (patches.cluster[at] >= 0) continue;
        patches.cluster[at] = static_cast<std::int32_t>(at);
        patches.signs[at] = 1;
        for (const std::int32_t other : near.of(at).first(used)) {
            if (patches.cluster[other] >= 0) continue;
            const double cosine = glm::dot(normal[at], normal[other]);
            const glm::dvec3 between = tree.points()[other] - tree.points()[at];
            const double off =
                std::max(std::abs(glm::dot(between, normal[at])), std::abs(glm::dot(between, normal[other])));
            if (std::abs(cosine) < alike || off > patch_beside * glm::length(between)) continue;
            patches.cluster[other] = static_cast<std::int32_t>(at);
            patches.signs[other] = cosine > 0.0 ? std::int8_t{1} : std::int8_t{-1};
        }
    }
    return patches;
}

} // namespace hrbfnpr::orient
