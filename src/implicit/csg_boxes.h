// SPDX-License-Identifier: MIT
// Boxes of solids in a binary tree: what f is at least, of all that are beyond some distance.
#pragma once

#include "implicit/csg_shapes.h"

#include <array>
#include <span>
#include <utility>

namespace hrbfnpr::implicit {

// {f <= level} is in the box grown by `slope` times a level above 0.
struct CsgBounded {
    CsgBox box;
    double slope = 1.0;
    std::int32_t item = 0;
};

class CsgBoxTree {
public:
    explicit CsgBoxTree(base::Memory& memory) noexcept : nodes_(memory) {}

    struct Node {
        CsgBox box;
        double slope = 1.0;
        std::int32_t first = -1, second = -1; // nodes; without a second one `first` is an item

        [[nodiscard]] bool is_leaf() const noexcept { return second < 0; }
        // What f is at least, if places and values are off by so much; -infinity: nothing is known.
        [[nodiscard]] double least(const glm::dvec3& p, double slack) const noexcept {
            const glm::dvec3 below = box.low - p;
            const glm::dvec3 above = p - box.high;
            const double distance = std::max({below.x, below.y, below.z, above.x, above.y, above.z}) - slack;
            return distance > 0.0 ? distance / slope : -std::numeric_limits<double>::infinity();
        }
    };

    // The item whose f is least at least, none above `bound`; -1: there is none.  bound_of(node): of a leaf.
    template <class F>
    [[nodiscard]] std::int32_t nearest(std::int32_t root, const glm::dvec3& p, double slack, double bound,
                                       F&& bound_of) const noexcept;

    // Adds a tree of some; reorders them.  Returns its root, -1 of none.
    std::int32_t add(std::span<CsgBounded> items);

    [[nodiscard]] const Node& operator[](std::int32_t node) const noexcept { return nodes_[node]; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return nodes_.bytes(); }
    // Nodes that wait on the way down at most: halves of 2^16 items, and those without an end apart.
    static constexpr std::size_t deepest = 32;

private:
    std::int32_t split(std::span<CsgBounded> items);
    std::int32_t join(std::int32_t first, std::int32_t second);

    base::Array<Node> nodes_;
};

template <class F>
std::int32_t CsgBoxTree::nearest(std::int32_t root, const glm::dvec3& p, double slack, double bound,
                                 F&& bound_of) const noexcept {
    struct Part {
        std::int32_t node;
        double least;
    };
    std::array<Part, deepest> waiting;
    std::size_t count = 0;
    std::int32_t item = -1;
    waiting[count++] = {root, -std::numeric_limits<double>::infinity()};
    while (count > 0) {
        const Part part = waiting[--count];
        if (part.least > bound) continue;
        const Node& one = nodes_[part.node];
        if (one.is_leaf()) {
            const double here = bound_of(one);
            if (here > bound || (item >= 0 && here == bound)) continue;
            bound = here;
            item = one.first;
            continue;
        }
        Part near{one.first, nodes_[one.first].least(p, slack)};
        Part far{one.second, nodes_[one.second].least(p, slack)};
        if (far.least < near.least) std::swap(near, far);
        waiting[count++] = far;
        waiting[count++] = near;
    }
    return item;
}

} // namespace hrbfnpr::implicit
