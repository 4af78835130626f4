// SPDX-License-Identifier: MIT
// A balanced k-d tree over points, for nearest neighbours and for points in balls. Unlike a grid it has no cell size
// that could be wrong where points cluster.
#pragma once

#include "base/assert.h"
#include "base/memory.h"
#include "base/operation.h"
#include "geometry/heap_node.h"
#include "geometry/vec_array.h"

#include <algorithm>
#include <array>
#include <limits>

namespace hrbfnpr::geometry {

class PointTree {
public:
    PointTree(const VecArray& points, const base::Progress& progress);

    [[nodiscard]] std::int64_t size() const noexcept { return points_.size(); }
    // The points in the tree's order, in which points that are near in space are near in memory.
    [[nodiscard]] const VecArray& points() const noexcept { return points_; }
    // Returns the original index of the point at position `at` of the tree's order.
    [[nodiscard]] std::int64_t index(std::int64_t at) const noexcept { return index_[at]; }
    [[nodiscard]] Bounds bounds() const noexcept { return size() > 0 ? bounds_[0] : Bounds{}; }

    // Calls visit(at, squared distance) for the points within `radius` of p, in the tree's order.
    template <class Visit>
    void within(const glm::dvec3& p, double radius, Visit&& visit) const;

    // Finds the nearest `count` points for which accept_point(at) is true. Writes their positions in the tree's order
    // to `found`, nearest first (ties by position), and returns their number. accept_node(node) is called before the
    // points of a node; it returns false if no point of the node would be accepted. Nodes farther away than `farthest`
    // are skipped, but the result may contain points beyond `farthest` from other nodes.
    template <class AcceptNode, class AcceptPoint>
    std::int64_t nearest(const glm::dvec3& p, std::int64_t count, AcceptNode&& accept_node, AcceptPoint&& accept_point,
                         std::int64_t* found, double farthest = std::numeric_limits<double>::infinity()) const;

    // Nodes are numbered 0 .. nodes() - 1, children after their parents; some numbers are unused.
    [[nodiscard]] std::int64_t nodes() const noexcept { return bounds_.size(); }
    // Returns the smallest value(at) over the points of each node, by the node's number.
    template <class Value>
    [[nodiscard]] base::Array<std::int64_t> smallest_of_nodes(Value&& value) const;

    // Calls visit(node) for the nodes that hold the point at `at`, beginning at the root.
    template <class Visit>
    void for_nodes_of(std::int64_t at, Visit&& visit) const {
        HRBFNPR_ASSERT(at >= 0 && at < size());
        Range range{0, 0, size()};
        for (; !range.leaf(); range = at < range.middle() ? range.low() : range.high()) visit(range.node);
        visit(range.node);
    }

    // Returns the distance from the point at `at` to the nearest other point; infinity if there is no other point.
    [[nodiscard]] double nearest_other(std::int64_t at) const noexcept;

private:
    static constexpr std::int64_t leaf_size = 8;
    using Range = HeapNode<leaf_size>;

    // A point's position in the order, and its squared distance. Ties in distance go to the earlier position.
    struct Neighbour {
        double squared;
        std::int64_t at;

        [[nodiscard]] bool operator<(const Neighbour& other) const noexcept {
            return squared < other.squared || (squared == other.squared && at < other.at);
        }
    };
    // The nearest points that are already found, in ascending order.
    class NearestList;

    // A point while the tree is built. Points are moved with their indices, so that points that are near in space
    // become near in memory.
    struct IndexedPoint {
        glm::dvec3 point;
        std::int64_t index;
    };

    void build(IndexedPoint* places, const Range& range, const base::Progress& progress);
    template <class Value>
    std::int64_t fill_smallest(const Range& range, const Value& value, base::Array<std::int64_t>& smallest) const;

    VecArray points_;
    base::Array<std::int64_t> index_;
    base::Array<Bounds> bounds_; // boxes of the nodes, in heap order
};

template <class Visit>
void PointTree::within(const glm::dvec3& p, double radius, Visit&& visit) const {
    if (size() == 0) return;
    const double limit = radius * radius;
    std::array<Range, most_heap_levels> stack;
    std::size_t depth = 0;
    stack[depth++] = {0, 0, size()};
    while (depth > 0) {
        const Range range = stack[--depth];
        if (squared_distance_to(bounds_[range.node], p) > limit) continue;
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

class PointTree::NearestList {
public:
    static constexpr std::int64_t most = 64;

    NearestList(std::int64_t count, double farthest) noexcept : count_(count), farthest_squared_(farthest * farthest) {}
    [[nodiscard]] double limit() const noexcept {
        return size_ < count_ ? farthest_squared_ : neighbours_[static_cast<std::size_t>(size_ - 1)].squared;
    }
    void add(const Neighbour& near) noexcept {
        std::int64_t to = size_;
        if (size_ < count_)
            ++size_;
        else if (near < neighbours_[static_cast<std::size_t>(size_ - 1)])
            --to;
        else
            return;
        for (; to > 0 && near < neighbours_[static_cast<std::size_t>(to - 1)]; --to)
            neighbours_[static_cast<std::size_t>(to)] = neighbours_[static_cast<std::size_t>(to - 1)];
        neighbours_[static_cast<std::size_t>(to)] = near;
    }
    std::int64_t write(std::int64_t* found) const noexcept {
        for (std::int64_t i = 0; i < size_; ++i) found[i] = neighbours_[static_cast<std::size_t>(i)].at;
        return size_;
    }

private:
    std::int64_t count_;
    double farthest_squared_;
    std::int64_t size_ = 0;
    std::array<Neighbour, most> neighbours_;
};

template <class AcceptNode, class AcceptPoint>
std::int64_t PointTree::nearest(const glm::dvec3& p, std::int64_t count, AcceptNode&& accept_node,
                                AcceptPoint&& accept_point, std::int64_t* found, double farthest) const {
    if (size() == 0 || count <= 0) return 0;
    NearestList best(std::min(count, NearestList::most), farthest);
    visit_nearest_first<leaf_size>(
        size(), [&](std::int64_t node) { return squared_distance_to(bounds_[node], p); },
        [&](std::int64_t node, double squared) { return !(squared > best.limit()) && accept_node(node); },
        [&](std::int64_t at) {
            if (!accept_point(at)) return;
            const glm::dvec3 between = points_[at] - p;
            best.add({glm::dot(between, between), at});
        });
    return best.write(found);
}

template <class Value>
std::int64_t PointTree::fill_smallest(const Range& range, const Value& value,
                                      base::Array<std::int64_t>& smallest) const {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    if (range.leaf()) {
        for (std::int64_t at = range.begin; at < range.end; ++at) least = std::min<std::int64_t>(least, value(at));
    } else {
        least = std::min(fill_smallest(range.low(), value, smallest), fill_smallest(range.high(), value, smallest));
    }
    smallest[range.node] = least;
    return least;
}

template <class Value>
base::Array<std::int64_t> PointTree::smallest_of_nodes(Value&& value) const {
    base::Array<std::int64_t> smallest(points_.memory(), nodes());
    if (size() > 0) fill_smallest({0, 0, size()}, value, smallest);
    return smallest;
}

} // namespace hrbfnpr::geometry
