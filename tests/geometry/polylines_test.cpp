// SPDX-License-Identifier: MIT
// Tests Bezier curves through points: they are near to all of the line, few, and keep its corners and ends.
#include "geometry/polylines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hrbfnpr::testing::polylines_test {
namespace {

using geometry::Cubic;
using geometry::CurveFit;
using glm::dvec2;

constexpr double pi = 3.141592653589793;

dvec2 at(const dvec2& start, const Cubic& c, double t) {
    const double s = 1.0 - t;
    return s * s * s * start + 3.0 * s * s * t * c.control_1 + 3.0 * s * t * t * c.control_2 + t * t * t * c.end;
}

double to_segment(const dvec2& p, const dvec2& a, const dvec2& b) {
    const double square = glm::dot(b - a, b - a);
    const double t = square > 0.0 ? std::clamp(glm::dot(p - a, b - a) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * (b - a));
}

double to_line(const dvec2& p, const std::vector<dvec2>& line) {
    double least = 1e300;
    for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, to_segment(p, line[i - 1], line[i]));
    return least;
}

// The larger of the two one-sided distances: curves to line, and line to curves.
double apart(const std::vector<dvec2>& line, const dvec2& start, std::span<const Cubic> cubics) {
    std::vector<dvec2> fine{start};
    dvec2 from = start;
    for (const Cubic& cubic : cubics) {
        for (int k = 1; k <= 64; ++k) fine.push_back(at(from, cubic, k / 64.0));
        from = cubic.end;
    }
    double most = 0.0;
    for (const dvec2& p : fine) most = std::max(most, to_line(p, line));
    for (std::size_t i = 1; i < line.size(); ++i)
        for (int k = 0; k <= 8; ++k)
            most = std::max(most, to_line(line[i - 1] + k / 8.0 * (line[i] - line[i - 1]), fine));
    return most;
}

class CurveFitTest : public ::testing::Test {
protected:
    base::Memory memory;
    CurveFit fit{memory};
};

std::vector<dvec2> wave(int points) {
    std::vector<dvec2> line;
    for (int i = 0; i <= points; ++i) {
        const double x = 100.0 * i / points;
        line.push_back({x, 10.0 * std::sin(0.2 * x) + 3.0 * std::cos(0.55 * x)});
    }
    return line;
}

TEST_F(CurveFitTest, IsNearEverywhereWithFewCurves) {
    const std::vector<dvec2> line = wave(2000);
    std::size_t before = 0;
    for (const double tolerance : {0.5, 0.05, 0.005}) {
        const std::span<const Cubic> cubics = fit.fit(line, tolerance, false);
        EXPECT_LE(apart(line, line.front(), cubics), 1.2 * tolerance) << tolerance;
        EXPECT_EQ(cubics.back().end, line.back());
        EXPECT_GT(cubics.size(), before);
        EXPECT_LT(cubics.size(), 100U) << tolerance;
        before = cubics.size();
    }
}

TEST_F(CurveFitTest, StaysNearLongSegments) {
    const std::vector<dvec2> line{{0, 0}, {50, 0.0}, {90, 25}, {91, 26}, {92, 28}, {93, 31}, {60, 80}};
    EXPECT_LE(apart(line, line.front(), fit.fit(line, 0.05, false)), 0.08);
}

// The tolerance is below the rounding errors of these distances, so no number of pieces would be enough. The fit uses
// the largest number of pieces that is allowed, and each piece gets its own curve.
TEST_F(CurveFitTest, TakesPointsAnyDistanceApart) {
    std::vector<dvec2> line{{0, 0}, {50, 0}, {90, 25}, {91, 26}, {92, 28}, {93, 31}, {60, 80}};
    for (dvec2& p : line) p *= std::ldexp(1.0, 120);
    const std::span<const Cubic> cubics = fit.fit(line, 0.05, false);
    EXPECT_GT(cubics.size(), 100U);
    EXPECT_EQ(cubics.back().end, line.back());
}

TEST_F(CurveFitTest, KeepsCorners) {
    const std::vector<dvec2> line{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    const std::span<const Cubic> cubics = fit.fit(line, 0.05, false);
    ASSERT_EQ(cubics.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(cubics[i].end, line[i + 1]);
    EXPECT_LE(apart(line, line.front(), cubics), 1e-9);
}

TEST_F(CurveFitTest, ClosesACircleWithoutACorner) {
    std::vector<dvec2> circle;
    for (int i = 0; i < 200; ++i) circle.push_back({20.0 * std::cos(pi * i / 100.0), 20.0 * std::sin(pi * i / 100.0)});
    circle.push_back(circle.front());
    const std::span<const Cubic> cubics = fit.fit(circle, 0.01, true);
    EXPECT_LE(cubics.size(), 16U);
    EXPECT_EQ(cubics.back().end, circle.front());
    EXPECT_LE(apart(circle, circle.front(), cubics), 0.012);
    const dvec2 before = glm::normalize(cubics.back().end - cubics.back().control_2);
    const dvec2 after = glm::normalize(cubics.front().control_1 - circle.front());
    EXPECT_GT(glm::dot(before, after), 0.999999);
}

TEST_F(CurveFitTest, BeginsARingAtItsCorner) {
    std::vector<dvec2> drop;
    for (int i = 0; i <= 100; ++i) drop.push_back({std::sin(pi * i / 50.0), std::sin(pi * i / 100.0)});
    std::rotate(drop.begin(), drop.begin() + 30, drop.end() - 1);
    drop.back() = drop.front();
    const std::span<const Cubic> cubics = fit.fit(drop, 0.001, true);
    EXPECT_NEAR(glm::length(cubics.back().end), 0.0, 1e-12);
    EXPECT_LE(apart(drop, cubics.back().end, cubics), 0.0015);
}

TEST_F(CurveFitTest, AcceptsDegenerateLines) {
    EXPECT_TRUE(fit.fit({}, 0.05, false).empty());
    const std::vector<dvec2> one(5, dvec2(3.0, 4.0));
    EXPECT_TRUE(fit.fit(one, 0.05, false).empty());
    const std::vector<dvec2> back{{0, 0}, {5, 0}, {0, 0}};
    EXPECT_LE(apart(back, back.front(), fit.fit(back, 0.05, true)), 1e-9);
}

TEST_F(CurveFitTest, DoesNotNestDeeply) {
    std::vector<dvec2> noise;
    std::uint32_t state = 1;
    for (int i = 0; i < 20000; ++i) {
        state = state * 1664525U + 1013904223U;
        noise.push_back({0.01 * i, 1e-3 * (state >> 16U) / 65536.0});
    }
    EXPECT_LE(apart({noise.begin(), noise.begin() + 500}, noise[0], fit.fit(std::span(noise).first(500), 1e-5, false)),
              2e-5);
    EXPECT_GT(fit.fit(noise, 1e-5, false).size(), 10000U);
}

} // namespace
} // namespace hrbfnpr::testing::polylines_test
