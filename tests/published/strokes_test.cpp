// SPDX-License-Identifier: MIT
// Tests strokes: order and spacing along them, directions, osculating circles.
#include "support/point_sets.h"

#include "geometry/tangent_frame.h"

#include <algorithm>
#include <map>

namespace hrbfnpr::published::strokes_test {
namespace {

using namespace marks;
using namespace test;

// Returns the marks of every stroke, in the order of their places.
std::map<std::uint32_t, std::vector<std::int64_t>> strokes_of(const Layer& marks) {
    std::map<std::uint32_t, std::vector<std::int64_t>> strokes;
    for (std::int64_t i = 0; i < marks.count(); ++i) strokes[marks.stroke[2 * i]].push_back(i);
    for (auto& [stroke, members] : strokes)
        std::sort(members.begin(), members.end(),
                  [&](std::int64_t a, std::int64_t b) { return marks.stroke[2 * a + 1] < marks.stroke[2 * b + 1]; });
    return strokes;
}

TEST(Strokes, AreEvenRowsWithTheSeedInTheMiddle) {
    const Plane plane({0.0, 0.0, 1.0}, 0.0, cube(1.0));
    generate::Settings settings = recursion({combing}, 3);
    const std::vector<double> seeds = {0.1, 0.2, 0.0, -0.5, 0.3, 0.0};
    use_points(settings, seeds);
    settings.seeds.initial_step = 0.27;
    const PointSet set = make(plane, settings);
    const Layer& marks = of(set, combing);
    const auto strokes = strokes_of(marks);
    ASSERT_EQ(strokes.size(), 4U) << "two seeds, two sets";
    const geometry::TangentFrame frame = geometry::combing_frame({0.0, 0.0, 1.0});
    for (const auto& [stroke, members] : strokes) {
        ASSERT_EQ(members.size(), 27U);
        const std::size_t seed = 3 * (stroke / 2);
        const glm::dvec3 middle(seeds[seed], seeds[seed + 1], 0.0);
        const glm::dvec3 along = stroke % 2 == 0 ? frame.r : frame.u;
        for (std::size_t place = 0; place < 27; ++place) {
            const std::int64_t i = members[place];
            EXPECT_EQ(marks.stroke[2 * i + 1], place);
            // {-1, 0, 1} rho + {-1/3, 0, 1/3} rho + {-1/9, 0, 1/9} rho: an even grid of spacing rho / 9.
            const glm::dvec3 expected = middle + (static_cast<double>(place) - 13.0) * 0.03 * along;
            EXPECT_NEAR(glm::distance(position(set, combing, i), expected), 0.0, 1e-6);
            const int level = place == 13 ? 0 : (place + 5) % 9 == 0 ? 1 : (place + 2) % 3 == 0 ? 2 : 3;
            EXPECT_EQ(marks.level[i], level) << place;
        }
    }
}

void expect_even_strokes(const PointSet& set, const Which& kind, double spacing, double tolerance) {
    const Layer& marks = of(set, kind);
    for (const auto& [stroke, members] : strokes_of(marks)) {
        for (std::size_t place = 1; place < members.size(); ++place) {
            const glm::dvec3 step = position(set, kind, members[place]) - position(set, kind, members[place - 1]);
            ASSERT_NEAR(glm::length(step), spacing, tolerance * spacing) << stroke << " " << place;
            // Directions run along the stroke, from place 0 onward.
            ASSERT_GT(glm::dot(step, vec(marks.direction, members[place])), (1.0 - tolerance) * 0.9 * spacing);
            ASSERT_GT(glm::dot(step, vec(marks.direction, members[place - 1])), (1.0 - tolerance) * 0.9 * spacing);
        }
    }
}

TEST(Strokes, OrderAndSpacingHoldOnCurvedSurfaces) {
    const Torus torus;
    generate::Settings settings = recursion({principal}, 3);
    settings.seeds.initial_step = 0.09;
    const PointSet lines = make(torus, settings);
    expect_sound(lines, torus);
    expect_even_strokes(lines, principal, 0.01, 0.12);
}

// A meridian is a geodesic and stays in its half plane at any step. A parallel is not: the osculating circle of the
// normal section leaves it by rho^2 / 2 times its geodesic curvature, sin v / (R + r cos v).
TEST(Strokes, CurvatureLinesOfATorusAreItsMeridiansAndParallels) {
    const Torus torus(1.0, 0.35);
    generate::Settings settings = recursion({principal}, 3);
    for (const double step : {0.06, 0.3}) {
        settings.seeds.initial_step = step;
        const PointSet set = make(torus, settings);
        double longest = 0.0;
        double off_meridian = 0.0;
        double off_parallel = 0.0;
        for (const auto& [stroke, members] : strokes_of(of(set, principal))) {
            const glm::dvec3 seed = position(set, principal, members[13]);
            for (const std::int64_t i : members) {
                const glm::dvec3 p = position(set, principal, i);
                longest = std::max(longest, glm::distance(p, seed));
                if (stroke % 2 == 0)
                    off_parallel = std::max(off_parallel, std::abs(std::hypot(p.x, p.y) - std::hypot(seed.x, seed.y)));
                else
                    off_meridian = std::max(off_meridian, std::abs(p.x * seed.y - p.y * seed.x));
            }
        }
        EXPECT_LT(off_meridian, 1e-6);
        EXPECT_LT(off_parallel, 1.2 * 0.5 * step * step / std::sqrt(1.0 - 0.35 * 0.35));
        EXPECT_GT(longest, 1.3 * step);
    }
}

// On a cylinder the osculating circle around the axis is on the surface itself. So projection does not move the marks,
// and their arc lengths are exact.
TEST(Strokes, StepsOnTheOsculatingCircleHaveTheStepsArcLength) {
    const Cylinder cylinder(0.5, 2.0);
    generate::Settings settings = recursion({principal}, 2);
    const std::vector<double> seeds = {0.5, 0, 0};
    use_points(settings, seeds);
    settings.seeds.initial_step = 0.6; // an angle of 1.2
    const PointSet set = make(cylinder, settings);
    const auto strokes = strokes_of(of(set, principal));
    const auto& around = strokes.at(1); // k2 = -2, around the axis
    ASSERT_EQ(around.size(), 9U);
    const double turn = vec(of(set, principal).direction, around[4]).y > 0.0 ? 1.0 : -1.0;
    for (std::size_t place = 0; place < 9; ++place) {
        const glm::dvec3 p = position(set, principal, around[place]);
        const double angle = turn * (static_cast<double>(place) - 4.0) * 0.2 / 0.5;
        EXPECT_NEAR(glm::distance(p, {0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.0}), 0.0, 1e-6) << place;
    }
    for (const std::int64_t i : strokes.at(0)) // k1 = 0, along the axis
        EXPECT_NEAR(std::hypot(position(set, principal, i).x - 0.5, position(set, principal, i).y), 0.0, 1e-6);
    // The projection only had to confirm the places: one evaluation for each seed and one for each child.
    EXPECT_EQ(of(set, principal).report.level[1].placed, 4);
}

TEST(Strokes, StepsLongerThanAQuarterCircleEndThere) {
    const Cylinder cylinder(0.1, 2.0);
    generate::Settings settings = recursion({principal}, 1);
    const std::vector<double> seeds = {0.1, 0, 0};
    use_points(settings, seeds);
    settings.seeds.initial_step = 0.5; // five radians
    const PointSet set = make(cylinder, settings);
    const auto strokes = strokes_of(of(set, principal));
    ASSERT_EQ(strokes.at(1).size(), 3U);
    EXPECT_NEAR(std::abs(position(set, principal, strokes.at(1)[0]).y), 0.1, 1e-6);
    EXPECT_NEAR(position(set, principal, strokes.at(1)[0]).x, 0.0, 1e-6);
}

// A sphere is umbilic, so a stroke continues in its own direction and is a great circle, although the fallback field
// turns and jumps.
TEST(Strokes, KeepTheirDirectionAtUmbilics) {
    const Sphere sphere;
    generate::Settings settings = recursion({principal}, 4);
    const std::vector<double> seeds = spiral_seeds(60);
    use_points(settings, seeds);
    settings.seeds.initial_step = 0.5;
    const PointSet set = make(sphere, settings);
    for (const auto& [stroke, members] : strokes_of(of(set, principal))) {
        ASSERT_EQ(members.size(), 81U);
        const glm::dvec3 middle = position(set, principal, members[40]);
        const glm::dvec3 pole = glm::cross(middle, vec(of(set, principal).direction, members[40]));
        for (const std::int64_t i : members) EXPECT_NEAR(glm::dot(position(set, principal, i), pole), 0.0, 1e-5);
    }
}

// Published strokes keep the places where they grew. Their step is not a distance between neighbours, so frames do not
// use it as a gap.
TEST(Strokes, StoreNoGapToTheirNeighbours) {
    generate::Settings settings = recursion({principal}, 2);
    settings.seeds.initial_step = 0.05;
    EXPECT_TRUE(of(make(Torus(), settings), principal).clusters.gap.empty());
    EXPECT_FALSE(of(make(Torus(), blue({Kind::hatch}, 3000)), Kind::hatch).clusters.gap.empty());
}

TEST(Strokes, CombingFollowsStarksField) {
    const Sphere sphere;
    generate::Settings settings = recursion({combing}, 2);
    settings.seeds.initial_step = 0.05;
    const PointSet set = make(sphere, settings);
    const Layer& marks = of(set, combing);
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        const geometry::TangentFrame frame = geometry::combing_frame(vec(marks.normal, i));
        const glm::dvec3 field = marks.stroke[2 * i] % 2 == 0 ? frame.r : frame.u;
        EXPECT_NEAR(std::abs(glm::dot(field, vec(marks.direction, i))), 1.0, 1e-4);
    }
}

} // namespace
} // namespace hrbfnpr::published::strokes_test
