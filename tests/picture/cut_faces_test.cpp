// SPDX-License-Identifier: MIT
#include "picture/cut_faces.h"

#include "base/status.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

namespace picture_tests::cut_faces_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

class CutFacesTest : public testing::Test {
protected:
    void add(std::initializer_list<glm::dvec2> points) { parts.emplace_back().assign(points.begin(), points.end()); }
    void add_square(double low, double high) { add({{low, low}, {high, low}, {high, high}, {low, high}, {low, low}}); }
    // Returns the length of all hatch lines together.
    double length(double period) {
        double sum = 0.0;
        for (const Segment& line : hatched(parts, period, pool)) sum += glm::length(line[1] - line[0]);
        return sum;
    }

    base::Memory memory;
    Pool pool{memory};
    Vector<Outline> parts{&pool};
};

TEST_F(CutFacesTest, PartsInAnyOrderAndDirectionBecomeOutlines) {
    add({{0, 10}, {10, 10}});
    add({{0, 0}, {0, 10}});
    add({{20, 0}, {30, 0}, {25, 5}, {20, 0}}); // This outline is closed without the others.
    add({{10, 0}, {0, 0}});
    add({{10, 10}, {10, 0}});
    const auto found = closed_outlines(parts, pool);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0], (Outline{{{10, 10}, {10, 0}, {0, 0}, {0, 10}, {10, 10}}, &pool}));
    EXPECT_EQ(found[1].size(), 4U);
}

TEST_F(CutFacesTest, OpenOutlinesAreLeftOut) {
    EXPECT_TRUE(closed_outlines(parts, pool).empty());
    add({});
    add({{1, 1}});
    add({{0, 0}, {5, 0}});
    add({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0.5}}); // The gap is more than a thousandth of its length.
    const double nan = std::numeric_limits<double>::quiet_NaN();
    add({{nan, nan}, {0, 0}, {nan, 0}, {1, 1}, {nan, nan}});
    EXPECT_TRUE(closed_outlines(parts, pool).empty());
    parts.clear();
    add({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0.02}});
    EXPECT_EQ(closed_outlines(parts, pool).size(), 1U);
}

TEST_F(CutFacesTest, SkinsOfAWallBecomeOneOutline) {
    add({{0, 0}, {0, 10}, {10, 10}, {10, 0}}); // the outer skin of an arch
    add({{9.5, 0}, {9.5, 9.5}, {0.5, 9.5}, {0.5, 0}});
    add({{50, 0}, {60, 0}, {60, 10}, {50, 10}}); // a sheet whose ends are far from each other
    EXPECT_TRUE(closed_outlines(parts, pool).empty());
    const ClosedOutlines found = close_outlines(parts, 0.03, pool);
    ASSERT_EQ(found.closed.size(), 1U);
    EXPECT_EQ(found.open, 1);
    parts = found.closed;
    EXPECT_NEAR(length(0.1) * 0.1, 10.0 * 10.0 - 9.5 * 9.0, 0.5);
}

TEST_F(CutFacesTest, LinesRiseToTheRightInsideAndHolesStayEmpty) {
    add_square(0, 100);
    const double period = 0.5;
    EXPECT_NEAR(length(period) * period, 100.0 * 100.0, 1.0);
    add_square(20, 80);
    EXPECT_NEAR(length(period) * period, 100.0 * 100.0 - 60.0 * 60.0, 1.0);
    for (const Segment& line : hatched(parts, period, pool)) {
        const glm::dvec2 along = line[1] - line[0];
        EXPECT_NEAR(along.x, -along.y, 1e-9); // y grows downward.
        const double number = (line[0].x + line[0].y) / std::numbers::sqrt2 / period - 0.5;
        EXPECT_NEAR(number, std::nearbyint(number), 1e-9);
        const glm::dvec2 middle = 0.5 * (line[0] + line[1]);
        const bool in_hole = middle.x > 20.0 && middle.x < 80.0 && middle.y > 20.0 && middle.y < 80.0;
        EXPECT_FALSE(in_hole);
    }
}

TEST_F(CutFacesTest, NonFiniteOutlinesGetNoLinesAndTooManyAreRefused) {
    EXPECT_TRUE(hatched(parts, 1.0, pool).empty());
    add({{0, 0}, {std::numeric_limits<double>::infinity(), 0}, {0, 1}});
    EXPECT_TRUE(hatched(parts, 1.0, pool).empty());
    add_square(0, 10);
    EXPECT_FALSE(hatched(parts, 1.0, pool).empty());
    EXPECT_THROW(static_cast<void>(hatched(parts, 1e-9, pool)), Error);
    parts.clear();
    add_square(1e20, 1e20 + 1e5); // Neighbouring doubles are farther apart than a period.
    EXPECT_LT(hatched(parts, 1.0, pool).size(), 1000000U);
}

} // namespace
} // namespace picture_tests::cut_faces_test
