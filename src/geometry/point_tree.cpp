// SPDX-License-Identifier: MIT
#include "geometry/point_tree.h"

#include "geometry/long_vec_array.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::geometry {
namespace {

constexpr std::int64_t halved_at_once = 65536; // points without a look for a cancel

const base::Array<double>& axis_of(const VecArray& points, int axis) noexcept {
    return axis == 0 ? points.x : axis == 1 ? points.y : points.z;
}

int longest_axis(const Bounds& box) noexcept {
    const glm::dvec3 size = box.size();
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

} // namespace

PointTree::PointTree(const VecArray& points, const base::Progress& progress)
    : points_(points.memory()), index_(points.memory()), bounds_(points.memory()) {
    const std::int64_t count = points.size();
    if (count == 0) return;
    std::int64_t nodes = 1;
    for (std::int64_t longest = count; longest > leaf_size; longest = (longest + 1) / 2) nodes = 2 * nodes + 1;
    base::resize_long(bounds_, nodes, progress);
    base::resize_long(index_, count, progress);
    resize_long(points_, count, progress);
    progress.check();
    for (std::int64_t i = 0; i < count; ++i) index_[i] = i;
    build(points, {0, 0, count}, progress);
    for (std::int64_t at = 0; at < count; ++at) {
        if (at % halved_at_once == 0) progress.check();
        points_.set(at, points[index_[at]]);
    }
}

void PointTree::build(const VecArray& points, const Range& range, const base::Progress& progress) {
    Bounds box;
    for (std::int64_t at = range.begin; at < range.end; ++at) {
        if ((at - range.begin) % halved_at_once == halved_at_once - 1) progress.check();
        box.extend(points[index_[at]]);
    }
    bounds_[range.node] = box;
    if (range.leaf()) return;
    if (range.end - range.begin > 4096) progress.check();
    const base::Array<double>& coordinate = axis_of(points, longest_axis(box));
    // Ties are broken by index, so that the halves are the same with any standard library.
    std::nth_element(index_.begin() + range.begin, index_.begin() + range.middle(), index_.begin() + range.end,
                     [&](std::int64_t a, std::int64_t b) {
                         return coordinate[a] < coordinate[b] || (coordinate[a] == coordinate[b] && a < b);
                     });
    build(points, range.low(), progress);
    build(points, range.high(), progress);
}

double PointTree::nearest_other(std::int64_t at) const noexcept {
    const glm::dvec3 p = points_[at];
    double best = std::numeric_limits<double>::infinity();
    std::array<Range, stack_size> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, 0, size()};
    while (depth > 0) {
        const Range range = stack[--depth];
        if (squared_distance_to_box(p, range.node) >= best) continue;
        if (!range.leaf()) {
            const bool low_first =
                squared_distance_to_box(p, 2 * range.node + 1) <= squared_distance_to_box(p, 2 * range.node + 2);
            stack[depth++] = low_first ? range.high() : range.low();
            stack[depth++] = low_first ? range.low() : range.high();
            continue;
        }
        for (std::int64_t other = range.begin; other < range.end; ++other) {
            const glm::dvec3 between = points_[other] - p;
            if (other != at) best = std::min(best, glm::dot(between, between));
        }
    }
    return std::sqrt(best);
}

} // namespace hrbfnpr::geometry
