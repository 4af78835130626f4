// SPDX-License-Identifier: MIT
// Normals of points along curves, whose neighbours tell no plane.
#include "shapes.h"

#include <gtest/gtest.h>

namespace orient_test::curves_test {
namespace {

using namespace hrbfnpr;
using orient::NormalMode;
using orient::OutwardBy;

// Begun from planes through neighbours 0.87 and 0.28 of these are right, from the first of the farthest-first order
// all.
TEST(OrientCurves, IsRightWhereTheyAreFarApart) {
    const base::Runtime runtime;
    for (const double spacing : {0.05, 0.065}) {
        const Samples wires = test::torus_wires(spacing);
        const orient::Orientation result = orient::orient(runtime, input(wires));
        EXPECT_EQ(score(wires, result.normal).right, 1.0) << spacing;
        EXPECT_LT(score(wires, result.normal).angle, 3.0) << spacing;
        EXPECT_EQ(result.report.outward_by, OutwardBy::inside);
        EXPECT_TRUE(result.report.closed);
    }
}

TEST(OrientCurves, IsRightOfCrossSections) {
    const base::Runtime runtime;
    const Samples sections = test::torus_sections(9, 60);
    const orient::Orientation result = orient::orient(runtime, input(sections));
    EXPECT_EQ(score(sections, result.normal).right, 1.0);
    EXPECT_TRUE(result.report.closed);
    EXPECT_GT(result.report.confidence, 0.5);
}

void expect_right(const Samples& wires, double noise, double angle) {
    const base::Runtime runtime;
    const orient::Orientation result = orient::orient(runtime, input(test::with_noise(wires, noise)));
    EXPECT_EQ(score(wires, result.normal).right, 1.0) << noise;
    EXPECT_LT(score(wires, result.normal).angle, angle) << noise;
    EXPECT_TRUE(result.report.closed) << noise;
}

// Of noise of 0.2 to 0.9 spacings, which begins to hide the wires, directions are those of fewer points.
TEST(OrientCurves, IsRightWithNoise) {
    for (const double noise : {0.01, 0.02, 0.045}) expect_right(test::torus_wires(0.05), noise, 20.0);
}

// Of more than 6000 fewer are enough; with noise of four spacings every sixteenth still lies along the wires.
TEST(OrientCurves, IsRightOfMany) {
    const Samples wires = test::torus_wires(0.005);
    ASSERT_GT(wires.count(), 6000);
    for (const double noise : {0.0, 0.02}) expect_right(wires, noise, 10.0);
}

// As planes through neighbours on a wire have them: a quarter lie in the surface.
TEST(OrientCurves, MakesNormalsAnewOfWhichManyLieInTheSurface) {
    const base::Runtime runtime;
    const Samples sections = test::torus_sections(9, 60);
    Samples given = sections;
    for (std::size_t i = 0; i < given.normals.size(); i += 12) {
        const double x = given.normals[i];
        given.normals[i] = given.normals[i + 2];
        given.normals[i + 1] = 0.0;
        given.normals[i + 2] = -x;
    }
    orient::OrientInput wanted = input(sections);
    wanted.normals = view(given.normals);
    const orient::Orientation result = orient::orient(runtime, wanted);
    EXPECT_EQ(result.report.found, NormalMode::none);
    EXPECT_EQ(score(sections, result.normal).right, 1.0);
}

} // namespace
} // namespace orient_test::curves_test
