// SPDX-License-Identifier: MIT
#include "geometry/farthest_order.h"

#include "base/status.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace hrbfnpr::geometry::farthest_order_test {
namespace {

base::Memory& memory() {
    static base::Memory instance;
    return instance;
}

VecArray scattered(int count) {
    VecArray points(memory());
    for (int i = 0; i < count; ++i)
        points.push_back({std::sin(12.9898 * i), std::sin(78.233 * i + 1.0), 0.3 * std::sin(37.719 * i + 2.0)});
    return points;
}

// A lattice with many equal distances, in which each point occurs twice.
VecArray lattice(int side) {
    VecArray points(memory());
    for (int twice = 0; twice < 2; ++twice)
        for (int i = 0; i < side * side * side; ++i) points.push_back({i % side, i / side % side, i / (side * side)});
    return points;
}

double squared(const glm::dvec3& v) { return glm::dot(v, v); }

void expect_naive(const VecArray& points, std::int64_t count) {
    const FarthestOrder order = farthest_order(points, count, {});
    const std::int64_t picks = count > 0 ? std::min(count, points.size()) : points.size();
    ASSERT_EQ(order.order.size(), picks);
    ASSERT_EQ(order.distance.size(), picks);
    Bounds bounds;
    for (std::int64_t i = 0; i < points.size(); ++i) bounds.extend(points[i]);
    std::vector<double> distance;
    for (std::int64_t i = 0; i < points.size(); ++i) distance.push_back(-squared(points[i] - bounds.centre()));
    for (std::int64_t k = 0; k < picks; ++k) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < distance.size(); ++i)
            if (distance[i] > distance[best]) best = i;
        ASSERT_EQ(order.order[k], static_cast<std::int64_t>(best)) << k;
        ASSERT_EQ(order.distance[k], k == 0 ? HUGE_VAL : std::sqrt(distance[best])) << k;
        const glm::dvec3 p = points[static_cast<std::int64_t>(best)];
        for (std::size_t i = 0; i < distance.size(); ++i) {
            const double near = squared(points[static_cast<std::int64_t>(i)] - p);
            distance[i] = k == 0 ? near : std::min(distance[i], near);
        }
        distance[best] = -1.0;
        for (std::int64_t j = 0; j < k; ++j) distance[static_cast<std::size_t>(order.order[j])] = -1.0;
    }
}

TEST(FarthestOrder, MatchesANaiveSearch) {
    for (const int count : {1, 2, 15, 16, 17, 33, 100, 1000}) expect_naive(scattered(count), 0);
    expect_naive(scattered(1000), 37);
    expect_naive(scattered(10), 99);
    for (const int few : {1, 2, 8, 16, 17}) expect_naive(scattered(1000), few);
}

TEST(FarthestOrder, BreaksTiesByIndexAndTakesEachPointOnce) {
    expect_naive(lattice(7), 0);
    expect_naive(lattice(7), 16);
    expect_naive(lattice(2), 16);
}

TEST(FarthestOrder, IsEmptyWithoutPoints) { EXPECT_TRUE(farthest_order(VecArray(memory()), 0, {}).order.empty()); }

TEST(FarthestOrder, DistancesNeverRise) {
    const FarthestOrder order = farthest_order(scattered(30000), 0, {});
    for (std::int64_t k = 1; k < order.order.size(); ++k) ASSERT_LE(order.distance[k], order.distance[k - 1]) << k;
}

} // namespace
} // namespace hrbfnpr::geometry::farthest_order_test
