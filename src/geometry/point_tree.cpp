// SPDX-License-Identifier: MIT
#include "geometry/point_tree.h"

#include "base/select.h"
#include "geometry/long_vec_array.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace hrbfnpr::geometry {
namespace {} // namespace

PointTree::PointTree(const VecArray& points, const base::Progress& progress)
    : points_(points.memory()), index_(points.memory()), bounds_(points.memory()) {
    const std::int64_t count = points.size();
    if (count == 0) return;
    base::resize_long(bounds_, Range::nodes(count), progress);
    base::Array<IndexedPoint> places(points.memory());
    base::resize_long(places, count, progress);
    for (const std::int64_t i : progress.over(count)) {
        places[i] = {points[i], i};
    }
    build(places.data(), {0, 0, count}, progress);
    base::resize_long(index_, count, progress);
    resize_long(points_, count, progress);
    for (const std::int64_t at : progress.over(count)) {
        points_.set(at, places[at].point);
        index_[at] = places[at].index;
    }
}

void PointTree::build(IndexedPoint* places, const Range& range, const base::Progress& progress) {
    Bounds box;
    for (const std::int64_t at : progress.over(range.begin, range.end)) box.extend(places[at].point);
    bounds_[range.node] = box;
    if (range.leaf()) return;
    const auto halve = [&](auto of) {
        constexpr glm::length_t axis = decltype(of)::value;
        // Ties are broken by index, so that all elements are different.
        base::select(places + range.begin, places + range.middle(), places + range.end,
                     [](const IndexedPoint& a, const IndexedPoint& b) {
                         const double x = a.point[axis];
                         const double y = b.point[axis];
                         return x < y || (x == y && a.index < b.index);
                     });
    };
    switch (longest_axis(box)) {
    case 0: halve(std::integral_constant<glm::length_t, 0>()); break;
    case 1: halve(std::integral_constant<glm::length_t, 1>()); break;
    default: halve(std::integral_constant<glm::length_t, 2>());
    }
    build(places, range.low(), progress);
    build(places, range.high(), progress);
}

double PointTree::nearest_other(std::int64_t at) const noexcept {
    const glm::dvec3 p = points_[at];
    double best = std::numeric_limits<double>::infinity();
    visit_nearest_first<leaf_size>(
        size(), [&](std::int64_t node) { return squared_distance_to(bounds_[node], p); },
        [&](std::int64_t, double squared) { return squared < best; },
        [&](std::int64_t other) {
            const glm::dvec3 between = points_[other] - p;
            if (other != at) best = std::min(best, glm::dot(between, between));
        });
    return std::sqrt(best);
}

} // namespace hrbfnpr::geometry
