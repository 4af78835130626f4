// SPDX-License-Identifier: MIT
// Tests normals of points along curves, whose neighbours do not determine a plane.
#include "shapes.h"

#include <gtest/gtest.h>

namespace orient_test::curves_test {
namespace {

using namespace hrbfnpr;
using orient::NormalMode;
using orient::OutwardBy;

// A search that begins with planes through neighbours gets 0.87 and 0.28 of these right. Begun with the first points of
// the farthest-first order, it gets all right.
TEST(OrientCurves, IsRightForDistantWires) {
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

TEST(OrientCurves, IsRightForCrossSections) {
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

// Noise of 0.2 to 0.9 spacings begins to hide the wires. The directions are then taken from fewer points.
TEST(OrientCurves, IsRightWithNoise) {
    for (const double noise : {0.01, 0.02, 0.045}) expect_right(test::torus_wires(0.05), noise, 20.0);
}

// A part of more than 6000 points is enough. With noise of four spacings every sixteenth point still follows the
// wires.
TEST(OrientCurves, IsRightForManyPoints) {
    const Samples wires = test::torus_wires(0.005);
    ASSERT_GT(wires.count(), 6000);
    for (const double noise : {0.0, 0.02}) expect_right(wires, noise, 10.0);
}

// Planes through neighbours on a wire give such normals: a quarter of them are in the surface.
TEST(OrientCurves, ReplacesNormalsThatLieInTheSurface) {
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
