// SPDX-License-Identifier: MIT
#include "geometry/neighbours.h"

#include "geometry/point_tree.h"

#include <algorithm>
#include <array>

namespace hrbfnpr::geometry {

Neighbours::Neighbours(const base::Parallel& parallel, const VecArray& points, std::int64_t each,
                       const base::Progress& progress)
    : each_(std::clamp<std::int64_t>(each, 0, std::min(most, std::max<std::int64_t>(points.size() - 1, 0)))),
      index_(points.memory(), points.size() * each_) {
    const PointTree tree(points, progress);
    parallel.for_chunks(points.size(), 256, progress, [&](std::int64_t begin, std::int64_t end) {
        std::array<std::int64_t, most> found;
        for (std::int64_t at = begin; at < end; ++at) {
            tree.nearest(
                tree.points()[at], each_, [](std::int64_t) { return true; },
                [&](std::int64_t other) { return other != at; }, found.data());
            std::int64_t* out = index_.data() + tree.index(at) * each_;
            for (std::int64_t k = 0; k < each_; ++k) out[k] = tree.index(found[static_cast<std::size_t>(k)]);
        }
    });
}

} // namespace hrbfnpr::geometry
