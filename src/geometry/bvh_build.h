// SPDX-License-Identifier: MIT
// Builds the boxes of a bounding volume hierarchy by the surface-area heuristic.
#pragma once

#include "base/memory.h"
#include "base/work.h"
#include "geometry/bvh_loops.h"

namespace hrbfnpr::geometry {

// The box of a triangle, in the scaled coordinates of the hierarchy. The fourth numbers are 0.
struct BvhItem {
    float low[4];
    float high[4];
    std::int32_t face;
};

struct BvhBoxes {
    explicit BvhBoxes(base::Memory& memory) noexcept : node(memory), leaf(memory) {}

    base::Array<BvhNode> node;
    base::Array<BvhLeaf> leaf; // The corners are not set.
    std::uint32_t root = 0;
};

// Puts the items into the order of the leaves. The result does not depend on the number of threads.
[[nodiscard]] BvhBoxes build_bvh(const base::Work& work, base::Array<BvhItem>& item);

} // namespace hrbfnpr::geometry
