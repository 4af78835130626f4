// SPDX-License-Identifier: MIT
// Tests the normals that are found for points without any.
#include "shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace orient_test {

namespace {

using namespace hrbfnpr;
using namespace orient_test;
using orient::OutwardBy;

orient::Orientation oriented(const Samples& samples, const base::Runtime& runtime) {
    return orient::orient(runtime, input(samples));
}

TEST(Orient, FindsOutwardNormalsOfClosedShapesOfAnySize) {
    const base::Runtime runtime;
    for (const Samples& shape : {test::sphere_6(), test::sphere(25), test::sphere(700), test::torus(150),
                                 test::torus(2500), test::bumpy(600)}) {
        const orient::Orientation result = oriented(shape, runtime);
        const Score found = score(shape, result.normal);
        EXPECT_EQ(found.right, 1.0) << shape.count();
        EXPECT_LT(found.angle, shape.count() >= 2000 ? 1.0 : 6.0) << shape.count();
        EXPECT_EQ(result.report.made, shape.count());
        EXPECT_EQ(result.report.outward_by, OutwardBy::inside);
        if (shape.count() < 100) continue;
        EXPECT_TRUE(result.report.closed) << shape.count();
        EXPECT_GT(result.report.confidence, 0.9) << shape.count();
    }
}

// A spanning tree over planes through neighbours is wrong for half of these points.
TEST(Orient, DistinguishesTheSidesOfThinWalls) {
    const base::Runtime runtime;
    for (const double gap : {1.0, 1.5}) {
        const Samples walls = sheets(20, gap);
        const orient::Orientation result = oriented(walls, runtime);
        EXPECT_GE(score(walls, result.normal).right, 0.99) << gap;
        EXPECT_LT(score(walls, result.normal).angle, 8.0) << gap;
    }
}

TEST(Orient, TurnsOpenSheetsUpOrToTheViewpoint) {
    const base::Runtime runtime;
    const Samples sheet = terrain(22);
    orient::OrientInput wanted = input(sheet);
    const orient::Orientation above = orient::orient(runtime, wanted);
    EXPECT_EQ(score(sheet, above.normal).right, 1.0);
    EXPECT_FALSE(above.report.closed);
    EXPECT_EQ(above.report.outward_by, OutwardBy::up);
    wanted.up = {0.0, 0.0, -1.0};
    EXPECT_EQ(score(sheet, orient::orient(runtime, wanted).normal).right, 0.0);
    wanted.has_viewpoint = true;
    wanted.viewpoint = {10.0, 10.0, 50.0};
    const orient::Orientation seen = orient::orient(runtime, wanted);
    EXPECT_EQ(score(sheet, seen.normal).right, 1.0);
    EXPECT_EQ(seen.report.outward_by, OutwardBy::viewpoint);
}

TEST(Orient, TurnsEachOfSeveralSolidsOutward) {
    const base::Runtime runtime;
    Samples two = test::sphere(200);
    const Samples other = test::sphere(200);
    for (std::int64_t i = 0; i < other.count(); ++i) {
        const glm::dvec3 p = at(other.points, i);
        two.add({p.x + 9.0, p.y + 1.0, p.z}, {p.x, p.y, p.z});
    }
    const orient::Orientation result = oriented(two, runtime);
    EXPECT_EQ(score(two, result.normal).right, 1.0);
    EXPECT_EQ(result.report.components, 2);
}

TEST(Orient, ToleratesNoise) {
    const base::Runtime runtime;
    Samples noisy = test::torus(1500);
    std::uint64_t state = 1;
    for (double& x : noisy.points) {
        double sum = -6.0; // approximately normal
        for (int k = 0; k < 12; ++k) {
            state = state * 6364136223846793005U + 1442695040888963407U;
            sum += static_cast<double>(state >> 11U) / 9007199254740992.0;
        }
        x += 0.01 * 3.5 * sum;
    }
    const orient::Orientation result = oriented(noisy, runtime);
    EXPECT_GE(score(noisy, result.normal).right, 0.99);
    EXPECT_LT(score(noisy, result.normal).angle, 15.0);
    EXPECT_GT(result.report.noise, 0.01);
    EXPECT_LT(result.report.noise, 0.07);
    EXPECT_EQ(oriented(test::torus(1500), runtime).report.noise, 0.0);
}

TEST(Orient, ReportsThatRandomPointsHaveNoNormals) {
    const base::Runtime runtime;
    Samples dust;
    for (int i = 0; i < 400; ++i)
        dust.add({std::fmod(i * 0.8191725134, 1.0), std::fmod(i * 0.6710436067, 1.0), std::fmod(i * 0.5497004779, 1.0)},
                 {0.0, 0.0, 1.0});
    EXPECT_LT(oriented(dust, runtime).report.confidence, 0.5);
}

TEST(Orient, MergesPointsThatCoincide) {
    const base::Runtime runtime;
    Samples twice = test::sphere(100);
    const Samples once = test::sphere(100);
    for (std::int64_t i = 0; i < 50; ++i) {
        const glm::dvec3 p = at(once.points, i);
        twice.add({p.x, p.y, p.z}, {p.x, p.y, p.z});
    }
    const orient::Orientation result = oriented(twice, runtime);
    EXPECT_EQ(result.report.merged, 50);
    EXPECT_EQ(score(twice, result.normal).right, 1.0);
    for (std::int64_t i = 0; i < 50; ++i) EXPECT_EQ(result.normal[i], result.normal[100 + i]);
}

TEST(Orient, NamesFaultsOfThePoints) {
    const base::Runtime runtime;
    const auto message = [&](const std::vector<double>& points) -> std::string {
        Samples samples;
        samples.points = points;
        try {
            (void)oriented(samples, runtime);
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::invalid_argument);
            return error.what();
        }
        return "no error";
    };
    EXPECT_NE(message({0, 0, 0, 1, 0, 0, 0, 1, 0}).find("points has 3 elements"), std::string::npos);
    EXPECT_NE(message({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0}).find("3 different"), std::string::npos);
    EXPECT_NE(message({0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 5, 5, 5}).find("one line"), std::string::npos);
    EXPECT_NE(message({0, 0, 0, 1, 0, 0, 0, NAN, 0, 0, 0, 1}).find("points[2]"), std::string::npos);
    EXPECT_NE(message({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}).find("at one place"), std::string::npos);
    EXPECT_EQ(message({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0.1}), "no error");
}

} // namespace

} // namespace orient_test
