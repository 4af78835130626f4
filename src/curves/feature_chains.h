// SPDX-License-Identifier: MIT
// Chains of edges where a function changes its sign that may itself have a sign only together with a direction, as
// derivatives along principal directions do; and only where it is strong enough.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/runtime.h"
#include "curves/feature_value.h"
#include "curves/surface_mesh.h"

#include <cstdint>

namespace hrbfnpr::curves {

struct FeatureCrossing {
    std::int32_t a, b; // vertices, a < b
    double share;      // of the way from a to b
    double g_a, g_b;   // of unlike signs; in the direction of a's
    double strength;   // linear between a's and b's
};

struct FeatureChains {
    explicit FeatureChains(base::Memory& memory) noexcept : first(memory), closed(memory), crossing(memory) {}

    base::Array<std::int64_t> first;  // of each chain, and the end of the last
    base::Array<std::uint8_t> closed; // 1: the last crossing is followed by the first, which stands there once
    base::Array<FeatureCrossing> crossing;

    [[nodiscard]] std::int64_t chains() const noexcept { return closed.size(); }
};

// `value` is one for each vertex.  A triangle around which directions do not return to themselves, as at an umbilic,
// ends a chain.  Undirected: what is negative lies to the left as seen from outside.  Crossings whose strength is not
// positive or below `least` are left out.  The same bits for any thread count.
[[nodiscard]] FeatureChains find_feature_chains(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                                const base::Array<FeatureValue>& value, bool directed, double least,
                                                const base::Progress& progress);

} // namespace hrbfnpr::curves
