// SPDX-License-Identifier: MIT
// Trees whose nodes halve a range of items. Nodes are numbered in heap order: the children of node n are 2 n + 1 and
// 2 n + 2.
#pragma once

#include "base/assert.h"
#include "geometry/vec.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::geometry {

// A node and its range of items. A leaf has at most `leaf_size` items.
template <std::int64_t leaf_size>
struct HeapNode {
    std::int64_t node;
    std::int64_t begin;
    std::int64_t end;

    [[nodiscard]] bool leaf() const noexcept { return end - begin <= leaf_size; }
    [[nodiscard]] std::int64_t middle() const noexcept { return begin + (end - begin) / 2; }
    [[nodiscard]] HeapNode low() const noexcept { return {2 * node + 1, begin, middle()}; }
    [[nodiscard]] HeapNode high() const noexcept { return {2 * node + 2, middle(), end}; }

    // Returns the number of node indices that a tree of `count` items needs. Some of them are unused.
    [[nodiscard]] static std::int64_t nodes(std::int64_t count) noexcept {
        std::int64_t nodes = 1;
        for (std::int64_t longest = count; longest > leaf_size; longest = (longest + 1) / 2) nodes = 2 * nodes + 1;
        return nodes;
    }
};

// The largest number of levels. Each level halves the ranges, so 2^63 items need about 60 levels.
inline constexpr std::size_t most_heap_levels = 64;

// Returns the axis along which a box is longest.
[[nodiscard]] inline glm::length_t longest_axis(const Bounds& box) noexcept {
    const glm::dvec3 size = box.size();
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
}

[[nodiscard]] inline double squared_distance_to(const Bounds& box, const glm::dvec3& p) noexcept {
    const glm::dvec3 outside = glm::max(glm::max(box.min - p, p - box.max), glm::dvec3(0.0));
    return glm::dot(outside, outside);
}

// Calls visit(at) for the items of leaves, nearer leaves first. squared(node) returns the squared distance to a node's
// box. passes(node, squared distance) tells whether a node may have items that matter.
template <std::int64_t leaf_size, class Squared, class Passes, class Visit>
void visit_nearest_first(std::int64_t count, Squared&& squared, Passes&& passes, Visit&& visit) {
    using Range = HeapNode<leaf_size>;
    struct Waiting {
        Range range;
        double squared;
    };
    std::array<Waiting, most_heap_levels> stack;
    std::size_t depth = 0;
    stack[depth++] = {{0, 0, count}, squared(0)};
    while (depth > 0) {
        const Waiting next = stack[--depth];
        if (!passes(next.range.node, next.squared)) continue;
        if (next.range.leaf()) {
            for (std::int64_t at = next.range.begin; at < next.range.end; ++at) visit(at);
            continue;
        }
        HRBFNPR_ASSERT(depth + 2 <= stack.size());
        const Waiting low{next.range.low(), squared(next.range.low().node)};
        const Waiting high{next.range.high(), squared(next.range.high().node)};
        const bool low_first = low.squared <= high.squared;
        stack[depth++] = low_first ? high : low;
        stack[depth++] = low_first ? low : high;
    }
}

} // namespace hrbfnpr::geometry
