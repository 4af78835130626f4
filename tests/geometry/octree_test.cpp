// SPDX-License-Identifier: MIT
#include "geometry/octree.h"

#include "base/status.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

namespace hrbfnpr::geometry::octree_test {
namespace {

base::Memory& memory() {
    static base::Memory instance;
    return instance;
}

glm::dvec3 pseudo_random(int i) {
    return {std::sin(12.9898 * i), std::sin(78.233 * i + 1.0), std::sin(37.719 * i + 2.0)};
}

VecArray surface(int count) {
    VecArray points(memory());
    for (int i = 0; i < count; ++i) points.push_back(glm::normalize(pseudo_random(i)));
    return points;
}

// Half of the points are in a cluster of size 0.001 beside a corner, and nine coincide.
VecArray uneven(int count) {
    VecArray points(memory());
    for (int i = 0; i < count; ++i)
        points.push_back(i < 9        ? glm::dvec3(0.5)
                         : i % 2 == 0 ? glm::dvec3(0.9) + 1e-3 * pseudo_random(i)
                                      : pseudo_random(i));
    return points;
}

VecArray line(int count) {
    VecArray points(memory());
    for (int i = 0; i < count; ++i) points.push_back({0.0, 1e6 + i, 0.0});
    return points;
}

VecArray coincident(int count) {
    VecArray points(memory());
    for (int i = 0; i < count; ++i) points.push_back({1.0, 2.0, 3.0});
    return points;
}

std::vector<VecArray> clouds() {
    std::vector<VecArray> result;
    result.push_back(surface(500));
    result.push_back(uneven(400));
    result.push_back(line(100));
    result.push_back(coincident(20));
    result.push_back(surface(2));
    result.push_back(surface(1));
    result.push_back(VecArray(memory()));
    return result;
}

TEST(Octree, ContainsEveryPointOnce) {
    for (const VecArray& points : clouds()) {
        const Octree tree(points, 7, 0.0, {});
        ASSERT_EQ(tree.points().size(), points.size());
        std::set<std::int64_t> seen;
        for (std::int64_t at = 0; at < points.size(); ++at) {
            seen.insert(tree.index(at));
            EXPECT_EQ(tree.points()[at], points[tree.index(at)]);
        }
        EXPECT_EQ(static_cast<std::int64_t>(seen.size()), points.size());
        std::vector<int> leaves(static_cast<std::size_t>(points.size()));
        for (const Octree::Node& node : tree.nodes())
            for (std::int64_t at = node.begin; node.leaf() && at < node.end; ++at)
                ++leaves[static_cast<std::size_t>(at)];
        EXPECT_EQ(leaves, std::vector<int>(leaves.size(), 1));
    }
}

TEST(Octree, LeavesHoldFewPointsUnlessTheyAreTheDeepest) {
    for (const VecArray& points : clouds()) {
        for (const std::int64_t leaf_size : {1, 7, 64, 1000}) {
            const Octree tree(points, leaf_size, 0.0, {});
            for (const Octree::Node& node : tree.nodes()) {
                if (node.leaf() && node.level < Octree::deepest_level) {
                    EXPECT_LE(node.count(), leaf_size);
                }
                if (!node.leaf()) {
                    EXPECT_GT(node.count(), leaf_size);
                }
            }
        }
    }
    const Octree deep(coincident(20), 7, 0.0, {});
    EXPECT_EQ(deep.levels(), Octree::deepest_level + 1);
    EXPECT_EQ(deep.nodes()[deep.nodes().size() - 1].count(), 20);
    EXPECT_EQ(Octree(surface(100), 100, 0.0, {}).levels(), 1);
}

TEST(Octree, CubesContainTheirPoints) {
    for (const VecArray& points : clouds()) {
        const Octree tree(points, 7, 0.0, {});
        for (const Octree::Node& node : tree.nodes()) {
            const double half = tree.half_width(node.level);
            EXPECT_EQ(half, std::ldexp(tree.half_width(0), -node.level));
            for (std::int64_t at = node.begin; at < node.end; ++at)
                for (glm::length_t c = 0; c < 3; ++c)
                    EXPECT_LE(std::abs(tree.points()[at][c] - tree.centre(node)[c]),
                              half + 1e-9 * tree.half_width(0) + 1e-15 * std::abs(tree.points()[at][c]));
        }
    }
}

TEST(Octree, ChildrenFollowEachOtherAndShareTheParentsPoints) {
    for (const VecArray& points : clouds()) {
        const Octree tree(points, 7, 0.0, {});
        EXPECT_EQ(tree.nodes()[0].parent, 0);
        for (std::int64_t i = 0; i < tree.nodes().size(); ++i) {
            const Octree::Node& node = tree.nodes()[i];
            std::int64_t at = node.begin;
            for (std::int64_t k = node.first_child; k < node.first_child + node.children; ++k) {
                const Octree::Node& child = tree.nodes()[k];
                EXPECT_EQ(child.parent, i);
                EXPECT_EQ(child.level, node.level + 1);
                EXPECT_EQ(child.begin, at);
                EXPECT_GT(child.count(), 0);
                at = child.end;
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_EQ(child.cell[c], 2 * node.cell[c] + (Octree::octant(child) >> c & 1));
            }
            EXPECT_EQ(at, node.leaf() ? node.begin : node.end);
        }
    }
}

TEST(Octree, NodesAreOrderedByLevelAlongACurve) {
    for (const VecArray& points : clouds()) {
        const Octree tree(points, 7, 0.0, {});
        EXPECT_EQ(tree.level_begin(0), 0);
        EXPECT_EQ(tree.level_end(tree.levels() - 1), tree.nodes().size());
        for (std::int32_t level = 0; level < tree.levels(); ++level) {
            ASSERT_LT(tree.level_begin(level), tree.level_end(level));
            for (std::int64_t i = tree.level_begin(level); i < tree.level_end(level); ++i) {
                EXPECT_EQ(tree.nodes()[i].level, level);
                if (i > tree.level_begin(level)) {
                    EXPECT_GE(tree.nodes()[i].begin, tree.nodes()[i - 1].end);
                }
            }
        }
    }
}

bool touching(const Octree::Node& a, const Octree::Node& b) {
    return std::abs(a.cell[0] - b.cell[0]) < 2 && std::abs(a.cell[1] - b.cell[1]) < 2 &&
           std::abs(a.cell[2] - b.cell[2]) < 2;
}

template <class Visit>
void for_each_pair(const base::Array<std::int64_t>& begin, const base::Array<std::int64_t>& list, std::int64_t nodes,
                   Visit&& visit) {
    for (std::int64_t node = 0; node < nodes; ++node)
        for (std::int64_t k = begin[node]; k < begin[node + 1]; ++k) visit(node, list[k]);
}

TEST(OctreeInteractions, CoverEveryPairOfPointsOnce) {
    for (const VecArray& points : clouds()) {
        for (const std::int64_t leaf_size : {1, 7, 64}) {
            const Octree tree(points, leaf_size, 0.0, {});
            const OctreeInteractions lists = octree_interactions(tree);
            const auto n = static_cast<std::size_t>(points.size());
            std::vector<std::uint8_t> covered(n * n);
            const auto cover = [&](std::int64_t target, std::int64_t source) {
                const Octree::Node& t = tree.nodes()[target];
                const Octree::Node& s = tree.nodes()[source];
                for (std::int64_t i = t.begin; i < t.end; ++i)
                    for (std::int64_t j = s.begin; j < s.end; ++j)
                        ++covered[static_cast<std::size_t>(i) * n + static_cast<std::size_t>(j)];
            };
            for_each_pair(lists.far_begin, lists.far, tree.nodes().size(), cover);
            for_each_pair(lists.near_begin, lists.near, tree.nodes().size(), cover);
            EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), static_cast<std::ptrdiff_t>(n * n))
                << n << " " << leaf_size;
        }
    }
}

TEST(OctreeInteractions, FarCubesDoNotTouchButTheirParentsDo) {
    for (const VecArray& points : clouds()) {
        const Octree tree(points, 7, 0.0, {});
        const OctreeInteractions lists = octree_interactions(tree);
        for_each_pair(lists.far_begin, lists.far, tree.nodes().size(), [&](std::int64_t target, std::int64_t source) {
            const Octree::Node& t = tree.nodes()[target];
            const Octree::Node& s = tree.nodes()[source];
            EXPECT_EQ(t.level, s.level);
            EXPECT_FALSE(touching(t, s));
            EXPECT_TRUE(touching(tree.nodes()[t.parent], tree.nodes()[s.parent]));
        });
    }
    EXPECT_FALSE(octree_interactions(Octree(surface(500), 7, 0.0, {})).far.empty());
}

TEST(OctreeInteractions, NearnessIsMutual) {
    for (const VecArray& points : clouds()) {
        const Octree tree(points, 7, 0.0, {});
        const OctreeInteractions lists = octree_interactions(tree);
        std::set<std::pair<std::int64_t, std::int64_t>> near;
        for_each_pair(lists.near_begin, lists.near, tree.nodes().size(), [&](std::int64_t target, std::int64_t source) {
            near.emplace(target, source);
            EXPECT_TRUE(tree.nodes()[target].leaf() || tree.nodes()[source].leaf());
        });
        for (const auto& [target, source] : near) EXPECT_EQ(near.count({source, target}), 1U);
    }
}

} // namespace
} // namespace hrbfnpr::geometry::octree_test
