// SPDX-License-Identifier: MIT
#include "geometry/octree.h"

#include "base/sort.h"
#include "geometry/cell_grid.h"
#include "geometry/long_vec_array.h"
#include "geometry/morton.h"

#include <algorithm>
#include <cstdlib>

namespace hrbfnpr::geometry {
namespace {

struct KeyedPoint {
    std::uint64_t key;
    std::int64_t index;
};

[[nodiscard]] bool are_adjacent(const Octree::Node& a, const Octree::Node& b) noexcept {
    for (std::size_t c = 0; c < 3; ++c)
        if (std::abs(a.cell[c] - b.cell[c]) > 1) return false;
    return true;
}

// Walks pairs of cubes of the same level from the root downwards.
class InteractionFinder {
public:
    InteractionFinder(const Octree& tree, OctreeInteractions& lists, const base::Progress& progress) noexcept
        : tree_(tree), lists_(lists), progress_(progress) {}

    // count() counts the cubes in each node's lists, and fill() then writes them.
    void count() { walk(0, 0, true); }
    void fill() { walk(0, 0, false); }

private:
    void walk(std::int64_t target, std::int64_t source, bool counting) {
        progress_.check();
        const Octree::Node& t = tree_.nodes()[target];
        const Octree::Node& s = tree_.nodes()[source];
        if (!are_adjacent(t, s)) return add(lists_.far_begin, lists_.far, target, source, counting);
        if (t.leaf() || s.leaf()) return add(lists_.near_begin, lists_.near, target, source, counting);
        for (std::int64_t i = t.first_child; i < t.first_child + t.children; ++i)
            for (std::int64_t j = s.first_child; j < s.first_child + s.children; ++j) walk(i, j, counting);
    }

    // Counts are stored in begin[target + 2]. After summation, the list of `target` starts at begin[target + 1], which
    // is advanced as the list is filled.
    static void add(base::Array<std::int64_t>& begin, base::Array<std::int64_t>& list, std::int64_t target,
                    std::int64_t source, bool counting) {
        if (counting)
            ++begin[target + 2];
        else
            list[begin[target + 1]++] = source;
    }

    const Octree& tree_;
    OctreeInteractions& lists_;
    const base::Progress& progress_;
};

void make_prefix_sums(base::Array<std::int64_t>& begin, base::Array<std::int64_t>& list) {
    for (std::int64_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
    list.resize(begin.back());
}

} // namespace

Octree::Octree(const VecArray& points, std::int64_t leaf_size, double margin, const base::Progress& progress)
    : points_(points.memory()), index_(points.memory()), key_(points.memory()), nodes_(points.memory()),
      level_begin_(points.memory()) {
    Bounds bounds;
    for (std::int64_t i = 0; i < points.size(); ++i) bounds.extend(points[i]);
    const glm::dvec3 size = points.empty() ? glm::dvec3(0.0) : bounds.size();
    const double largest = std::max({size.x, size.y, size.z});
    width_ = largest > 0.0 ? (1.0000001 + margin) * largest : 1.0;
    corner_ = points.empty() ? glm::dvec3(0.0) : bounds.centre() - glm::dvec3(0.5 * width_);
    sort(points, progress);
    divide(leaf_size, progress);
}

glm::dvec3 Octree::centre(const Node& node) const noexcept {
    const double half = half_width(node.level);
    return corner_ + half * glm::dvec3(2 * node.cell[0] + 1, 2 * node.cell[1] + 1, 2 * node.cell[2] + 1);
}

void Octree::sort(const VecArray& points, const base::Progress& progress) {
    constexpr double cells = 1 << deepest_level;
    constexpr auto last = static_cast<std::int64_t>(cells) - 1;
    base::resize_long(key_, points.size(), progress);
    base::resize_long(index_, points.size(), progress);
    resize_long(points_, points.size(), progress);
    base::Array<KeyedPoint> keyed(points.memory());
    base::resize_long(keyed, points.size(), progress);
    for (const std::int64_t i : progress.over(points.size())) {
        const glm::dvec3 place = (points[i] - corner_) * (cells / width_);
        std::array<std::int64_t, 3> cell;
        for (std::size_t c = 0; c < 3; ++c) cell[c] = truncate_to(place[static_cast<glm::length_t>(c)], last);
        keyed[i] = {morton_code(cell), i};
    }
    base::sort_long(
        keyed.begin(), keyed.end(),
        [](const KeyedPoint& a, const KeyedPoint& b) { return a.key < b.key || (a.key == b.key && a.index < b.index); },
        progress);
    for (const std::int64_t at : progress.over(keyed.size())) {
        key_[at] = keyed[at].key;
        index_[at] = keyed[at].index;
        points_.set(at, points[keyed[at].index]);
    }
}

void Octree::divide(std::int64_t leaf_size, const base::Progress& progress) {
    nodes_.push_back({0, points_.size(), 0, 0, {0, 0, 0}, 0, 0});
    level_begin_.push_back(0);
    for (std::int32_t level = 0; level_begin_.back() < nodes_.size(); ++level) {
        const std::int64_t begin = level_begin_.back();
        const std::int64_t end = nodes_.size();
        level_begin_.push_back(end);
        if (level == deepest_level) break;
        for (std::int64_t node = begin; node < end; ++node) {
            if (nodes_[node].count() > leaf_size) divide_node(node);
            progress.check();
        }
    }
}

void Octree::divide_node(std::int64_t node) {
    const Node parent = nodes_[node];
    const int shift = 3 * (deepest_level - parent.level - 1);
    nodes_[node].first_child = nodes_.size();
    std::int64_t begin = parent.begin;
    while (begin < parent.end) {
        const std::uint64_t digit = key_[begin] >> shift;
        const std::int64_t end = std::partition_point(key_.begin() + begin, key_.begin() + parent.end,
                                                      [&](std::uint64_t key) { return key >> shift == digit; }) -
                                 key_.begin();
        const auto octant = static_cast<std::int32_t>(digit & 7);
        nodes_.push_back({begin,
                          end,
                          0,
                          node,
                          {2 * parent.cell[0] + (octant & 1), 2 * parent.cell[1] + (octant >> 1 & 1),
                           2 * parent.cell[2] + (octant >> 2)},
                          parent.level + 1,
                          0});
        ++nodes_[node].children;
        begin = end;
    }
}

OctreeInteractions octree_interactions(const Octree& tree, const base::Progress& progress) {
    OctreeInteractions lists(tree.points().memory());
    lists.far_begin.resize(tree.nodes().size() + 2);
    lists.near_begin.resize(tree.nodes().size() + 2);
    InteractionFinder finder(tree, lists, progress);
    finder.count();
    make_prefix_sums(lists.far_begin, lists.far);
    make_prefix_sums(lists.near_begin, lists.near);
    finder.fill();
    return lists;
}

} // namespace hrbfnpr::geometry
