// SPDX-License-Identifier: MIT
// Points of a plane in a k-d tree from which they can be taken out: unlike a grid it stays fast where most of them are
// in few places, or gone.
#pragma once

#include "output/vector/page.h"
#include "output/vector/tuning.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::output {

// The few that are nearest, nearest first.
struct NearList {
    struct Near {
        std::int32_t number;
        double square;
    };
    Near near[plot_tuning.most_near];
    std::int32_t count = 0;

    // Lowers `square` to the distance from which on others need not be added.
    void add(std::int32_t number, double from, double& square) noexcept {
        std::int32_t at = count < plot_tuning.most_near ? count++ : plot_tuning.most_near - 1;
        for (; at > 0 && near[at - 1].square > from; --at) near[at] = near[at - 1];
        near[at] = {number, from};
        if (count == plot_tuning.most_near) square = near[count - 1].square;
    }
};

class NearTree {
public:
    explicit NearTree(base::Memory& memory) noexcept
        : nodes_(memory), points_(memory), number_(memory), place_(memory), leaf_(memory) {}

    void build(std::span<const glm::dvec2> points, const base::Progress& progress);
    void remove(std::int32_t point) noexcept;
    [[nodiscard]] bool holds(std::int32_t point) const noexcept {
        const Node& leaf = nodes_[leaf_[point]];
        return place_[point] < leaf.begin + leaf.live;
    }

    // Calls visit(point, square of its distance) for points nearer than the square root of `square`, which visit may
    // make smaller, and nearer ones first as a rule.  visit removes nothing.
    template <class Visit>
    void search(const glm::dvec2& p, double& square, Visit&& visit) const;

    // -1: none is left.
    [[nodiscard]] std::int32_t nearest(const glm::dvec2& p) const noexcept;

private:
    static constexpr std::int32_t leaf_size = 8;
    struct Node {
        glm::dvec2 min, max;
        std::int32_t begin, end; // of its points
        std::int32_t live;       // how many are left; of a leaf they are the first ones
        std::int32_t is_leaf;
    };
    [[nodiscard]] static double square_of(const Node& node, const glm::dvec2& p) noexcept {
        const glm::dvec2 beyond = glm::max(glm::max(node.min - p, p - node.max), glm::dvec2(0.0));
        return glm::dot(beyond, beyond);
    }
    void split(std::int64_t number);

    base::Array<Node> nodes_; // the children of i are 2 i + 1 and 2 i + 2
    base::Array<glm::dvec2> points_;
    base::Array<std::int32_t> number_; // the points in the order of the leaves
    base::Array<std::int32_t> place_;  // where each stands there
    base::Array<std::int32_t> leaf_;   // and in which leaf
};

template <class Visit>
void NearTree::search(const glm::dvec2& p, double& square, Visit&& visit) const {
    struct Waiting {
        std::int32_t node;
        double square;
    };
    Waiting waiting[64]; // one for each level
    int count = 0;
    const auto push = [&](std::int32_t node) {
        if (nodes_[node].live == 0) return;
        if (const double from = square_of(nodes_[node], p); from < square) waiting[count++] = {node, from};
    };
    if (!nodes_.empty()) push(0);
    while (count > 0) {
        const Waiting next = waiting[--count];
        if (next.square >= square) continue;
        const Node& node = nodes_[next.node];
        if (node.is_leaf == 0) {
            const std::int32_t child = 2 * next.node + 1;
            const bool second = square_of(nodes_[child + 1], p) < square_of(nodes_[child], p);
            push(second ? child : child + 1);
            push(second ? child + 1 : child);
            continue;
        }
        for (std::int32_t i = node.begin; i < node.begin + node.live; ++i) {
            const glm::dvec2 to = points_[number_[i]] - p;
            if (const double from = glm::dot(to, to); from < square) visit(number_[i], from);
        }
    }
}

} // namespace hrbfnpr::output
