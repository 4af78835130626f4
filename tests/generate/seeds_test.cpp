// SPDX-License-Identifier: MIT
#include "support/point_sets.h"

namespace hrbfnpr::generate::seeds_test {
namespace {

using namespace marks;
using namespace test;

std::int64_t level0(const PointSet& set) { return set.layers[0].report.level[0].placed; }

TEST(Seeds, BoxHasCubicCellsAndRAlongItsLongestSide) {
    generate::Settings settings = recursion({Kind::stipples}, 0);
    settings.seeds.source = SeedSource::box;
    EXPECT_EQ(make(Sphere(), settings).seeds.attempted, 512) << "8^3, the recursion's R";
    const PointSet torus = make(Torus(1.0, 0.35), settings);
    EXPECT_EQ(torus.seeds.attempted, 8 * 8 * 3) << "0.7 / (2.7 / 8) is 2.07: three layers";
    expect_sound(torus, Torus(1.0, 0.35));
    settings.seeds.box_resolution = 5;
    EXPECT_EQ(make(Sphere(), settings).seeds.attempted, 125);
}

// The centre of the ball is its only critical point, and cells farther from the sphere than their
// diagonal are dropped.
TEST(Seeds, BoxDropsAndCountsSeedsThatStrayOrStick) {
    generate::Settings settings = recursion({Kind::stipples}, 0);
    settings.seeds.source = SeedSource::box;
    settings.seeds.box_jitter = 0.0;
    settings.seeds.box_resolution = 9; // odd, so one cell is in the centre
    const PointSet set = make(Sphere(), settings);
    const double cell = 2.0 / 9.0;
    std::int64_t strayed = 0;
    for (int i = 0; i < 729; ++i) {
        const glm::dvec3 centre = cell * (glm::dvec3(i % 9, i / 9 % 9, i / 81) - 4.0);
        if (i != 364 && std::abs(glm::length(centre) - 1.0) > std::sqrt(3.0) * cell) ++strayed;
    }
    EXPECT_GT(strayed, 50);
    EXPECT_EQ(set.seeds.dropped_strayed, strayed);
    EXPECT_EQ(set.seeds.dropped_degenerate, 1);
    EXPECT_EQ(set.seeds.placed, 728 - strayed);
    EXPECT_EQ(level0(set), set.seeds.placed);
    EXPECT_NEAR(set.layers[0].report.step, std::sqrt(3.0) * cell, 1e-12) << "the voxel diameter";
}

TEST(Seeds, JitterMovesByUpToAlphaCells) {
    generate::Settings settings = recursion({Kind::stipples}, 0);
    settings.seeds.source = SeedSource::box;
    settings.seeds.box_resolution = 16;
    const Plane plane({0.0, 0.0, 1.0}, 0.0, {{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}});
    for (const double jitter : {0.0, 0.25, 0.5}) {
        settings.seeds.box_jitter = jitter;
        const PointSet set = make(plane, settings);
        ASSERT_EQ(level0(set), 256);
        const double side = 2.0 / 16.0;
        double farthest = 0.0;
        for (int i = 0; i < 256; ++i) {
            const glm::dvec3 centre(side * (i % 16 - 7.5), side * (i / 16 - 7.5), 0.0);
            farthest = std::max(farthest, glm::distance(position(set, Kind::stipples, i), centre));
        }
        EXPECT_LE(farthest, jitter * side + 1e-6);
        EXPECT_GE(farthest, 0.85 * jitter * side);
    }
}

// A small surface in a large box: nearly all cells are too far from it.
TEST(Seeds, ASurfaceSmallerThanTheBoxKeepsTheCellsNearIt) {
    generate::Settings settings = recursion({Kind::stipples}, 2);
    settings.seeds.source = SeedSource::box;
    const SquareSphere sphere(0.1, 10.0);
    const PointSet set = make(sphere, settings);
    EXPECT_EQ(set.seeds.attempted, 512);
    EXPECT_GT(set.seeds.placed, 7);
    EXPECT_LT(set.seeds.placed, 80);
    EXPECT_GT(set.seeds.dropped_strayed, 400);
    expect_sound(set, sphere);
}

TEST(Seeds, SamplesAreUsedUnchanged) {
    const std::vector<double> samples = spiral_seeds(300);
    generate::Settings settings = recursion({Kind::stipples}, 0);
    settings.seeds.source = SeedSource::samples;
    const PointSet set = make(Sphere(), settings, {samples, 0.2});
    ASSERT_EQ(level0(set), 300);
    for (int i = 0; i < 300; ++i) {
        const auto [x, y, z] = spiral_point(i, 300);
        EXPECT_NEAR(glm::distance(position(set, Kind::stipples, i), {x, y, z}), 0.0, 1e-7);
    }
}

TEST(Seeds, StepIsTheMeanEmptyBallDiameter) {
    generate::Settings settings = recursion({Kind::stipples}, 0);
    const std::vector<double> seeds = six_seeds();
    use_points(settings, seeds);
    EXPECT_NEAR(make(Sphere(), settings).layers[0].report.step, std::sqrt(2.0), 1e-12);
    settings.seeds.initial_step = 0.3;
    EXPECT_EQ(make(Sphere(), settings).layers[0].report.step, 0.3);
    settings.seeds.initial_step = 0.0;
    const std::vector<double> one = {0.0, 0.0, 2.0};
    use_points(settings, one);
    EXPECT_NEAR(make(Sphere(), settings).layers[0].report.step, 0.1 * std::sqrt(12.0), 1e-12);
    const std::vector<double> same = {0, 0, 2, 0, 0, 2, 1, 0, 0};
    use_points(settings, same);
    EXPECT_NEAR(make(Sphere(), settings).layers[0].report.step, std::sqrt(2.0), 1e-12)
        << "points that coincide do not make the step 0";
}

TEST(Seeds, AutoUsesOnlyWellSpreadSamples) {
    generate::Settings settings = recursion({Kind::stipples}, 0);
    EXPECT_EQ(make(Sphere(), settings).seed_source, SeedSource::box) << "there are none";
    const std::vector<double> even = spiral_seeds(200);
    EXPECT_EQ(make(Sphere(), settings, {even, 0.2}).seed_source, SeedSource::samples);
    // Points as before, but every other point is moved next to its predecessor.
    std::vector<double> pairs = even;
    for (std::size_t i = 3; i + 5 < pairs.size(); i += 9)
        for (std::size_t k = 0; k < 3; ++k) pairs[i + k] = pairs[i + k - 3] + (k == 2 ? 0.0 : 1e-3);
    EXPECT_EQ(make(Sphere(), settings, {pairs, 0.1}).seed_source, SeedSource::box);
    settings.distribution = Distribution::blue_noise;
    of(settings, Kind::stipples).budget = 100;
    EXPECT_EQ(make(Sphere(), settings, {pairs, 0.1}).seed_source, SeedSource::samples)
        << "the blue-noise order asks for a seed on each sheet only";
}

TEST(Seeds, PointsAreProjectedFromAnywhere) {
    generate::Settings settings = recursion({Kind::stipples}, 0);
    const std::vector<double> points = {2, 0, 0, 0, 0.2, 0, 0, 0, -3};
    use_points(settings, points);
    const PointSet set = make(Sphere(), settings);
    ASSERT_EQ(level0(set), 3);
    EXPECT_NEAR(glm::distance(position(set, Kind::stipples, 0), {1, 0, 0}), 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(position(set, Kind::stipples, 1), {0, 1, 0}), 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(position(set, Kind::stipples, 2), {0, 0, -1}), 0.0, 1e-6);
}

TEST(Seeds, NoSeedsIsAnError) {
    const AnyField nothing(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {glm::dot(p, p) + 1.0, 2.0 * p, identity(2.0)};
    });
    for (const Distribution distribution : {Distribution::published, Distribution::blue_noise}) {
        generate::Settings settings = recursion({Kind::stipples}, 1);
        settings.distribution = distribution;
        of(settings, Kind::stipples).budget = 100;
        expect_error(Status::not_converged, {"none of", "seed_points"}, [&] { (void)make(nothing, settings); });
    }
}

TEST(Patches, AreSquaresOfTwoStepsInTangentPlanes) {
    const Sphere sphere;
    generate::Settings settings = recursion({Kind::stipples}, 2);
    const std::vector<double> seeds = spiral_seeds(50);
    use_points(settings, seeds);
    std::vector<double> corners(70 * 12, 0.0);
    const base::OutView out{reinterpret_cast<std::byte*>(corners.data()), 70, 96, base::Scalar::float64, 12};
    const double step = step_patches(runtime(), sphere, {}, settings, out);
    EXPECT_EQ(step, make(sphere, settings).layers[0].report.step);
    std::vector<int> used(50, 0);
    for (std::size_t i = 0; i < 70; ++i) {
        std::array<glm::dvec3, 4> c;
        for (std::size_t k = 0; k < 4; ++k)
            c[k] = {corners[12 * i + 3 * k], corners[12 * i + 3 * k + 1], corners[12 * i + 3 * k + 2]};
        const glm::dvec3 centre = 0.25 * (c[0] + c[1] + c[2] + c[3]);
        EXPECT_NEAR(glm::length(centre), 1.0, 1e-9);
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(glm::distance(c[k], c[(k + 1) % 4]), 2.0 * step, 1e-9);
            EXPECT_NEAR(glm::dot(c[k] - centre, centre), 0.0, 1e-9);
        }
        EXPECT_GT(glm::dot(glm::cross(c[1] - c[0], c[2] - c[1]), centre), 0.0) << "counter-clockwise from outside";
        for (int s = 0; s < 50; ++s) {
            const auto [x, y, z] = spiral_point(s, 50);
            if (glm::distance(centre, {x, y, z}) < 1e-6) ++used[static_cast<std::size_t>(s)];
        }
    }
    for (const int times : used) EXPECT_TRUE(times == 1 || times == 2) << "every seed before one comes twice";

    settings.distribution = Distribution::blue_noise;
    of(settings, Kind::stipples).budget = 100;
    EXPECT_EQ(step_patches(runtime(), sphere, {}, settings, out), step) << "the seeds' whatever the distribution";
    settings.seeds.initial_step = 0.5;
    EXPECT_EQ(step_patches(runtime(), sphere, {}, settings, out), 0.5);
}

} // namespace
} // namespace hrbfnpr::generate::seeds_test
