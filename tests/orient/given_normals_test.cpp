// SPDX-License-Identifier: MIT
// Tests how given normals are told apart and repaired.
#include "shapes.h"

#include <gtest/gtest.h>

namespace given_normals_test {

namespace {

using namespace hrbfnpr;
using namespace orient_test;
using orient::NormalMode;

const Samples& shape() {
    static const Samples samples = test::torus(1200);
    return samples;
}

orient::Orientation with(const std::vector<double>& normals, NormalMode mode = NormalMode::automatic,
                         const Samples& samples = shape()) {
    static const base::Runtime runtime; // must outlive the results
    orient::OrientInput wanted = input(samples);
    wanted.normals = view(normals);
    wanted.mode = mode;
    return orient::orient(runtime, wanted);
}

// Turns the i-th normal around if is_turned(i).
template <class Turned>
std::vector<double> turned(const Samples& samples, const Turned& is_turned) {
    std::vector<double> result = samples.normals;
    for (std::size_t i = 0; i < result.size(); ++i)
        if (is_turned(static_cast<std::int64_t>(i / 3))) result[i] = -result[i];
    return result;
}

void expect_the_truth(const orient::Orientation& result, const Samples& samples = shape()) {
    for (std::int64_t i = 0; i < samples.count(); ++i) ASSERT_EQ(result.normal[i], at(samples.normals, i)) << i;
}

TEST(GivenNormals, CorrectNormalsStayBitForBit) {
    const orient::Orientation result = with(shape().normals);
    EXPECT_EQ(result.report.found, NormalMode::given);
    EXPECT_EQ(result.report.turned, 0);
    EXPECT_EQ(result.report.made, 0);
    expect_the_truth(result);
}

TEST(GivenNormals, InwardNormalsAreTurned) {
    const std::vector<double> inward = turned(shape(), [](std::int64_t) { return true; });
    for (const NormalMode mode : {NormalMode::automatic, NormalMode::inward, NormalMode::unoriented}) {
        const orient::Orientation result = with(inward, mode);
        EXPECT_EQ(result.report.turned, shape().count());
        expect_the_truth(result);
    }
    EXPECT_EQ(with(inward).report.found, NormalMode::inward);
}

TEST(GivenNormals, TurnedPatchesAreTurnedBack) {
    const auto patch = [](std::int64_t i) { return at(shape().points, i).x > 0.9; };
    const std::vector<double> mixed = turned(shape(), patch);
    for (const NormalMode mode : {NormalMode::automatic, NormalMode::mixed}) {
        const orient::Orientation result = with(mixed, mode);
        EXPECT_EQ(result.report.found, NormalMode::mixed);
        EXPECT_GT(result.report.turned, 100);
        EXPECT_LT(result.report.turned, 500);
        expect_the_truth(result);
    }
}

TEST(GivenNormals, KeepTheirDirectionsIfSignsAreRandom) {
    const std::vector<double> tossed =
        turned(shape(), [](std::int64_t i) { return std::fmod(static_cast<double>(i * i) * 0.3819660113, 1.0) < 0.5; });
    const orient::Orientation result = with(tossed);
    EXPECT_EQ(result.report.found, NormalMode::unoriented);
    expect_the_truth(result);
}

// The normals of planes through neighbours, with random signs, are wrong on the rim of a thin disc: there, both of its
// sides are neighbours.
TEST(GivenNormals, PlanesThroughBothSidesAreReplaced) {
    constexpr double thin = 0.12;
    Samples disc = test::sphere(1200);
    for (std::size_t i = 0; i < disc.points.size(); i += 3) {
        disc.points[i + 2] *= thin;
        const glm::dvec3 n =
            glm::normalize(glm::dvec3(disc.normals[i], disc.normals[i + 1], disc.normals[i + 2] / thin));
        for (glm::length_t c = 0; c < 3; ++c) disc.normals[i + static_cast<std::size_t>(c)] = n[c];
    }
    const base::Runtime runtime;
    const orient::Cloud cloud = orient::read_cloud(runtime, view(disc.points));
    const orient::NeighbourLists near(runtime, *cloud.tree, 16);
    const geometry::VecArray plane = orient::plane_normals(runtime, *cloud.tree, near, 12);
    std::vector<double> given;
    for (std::int64_t i = 0; i < disc.count(); ++i) {
        const double sign = std::fmod(static_cast<double>(i * i) * 0.3819660113, 1.0) < 0.5 ? -1.0 : 1.0;
        for (glm::length_t c = 0; c < 3; ++c) given.push_back(sign * plane[cloud.place[i]][c]);
    }
    const auto wrong = [&](const auto& normal) { // the number of directions that are off by over 20 degrees
        std::int64_t count = 0;
        for (std::int64_t i = 0; i < disc.count(); ++i)
            count += std::abs(glm::dot(glm::normalize(normal(i)), at(disc.normals, i))) < std::cos(0.35) ? 1 : 0;
        return count;
    };
    const orient::Orientation result = with(given, NormalMode::automatic, disc);
    EXPECT_EQ(result.report.found, NormalMode::unoriented);
    EXPECT_GT(result.report.made, 0);
    const std::int64_t before = wrong([&](std::int64_t i) { return at(given, i); });
    EXPECT_GT(before, 20);
    EXPECT_LT(2 * wrong([&](std::int64_t i) { return result.normal[i]; }), before);
    // The caller may say that the directions are right.
    EXPECT_EQ(with(given, NormalMode::unoriented, disc).report.made, 0);
}

TEST(GivenNormals, MeaninglessNormalsAreReplaced) {
    std::vector<double> colours;
    for (std::int64_t i = 0; i < 3 * shape().count(); ++i)
        colours.push_back(std::fmod(static_cast<double>(i) * 0.618033988, 1.0));
    std::vector<double> constant;
    for (std::int64_t i = 0; i < shape().count(); ++i) constant.insert(constant.end(), {0.0, 0.0, 1.0});
    for (const std::vector<double>& wrong : {colours, constant}) {
        const orient::Orientation result = with(wrong);
        EXPECT_EQ(result.report.found, NormalMode::none);
        EXPECT_EQ(result.report.made, shape().count());
        EXPECT_GT(result.report.direction_change, 20.0);
        EXPECT_EQ(score(shape(), result.normal).right, 1.0);
    }
}

TEST(GivenNormals, ZeroNormalsAreReplaced) {
    std::vector<double> some = shape().normals;
    std::fill_n(some.begin() + 30, 60, 0.0);
    const orient::Orientation result = with(some);
    EXPECT_EQ(result.report.made, 20);
    EXPECT_EQ(result.report.found, NormalMode::given);
    EXPECT_EQ(score(shape(), result.normal).right, 1.0);
    const orient::Orientation none = with(std::vector<double>(some.size(), 0.0));
    EXPECT_EQ(none.report.made, shape().count());
    EXPECT_EQ(score(shape(), none.normal).right, 1.0);
}

TEST(GivenNormals, DecideTheSideOfOpenSheets) {
    const Samples sheet = terrain(20);
    const std::vector<double> down = turned(sheet, [](std::int64_t) { return true; });
    const orient::Orientation result = with(down, NormalMode::automatic, sheet);
    EXPECT_EQ(result.report.found, NormalMode::given);
    EXPECT_EQ(result.report.turned, 0);
    EXPECT_EQ(result.report.outward_by, orient::OutwardBy::as_given);
    EXPECT_EQ(score(sheet, result.normal).right, 0.0);
}

TEST(GivenNormals, AreOnlyJudgedInModeGiven) {
    const std::vector<double> inward = turned(shape(), [](std::int64_t) { return true; });
    const orient::Orientation result = with(inward, NormalMode::given);
    EXPECT_EQ(result.report.found, NormalMode::inward);
    EXPECT_EQ(result.report.turned, 0);
    for (std::int64_t i = 0; i < shape().count(); ++i) ASSERT_EQ(result.normal[i], at(inward, i));
}

TEST(GivenNormals, PointingInwardIsDetectedOnClosedSurfaces) {
    const base::Runtime runtime;
    const Samples sheet = terrain(20);
    const auto inward = [&](const Samples& samples, bool turn) {
        const std::vector<double> normals = turned(samples, [&](std::int64_t) { return turn; });
        return orient::plainly_inward(runtime, view(samples.points), view(normals));
    };
    EXPECT_TRUE(inward(shape(), true));
    EXPECT_FALSE(inward(shape(), false));
    EXPECT_TRUE(inward(test::bumpy(20000), true));
    EXPECT_FALSE(inward(test::bumpy(20000), false));
    EXPECT_FALSE(inward(sheet, true));
    EXPECT_FALSE(inward(sheet, false));
}

// A wall beside a ball. The wall is two deviations of its noise thick, so positions do not tell its sides apart.
Samples wall_and_ball() {
    Samples samples = noisy(sheets(10, 1.5), 0.75);
    const Samples ball = test::sphere(200);
    for (std::int64_t i = 0; i < ball.count(); ++i) {
        const glm::dvec3 p = at(ball.points, i);
        const glm::dvec3 n = at(ball.normals, i);
        samples.add({30.0 + 6.0 * p.x, 6.0 * p.y, 6.0 * p.z}, {n.x, n.y, n.z});
    }
    return samples;
}

TEST(GivenNormals, HelpWhereNewNormalsWouldBeDoubtful) {
    const Samples both = wall_and_ball();
    const std::vector<double> none(both.normals.size(), 0.0);
    const orient::Orientation made = with(none, NormalMode::none, both);
    ASSERT_LT(made.report.confidence, 0.5);
    ASSERT_LT(score(both, made.normal).right, 0.95);
    const auto wrong = [&](const std::vector<double>& normals) {
        return 1.0 - score(both, with(normals, NormalMode::automatic, both).normal).right;
    };
    EXPECT_LE(wrong(both.normals), 0.01);
    EXPECT_LE(wrong(turned(both, [](std::int64_t) { return true; })), 0.01);
    EXPECT_LE(wrong(turned(both, [&](std::int64_t i) { return at(both.points, i).x > 33.0; })), 0.01);
}

// Normals of random signs do not describe a wall.
TEST(GivenNormals, RandomSignsAreDetectedDespiteNoise) {
    const Samples wall = noisy(sheets(10, 1.5), 0.75);
    const std::vector<double> tossed =
        turned(wall, [](std::int64_t i) { return std::fmod(static_cast<double>(i * i) * 0.3819660113, 1.0) < 0.5; });
    EXPECT_EQ(with(tossed, NormalMode::automatic, wall).report.found, NormalMode::unoriented);
}

} // namespace

} // namespace given_normals_test
