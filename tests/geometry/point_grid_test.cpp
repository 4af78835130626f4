// SPDX-License-Identifier: MIT
#include "geometry/point_grid.h"

#include "base/status.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hrbfnpr::geometry::point_grid_test {
namespace {

TEST(PointGrid, VisitsEveryPointOfABallOnce) {
    base::Memory memory;
    VecArray points(memory);
    for (int i = 0; i < 3000; ++i)
        points.push_back({std::fmod(0.7548 * i, 1.0), std::fmod(0.5698 * i, 1.0), std::fmod(0.3247 * i, 0.1)});
    const double radius = 0.06;
    const PointGrid grid(points, radius);
    ASSERT_EQ(grid.size(), 3000);
    for (int q = 0; q < 200; ++q) {
        const glm::dvec3 p(std::fmod(0.31 * q, 1.2) - 0.1, std::fmod(0.77 * q, 1.2) - 0.1, 0.05);
        std::vector<int> visits(3000, 0);
        grid.around(p, [&](std::int64_t at) { ++visits[static_cast<std::size_t>(grid.index(at))]; });
        for (int i = 0; i < 3000; ++i) {
            const int times = visits[static_cast<std::size_t>(i)];
            ASSERT_LE(times, 1);
            ASSERT_TRUE(times == 1 || glm::distance(points[i], p) >= radius) << i;
        }
    }
}

TEST(PointGrid, ReordersValuesLikeItsPoints) {
    base::Memory memory;
    VecArray points(memory);
    for (int i = 0; i < 500; ++i) points.push_back({std::fmod(0.7548 * i, 1.0), std::fmod(0.5698 * i, 1.0), 0.01 * i});
    const PointGrid grid(points, 0.2);
    const VecArray sorted = grid.in_order(points);
    ASSERT_EQ(sorted.size(), grid.size());
    for (std::int64_t at = 0; at < grid.size(); ++at) EXPECT_EQ(sorted[at], points[grid.index(at)]);
}

TEST(PointGrid, AcceptsNoPointsAndCoincidentPoints) {
    base::Memory memory;
    int visits = 0;
    PointGrid(VecArray(memory), 1.0).around({0, 0, 0}, [&](std::int64_t) { ++visits; });
    EXPECT_EQ(visits, 0);
    PointGrid(VecArray(memory, 7), 0.5).around({0, 0, 0.1}, [&](std::int64_t) { ++visits; });
    EXPECT_EQ(visits, 7);
}

} // namespace
} // namespace hrbfnpr::geometry::point_grid_test
