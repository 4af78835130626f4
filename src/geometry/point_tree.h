// A balanced k-d tree over points: nearest neighbours and balls.  Unlike a grid it has no
// cell size to get wrong when points cluster.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "geometry/vec_array.h"

#include <array>
#include <limits>

namespace hrbfnpr::geometry {

class PointTree {
public:
    PointTree(const VecArray& points, const base::Progress& progress);

    [[nodiscard]] std::int64_t size() const noexcept { return points_.size(); }
    // The points in the tree's order, in which neighbours in space are neighbours in memory.
    [[nodiscard]] const VecArray& points() const noexcept { return points_; }
    // Which of the given points stands at place `at` of that order.
    [[nodiscard]] std::int64_t index(std::int64_t at) const noexcept { return index_[at]; }
    [[nodiscard]] Bounds bounds() const noexcept { return size() > 0 ? bounds_[0] : Bounds{}; }

    // Calls visit(at, squared distance) for the points within `radius` of p, in the tree's order.
    template <class Visit>
    void within(const glm::dvec3& p, double radius, Visit&& visit) const;

    // Distance from the point at `at` to the nearest other one; infinite if it is alone.
    [[nodiscard]] double nearest_other(std::int64_t at) const noexcept;

private:
    static constexpr std::int64_t leaf_size = 8;
    // Every level halves its ranges, so that 2^63 points would have 60 levels.
    static constexpr std::size_t stack_size = 64;

    struct Range {
        std::int64_t node;
        std::int64_t begin;
        std::int64_t end;

        [[nodiscard]] bool leaf() const noexcept { return end - begin <= leaf_size; }
        [[nodiscard]] std::int64_t middle() const noexcept { return begin + (end - begin) / 2; }
        [[nodiscard]] Range low() const noexcept { return {2 * node + 1, begin, middle()}; }
        [[nodiscard]] Range high() const noexcept { return {2 * node + 2, middle(), end}; }
    };

    void build(const VecArray& points, const Range& range, const base::Progress& progress);
    [[nodiscard]] double squared_distance_to_box(const glm::dvec3& p, std::int64_t node) const noexcept;

    VecArray points_;
    base::Array<std::int64_t> index_;
    base::Array<Bounds> bounds_; // of the nodes, in heap order
};

inline double PointTree::squared_distance_to_box(const glm::dvec3& p, std::int64_t node) const noexcept {
    const Bounds& box = bounds_[node];
    const glm::dvec3 outside = glm::max(glm::max(box.min - p, p - box.max), glm::dvec3(0.0));
    return glm::dot(outside, outside);
}

template <class Visit>
void PointTree::within(const glm::dvec3& p, double radius, Visit&& visit) const {
    if (size() == 0) return;
    const double limit = radius * radius;
    std::array<Range, stack_size> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, 0, size()};
    while (depth > 0) {
        const Range range = stack[--depth];
        if (squared_distance_to_box(p, range.node) > limit) continue;
        if (!range.leaf()) {
            stack[depth++] = range.high();
            stack[depth++] = range.low();
            continue;
        }
        for (std::int64_t at = range.begin; at < range.end; ++at) {
            const glm::dvec3 between = points_[at] - p;
            const double squared = glm::dot(between, between);
            if (squared <= limit) visit(at, squared);
        }
    }
}

} // namespace hrbfnpr::geometry
