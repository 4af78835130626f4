// SPDX-License-Identifier: MIT
// Farthest-point (maximin) order: each point is the one farthest from all before it. Any prefix of the order is an even
// sample of the points (Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985).
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "geometry/vec_array.h"

namespace hrbfnpr::geometry {

struct FarthestOrder {
    explicit FarthestOrder(base::Memory& memory) noexcept : order(memory), distance(memory) {}

    base::Array<std::int64_t> order; // indices of the points
    base::Array<double> distance;    // distance of order[k] from the points before it; infinite for the first
};

// The first point is the one nearest to the centre of the bounds. Ties go to the lower index. `count` is how many
// points to pick; 0 picks all.
[[nodiscard]] FarthestOrder farthest_order(const VecArray& points, std::int64_t count, const base::Progress& progress);

} // namespace hrbfnpr::geometry
