// SPDX-License-Identifier: MIT
#include "curves/curves.h"

#include "support/runtime.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace hrbfnpr::curves::near_curves_test {
namespace {

// A point of a circle, anticlockwise: f = z, and g is the distance from the z axis minus the radius.
CurvePoint on_circle(double radius, double angle) {
    CurvePoint p;
    const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0);
    p.position = radius * out;
    p.gradient = {0.0, 0.0, 1.0};
    p.level_gradient = out;
    return p;
}

TEST(CubicPiece, ApproximatesAnArcOfACircle) {
    constexpr double radius = 3.0;
    for (const double angle : {0.01, 0.25, 0.4, 0.8}) {
        const CubicPiece piece(on_circle(radius, 0.0), on_circle(radius, angle));
        EXPECT_NEAR(glm::length(piece.at(0.5)), radius, 1e-14 * radius);
        for (double u = 0.0; u <= 1.0; u += 0.05)
            EXPECT_NEAR(glm::length(piece.at(u)), radius, 1e-4 * std::pow(angle, 6) * radius + 1e-14) << angle;
    }
}

// This case occurs on the border of a surface where its support is constant.
TEST(CubicPiece, FollowsTheChordWhereTheCurveHasNoDirection) {
    CurvePoint flat = on_circle(3.0, 0.0);
    flat.level_gradient = glm::dvec3(0.0);
    CurvePoint none = on_circle(3.0, 0.4);
    none.level_gradient = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    const CubicPiece piece(flat, none);
    for (double u = 0.0; u <= 1.0; u += 0.25)
        EXPECT_LT(glm::distance(piece.at(u), glm::mix(flat.position, none.position, u)), 1e-14);
    const CubicPiece point(flat, flat);
    EXPECT_EQ(point.at(0.5), flat.position);
}

// Two concentric circles.
Curves circles(base::Memory& memory) {
    constexpr int points = 40;
    Curves curves(memory);
    for (const double radius : {1.0, 1.3}) {
        for (int i = 0; i < points; ++i) curves.point.push_back(on_circle(radius, 2.0 * std::numbers::pi * i / points));
        curves.first.push_back(curves.point.size());
        curves.closed.push_back(1);
    }
    return curves;
}

TEST(NearCurves, PassAPlaceIfTheirNearestPointIsNear) {
    constexpr double distance = 0.05;
    const base::Runtime runtime = test::with_threads(1);
    const Curves curves = circles(runtime.memory);
    const NearCurves near(curves, 0.25, distance);
    int found = 0;
    for (int i = 0; i < 300; ++i) {
        const double angle = 0.1 * i;
        const double radius = 0.9 + 0.0017 * i;
        const glm::dvec3 place = radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0);
        for (const double way : {1.0, -1.0}) {
            const glm::dvec3 along = way * glm::dvec3(-std::sin(angle), std::cos(angle), 0.0);
            const std::int64_t curve = near.passing(place, along, distance);
            // The outer circle is the nearer one from the middle between both.
            const std::int64_t nearer = radius < 1.15 ? 0 : 1;
            const bool is_near = way > 0.0 && std::abs(radius - (nearer == 0 ? 1.0 : 1.3)) <= distance;
            EXPECT_EQ(curve, is_near ? nearer : -1) << i;
            if (is_near) {
                EXPECT_EQ(near.passing(place, along, distance, nearer), -1);
            }
            found += curve >= 0 ? 1 : 0;
        }
    }
    EXPECT_GT(found, 50);
    EXPECT_LT(found, 200);
}

} // namespace
} // namespace hrbfnpr::curves::near_curves_test
