// SPDX-License-Identifier: MIT
#include "geometry/point_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hrbfnpr::geometry::point_tree_test {
namespace {

using Places = std::vector<std::int64_t>;

base::Memory& memory() {
    static base::Memory instance;
    return instance;
}

// Clusters of two sizes.
VecArray scattered(int count) {
    VecArray points(memory());
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 p(std::sin(12.9898 * i), std::sin(78.233 * i + 1.0), std::sin(37.719 * i + 2.0));
        points.push_back(i % 4 == 0 ? 1e-3 * p : p);
    }
    return points;
}

// A lattice with many equal distances, in which each point occurs twice.
VecArray lattice(int side) {
    VecArray points(memory());
    for (int twice = 0; twice < 2; ++twice)
        for (int i = 0; i < side * side * side; ++i) points.push_back({i % side, i / side % side, i / (side * side)});
    return points;
}

double squared_distance(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a - b, a - b); }

// Computes the result that nearest() promises: ordered by distance, then by place.
template <class Accept>
Places brute_force(const PointTree& tree, const glm::dvec3& p, std::int64_t count, Accept&& accept) {
    Places places;
    for (std::int64_t at = 0; at < tree.size(); ++at)
        if (accept(at)) places.push_back(at);
    std::stable_sort(places.begin(), places.end(), [&](std::int64_t a, std::int64_t b) {
        return squared_distance(tree.points()[a], p) < squared_distance(tree.points()[b], p);
    });
    places.resize(std::min(places.size(), static_cast<std::size_t>(count)));
    return places;
}

// The nearest of the points whose rank is below `limit`.
Places nearest(const PointTree& tree, const Places& rank, std::int64_t limit, const glm::dvec3& p, std::int64_t count) {
    const auto rank_at = [&](std::int64_t at) { return rank[static_cast<std::size_t>(at)]; };
    const base::Array<std::int64_t> smallest = tree.smallest_of_nodes(rank_at);
    Places found(static_cast<std::size_t>(count));
    found.resize(static_cast<std::size_t>(tree.nearest(
        p, count, [&](std::int64_t node) { return smallest[node] < limit; },
        [&](std::int64_t at) { return rank_at(at) < limit; }, found.data())));
    return found;
}

Places shuffled_ranks(std::int64_t count) {
    Places rank;
    for (std::int64_t at = 0; at < count; ++at) rank.push_back(at * 7919 % count);
    return rank;
}

void expect_nearest(const VecArray& points) {
    const PointTree tree(points, {});
    const Places rank = shuffled_ranks(tree.size());
    for (std::int64_t i = 0; i < tree.size(); i += 1 + tree.size() / 40) {
        for (const glm::dvec3& p : {tree.points()[i], tree.points()[i] + glm::dvec3(0.5, 0.25, -0.125)}) {
            for (const std::int64_t limit : {std::int64_t{0}, std::int64_t{3}, tree.size() / 3, tree.size()}) {
                const auto accept = [&](std::int64_t at) { return rank[static_cast<std::size_t>(at)] < limit; };
                for (const std::int64_t count : {1, 2, 16, 48})
                    ASSERT_EQ(nearest(tree, rank, limit, p, count), brute_force(tree, p, count, accept))
                        << tree.size() << " " << i << " " << limit << " " << count;
            }
        }
    }
}

TEST(PointTreeNearest, MatchesABruteForceSearch) {
    for (const int count : {1, 2, 8, 9, 17, 100, 777}) expect_nearest(scattered(count));
}

TEST(PointTreeNearest, BreaksTiesByPosition) { expect_nearest(lattice(6)); }

TEST(PointTreeNearest, IsEmptyWithoutPointsOrACount) {
    const auto all = [](std::int64_t) { return true; };
    std::int64_t found = -1;
    EXPECT_EQ(PointTree(VecArray(memory()), {}).nearest({0, 0, 0}, 1, all, all, &found), 0);
    EXPECT_EQ(PointTree(scattered(20), {}).nearest({0, 0, 0}, 0, all, all, &found), 0);
    EXPECT_EQ(found, -1);
}

// Returns the points that a search does not visit if it refuses node `refused`.
Places points_of(const PointTree& tree, std::int64_t refused) {
    std::vector<bool> shown(static_cast<std::size_t>(tree.size()));
    std::int64_t found = 0;
    tree.nearest(
        {0, 0, 0}, 1, [&](std::int64_t node) { return node != refused; },
        [&](std::int64_t at) {
            shown[static_cast<std::size_t>(at)] = true;
            return false;
        },
        &found);
    Places hidden;
    for (std::int64_t at = 0; at < tree.size(); ++at)
        if (!shown[static_cast<std::size_t>(at)]) hidden.push_back(at);
    return hidden;
}

TEST(PointTreeNodes, KnowTheSmallestValueOfTheirPoints) {
    for (const int count : {1, 8, 9, 60, 333}) {
        const PointTree tree(scattered(count), {});
        const auto value = [&](std::int64_t at) { return (at * 271 + 5) % 997 - 400; };
        const base::Array<std::int64_t> smallest = tree.smallest_of_nodes(value);
        ASSERT_EQ(smallest.size(), tree.nodes());
        std::int64_t nodes = 0;
        for (std::int64_t node = 0; node < tree.nodes(); ++node) {
            const Places places = points_of(tree, node);
            if (places.empty()) continue; // no node has this number
            ++nodes;
            std::int64_t least = value(places.front());
            for (const std::int64_t at : places) least = std::min(least, value(at));
            EXPECT_EQ(smallest[node], least) << count << " " << node;
        }
        EXPECT_GE(8 * nodes, count);
    }
    EXPECT_TRUE(PointTree(VecArray(memory()), {}).smallest_of_nodes([](std::int64_t) { return 0; }).empty());
}

} // namespace
} // namespace hrbfnpr::geometry::point_tree_test
