// SPDX-License-Identifier: MIT
// Chains of edges where a function changes its sign that may itself have a sign only together with a direction, as
// derivatives along principal directions do; and only where it is strong enough.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/runtime.h"
#include "curves/surface_mesh.h"
#include "features/feature_value.h"

#include <cstdint>

namespace hrbfnpr::curves {

struct FeatureCrossing {
    std::int32_t a, b; // vertices, a < b
    double share;      // of the way from a to b
    double g_a, g_b;   // of unlike signs; in the direction of a's
    double strength;   // linear between a's and b's
    bool counts;       // strong enough, and facing the eye
    double slope;      // directed: of g along the direction in the triangles on both sides, by their areas
};

struct FeatureChains {
    explicit FeatureChains(base::Memory& memory) noexcept : first(memory), closed(memory), crossing(memory) {}

    base::Array<std::int64_t> first;  // of each chain, and the end of the last
    base::Array<std::uint8_t> closed; // 1: the last crossing is followed by the first, which stands there once
    base::Array<FeatureCrossing> crossing;

    [[nodiscard]] std::int64_t chains() const noexcept { return closed.size(); }
};

// `value` is one for each vertex.  A triangle around which directions do not return to themselves, as at an umbilic,
// ends a chain.  Undirected: what is negative lies to the left as seen from outside.  Crossings count where the surface
// faces the eye and the strength is positive and `least` at least; of others only those next to one that counts are
// there, so that it can be told where between them a line ends.  The same bits for any thread count.
[[nodiscard]] FeatureChains find_feature_chains(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                                const base::Array<FeatureValue>& value, bool directed, double least,
                                                const base::Progress& progress);

// Of directed chains the parts where g rises along the direction (sign = 1) or falls (-1): there what g is the
// derivative of has a minimum or a maximum.  Slopes are summed over five crossings.
[[nodiscard]] FeatureChains keep_extrema(const FeatureChains& chains, double sign);

// Calls f(begin, end, closed) for each part of a chain whose crossings all go on; crossing i is i % count, since a
// closed chain that is cut begins after a place where it is.
template <class GoesOn, class F>
void for_parts(std::int64_t count, bool closed, GoesOn&& goes_on, F&& f) {
    std::int64_t start = 0;
    while (closed && start < count && goes_on(start)) ++start;
    if (closed && start == count) {
        f(std::int64_t{0}, count, true);
        return;
    }
    for (std::int64_t i = start; i < start + count;) {
        std::int64_t end = i;
        while (end < start + count && goes_on(end % count)) ++end;
        if (end > i) f(i, end, false);
        i = end + 1;
    }
}

} // namespace hrbfnpr::curves
