// SPDX-License-Identifier: MIT
// Tests that pieces of crest lines, found one triangle after the other, are joined.
#include "hatching/lines.h"

#include "base/runtime.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hrbfnpr::testing::join_test {
namespace {

using hatching::Lines;
using Polyline = std::vector<glm::dvec3>;

// A straight line in the plane z = 0 with ten points per unit of length.
Polyline line(double x0, double y0, double x1, double y1) {
    const int count = std::max(1, static_cast<int>(std::lround(10.0 * std::hypot(x1 - x0, y1 - y0))));
    Polyline points;
    for (int i = 0; i <= count; ++i)
        points.emplace_back(std::lerp(x0, x1, double(i) / count), std::lerp(y0, y1, double(i) / count), 0.0);
    return points;
}

class JoinLines : public ::testing::Test {
protected:
    // Joins lines over gaps of up to 2.
    Lines join(const std::vector<Polyline>& lines) {
        Lines all(runtime.memory);
        for (const Polyline& points : lines) {
            for (const glm::dvec3& p : points) {
                all.position.push_back(p);
                all.normal.push_back({0.0, 0.0, 1.0});
                all.level.push_back(0);
            }
            all.end_line(false);
        }
        return hatching::join_ends(all, 2.0, base::Progress());
    }
    // The largest backward step of a line along x.
    static double back(const Lines& lines) {
        double most = 0.0;
        for (std::int64_t i = 1; i < lines.position.size(); ++i) {
            const double step = lines.position[i].x - lines.position[i - 1].x;
            most = std::max(most, lines.position[0].x < lines.position[lines.position.size() - 1].x ? -step : step);
        }
        return most;
    }

    base::Runtime runtime;
};

TEST_F(JoinLines, ConnectsLinesAcrossASmallGap) {
    EXPECT_EQ(join({line(-3, 0, -0.8, 0), line(0.8, 0.1, 3, 0.1)}).count(), 1);
    EXPECT_EQ(join({line(-3, 0, -0.8, 0), line(0.8, 1.0, 3, 1.0)}).count(), 2) << "aside";
    EXPECT_EQ(join({line(-3, 0, -0.1, 0), line(0.1, 0.6, 3, 0.6)}).count(), 1) << "less aside than the next line";
    EXPECT_EQ(join({line(-3, 0, -1.2, 0), line(1.2, 0.0, 3, 0.0)}).count(), 2) << "too far";
    EXPECT_EQ(join({line(-3, 0, -0.8, 0), line(0.8, 0.0, 0.8, 3.0)}).count(), 2) << "a corner";
}

// If the ends touch, the way across the gap may have any direction.
TEST_F(JoinLines, ConnectsLinesWhoseEndsTouch) {
    for (int k = 0; k < 12; ++k) {
        const double x = 0.1 * std::cos(0.5236 * k);
        const double y = 0.1 * std::sin(0.5236 * k);
        const Lines lines = join({line(-3, 0, 0, 0), line(3, y, x, y)});
        ASSERT_EQ(lines.count(), 1) << x << ' ' << y;
        EXPECT_LT(back(lines), 1e-9) << x << ' ' << y;
    }
    // A bend is joined, but not a corner and not a fork.
    EXPECT_EQ(join({line(-3, 0, 0, 0), line(0.02, 0.02, 3, 1.5)}).count(), 1);
    EXPECT_EQ(join({line(-3, 0, 0, 0), line(0.02, 0.02, 3, 6)}).count(), 2);
    EXPECT_EQ(join({line(-3, 0, 0, 0), line(-3, 0.2, 0, 0.2)}).count(), 2);
    EXPECT_EQ(join({line(-3, 0, 0, 0), line(-3, 0.2, 0, 0.2), line(0.05, 0.05, 3, 0.0)}).count(), 2);
}

// The last points of a line may be ragged, so they do not tell its direction.
TEST_F(JoinLines, IgnoresRaggedEnds) {
    Polyline ragged = line(-3, 0, 0, 0);
    for (const double y : {0.03, 0.07, 0.12}) ragged.emplace_back(0.02, y, 0.0);
    EXPECT_EQ(join({ragged, line(0.05, 0.1, 3, 0)}).count(), 1);
}

} // namespace
} // namespace hrbfnpr::testing::join_test
