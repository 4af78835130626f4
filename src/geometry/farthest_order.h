// SPDX-License-Identifier: MIT
// Farthest-point (maximin) order: each point is the one farthest from all before it.  Any prefix
// of it is an even sample of the points (Gonzalez, "Clustering to minimize the maximum intercluster
// distance", 1985).
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "geometry/vec_array.h"

namespace hrbfnpr::geometry {

struct FarthestOrder {
    explicit FarthestOrder(base::Memory& memory) noexcept : order(memory), distance(memory) {}

    base::Array<std::int64_t> order; // indices of the points
    base::Array<double> distance;    // of order[k] from those before it; infinite for the first
};

// The first is the point nearest to the centre of the bounds; of equals, the one of lower index.
// count: how many to pick, 0 = all.
[[nodiscard]] FarthestOrder farthest_order(const VecArray& points, std::int64_t count, const base::Progress& progress);

} // namespace hrbfnpr::geometry
