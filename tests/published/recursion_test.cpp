// SPDX-License-Identifier: MIT
// Tests the published recursion: the counts of Table 1, the places of children, and budgets.
#include "support/point_sets.h"

#include "geometry/tangent_frame.h"

#include <algorithm>
#include <set>

namespace hrbfnpr::published::recursion_test {
namespace {

using namespace generate;
using namespace marks;
using namespace test;

TEST(PublishedCounts, MatchTable1OfTheArticle) {
    const Sphere sphere;
    const std::vector<double> seeds512 = spiral_seeds(512);
    const std::vector<double> seeds4096 = spiral_seeds(4096);
    generate::Settings settings = recursion({Kind::stipples}, 3);
    use_points(settings, seeds512);
    EXPECT_EQ(of(make(sphere, settings), Kind::stipples).count(), 64000);
    use_points(settings, seeds4096);
    EXPECT_EQ(of(make(sphere, settings), Kind::stipples).count(), 512000);

    settings = recursion({combing}, 4);
    use_points(settings, seeds512);
    const PointSet hatched = make(sphere, settings);
    EXPECT_EQ(of(hatched, combing).count(), 82944);
    EXPECT_EQ(of(hatched, combing).strokes(), 1024);
    EXPECT_EQ(of(hatched, combing).report.full_count, 82944);
    settings = recursion({principal}, 3);
    use_points(settings, seeds4096);
    EXPECT_EQ(of(make(sphere, settings), principal).count(), 221184);
}

// Hatching that starts from stipples has 6 * 5^2 stipples, and two strokes of 3^3 marks at each.
TEST(PublishedCounts, StrokesMayStartFromStipples) {
    const Sphere sphere;
    generate::Settings settings = recursion({combing}, 3);
    const std::vector<double> seeds = six_seeds();
    use_points(settings, seeds);
    of(settings, combing).published.from_stipples = true;
    of(settings, combing).published.start_level = 2;
    const PointSet only_strokes = make(sphere, settings);
    EXPECT_EQ(of(only_strokes, combing).count(), 150 * 2 * 27);
    EXPECT_EQ(of(only_strokes, combing).report.full_count, 150 * 2 * 27);
    EXPECT_EQ(of(only_strokes, Kind::stipples).count(), 0) << "they were not asked for";
    of(settings, Kind::stipples).budget = 0;
    of(settings, Kind::stipples).published.levels = 4;
    const PointSet both = make(sphere, settings);
    EXPECT_EQ(of(both, Kind::stipples).count(), 3750);
    EXPECT_TRUE(same_bits(of(both, combing).direction, of(only_strokes, combing).direction));
}

// On a plane projection moves nothing: every child is at (i r + j u) rho from its parent.
TEST(PublishedStipples, ChildrenStandAtTheJitteredCorners) {
    const Plane plane({0.0, 0.0, 1.0}, 0.0, cube(1.0));
    generate::Settings settings = recursion({Kind::stipples}, 2);
    const std::vector<double> seeds = {0.1, 0.2, 0.0};
    use_points(settings, seeds);
    settings.seeds.initial_step = 0.3;
    std::set<double> different;
    for (std::uint64_t random = 0; random < 50; ++random) {
        settings.random_seed = random;
        const PointSet set = make(plane, settings);
        ASSERT_EQ(of(set, Kind::stipples).count(), 25);
        const geometry::TangentFrame frame = geometry::stipple_frame({0.0, 0.0, 1.0});
        std::set<std::pair<int, int>> corners;
        for (std::int64_t i = 1; i < 5; ++i) {
            const glm::dvec3 offset = (position(set, Kind::stipples, i) - glm::dvec3(0.1, 0.2, 0.0)) / 0.3;
            const double along_r = glm::dot(offset, frame.r);
            const double along_u = glm::dot(offset, frame.u);
            EXPECT_NEAR(std::abs(along_r), 1.0, 0.1251);
            EXPECT_NEAR(std::abs(along_u), 1.0, 0.1251);
            corners.insert({along_r > 0.0 ? 1 : -1, along_u > 0.0 ? 1 : -1});
            different.insert(std::abs(along_r));
            different.insert(std::abs(along_u));
        }
        EXPECT_EQ(corners.size(), 4U);
        // The second level is a third as wide. Its marks are around each of the first five.
        for (std::int64_t i = 5; i < 25; ++i) {
            const glm::dvec3 parent = position(set, Kind::stipples, (i - 5) / 4);
            const glm::dvec3 offset = (position(set, Kind::stipples, i) - parent) / 0.1;
            EXPECT_NEAR(std::abs(glm::dot(offset, frame.r)), 1.0, 0.1251);
            EXPECT_EQ(of(set, Kind::stipples).level[i], 2);
        }
    }
    EXPECT_GT(different.size(), 350U) << "i and j are drawn for each child";
    EXPECT_LT(*different.begin(), 0.885) << "the whole of [-1/8, 1/8] is used";
    EXPECT_GT(*different.rbegin(), 1.115);
}

TEST(PublishedRanks, AreUniformAndIndependentOfOtherLayers) {
    const Sphere sphere;
    generate::Settings settings = recursion({Kind::stipples}, 4);
    const std::vector<double> seeds = spiral_seeds(40);
    use_points(settings, seeds);
    const PointSet set = make(sphere, settings);
    const Layer& marks = of(set, Kind::stipples);
    std::array<int, 10> histogram{};
    for (const float u : marks.rank) ++histogram[static_cast<std::size_t>(10.0F * u)];
    const double expected = static_cast<double>(marks.count()) / 10.0;
    for (const int count : histogram) EXPECT_NEAR(count, expected, 5.0 * std::sqrt(expected));
    of(settings, combing).budget = 0;
    of(settings, combing).published.levels = 2;
    EXPECT_TRUE(same_bits(of(make(sphere, settings), Kind::stipples).rank, marks.rank));
    settings.random_seed = 2;
    EXPECT_FALSE(same_bits(of(make(sphere, settings), Kind::stipples).rank, marks.rank));
}

TEST(PublishedBudget, ThinsTheLevelThatExceedsItAndStops) {
    const Sphere sphere;
    const std::vector<double> seeds = spiral_seeds(40);
    for (const Which& kind : {Which(Kind::stipples), principal, combing}) {
        generate::Settings settings = recursion({kind}, 4);
        use_points(settings, seeds);
        LayerSettings& limited = of(settings, kind);
        const bool stipple = kind.kind == Kind::stipples;
        limited.budget = stipple ? 700 : 500; // stipples: 40, 200, [1000]; hatching: 80, 240, [720]
        const PointSet set = make(sphere, settings);
        const LayerReport& report = of(set, kind).report;
        EXPECT_EQ(of(set, kind).count(), limited.budget);
        EXPECT_EQ(report.levels, 2);
        EXPECT_EQ(report.level[1].dropped_budget, 0);
        EXPECT_EQ(report.level[2].attempted, stipple ? 800 : 480);
        EXPECT_EQ(report.level[2].dropped_budget, stipple ? 300 : 220);
        EXPECT_EQ(report.level.size(), 3) << "no level beyond it";
        EXPECT_EQ(report.full_count, stipple ? 40 * 625 : 80 * 81);
        expect_sound(set, sphere);
        // The marks that are kept are random, so all seeds keep some.
        std::set<std::uint32_t> strokes;
        for (std::int64_t i = 0; i < of(set, kind).count(); ++i)
            if (of(set, kind).level[i] == 2) strokes.insert(of(set, kind).stroke[2 * i]);
        EXPECT_GE(strokes.size(), stipple ? 40U : 65U);
        if (!stipple) {
            for (std::int64_t i = 0; i < of(set, kind).count(); ++i)
                EXPECT_LT(of(set, kind).stroke[2 * i + 1], 9U) << "places are numbered for the levels taken";
        }
        limited.budget = 10; // fewer than the number of seeds
        const PointSet few = make(sphere, settings);
        EXPECT_EQ(of(few, kind).count(), 10);
        EXPECT_EQ(of(few, kind).report.levels, 0);
    }
}

// The step is far too long. Children in the tangent plane land anywhere on the small sphere or miss it. Each dropped
// child is counted, and has no children itself.
TEST(PublishedDrops, AreCountedAndHaveNoChildren) {
    // Inside the unit ball f has no zero for x > 0.
    const AnyField half(cube(1.0), [](const glm::dvec3& p) -> Field {
        if (p.x > 0.0) return {std::nan(""), glm::dvec3(0.0), {}};
        return Sphere().at(p);
    });
    generate::Settings settings = recursion({Kind::stipples}, 3);
    const std::vector<double> seeds = {-1, 0, 0, -0.6, 0.8, 0, -0.6, 0, 0.8};
    use_points(settings, seeds);
    settings.seeds.initial_step = 0.8;
    const PointSet set = make(half, settings);
    const LayerReport& report = of(set, Kind::stipples).report;
    EXPECT_EQ(report.full_count, 3 * 125);
    std::int64_t placed = 3;
    std::int64_t degenerate = 0;
    for (std::int32_t level = 1; level <= 3; ++level) {
        EXPECT_EQ(report.level[level].attempted, 4 * placed);
        placed += report.level[level].placed;
        degenerate += report.level[level].dropped_degenerate;
    }
    EXPECT_GT(degenerate, 3);
    EXPECT_EQ(of(set, Kind::stipples).count(), placed);
    EXPECT_LT(placed, 3 * 125);
}

// Two parallel sheets, of which the first one ends. Children that jump to the other sheet are dropped as strayed.
TEST(PublishedDrops, StrayedMarksAreDropped) {
    // A surface that ends: for |x| < 1 f is that of a plane, and beyond that of a distant plane.
    const AnyField step(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {p.z - (std::abs(p.x) < 1.0 ? 0.0 : 5.0), {0.0, 0.0, 1.0}, {}};
    });
    generate::Settings settings = recursion({Kind::stipples, combing}, 1);
    const std::vector<double> seeds = {0.9, 0, 0};
    use_points(settings, seeds);
    settings.seeds.initial_step = 0.3;
    const PointSet set = make(step, settings);
    EXPECT_EQ(of(set, Kind::stipples).report.level[1].dropped_strayed + of(set, Kind::stipples).report.level[1].placed,
              4);
    EXPECT_GT(of(set, Kind::stipples).report.level[1].dropped_strayed, 0);
    EXPECT_EQ(of(set, combing).report.level[1].dropped_strayed, 1);
    EXPECT_EQ(of(set, combing).count(), 2 + 3);
}

TEST(PublishedCurvature, IsFilledIfRequested) {
    const Torus torus;
    generate::Settings settings = recursion({Kind::stipples, principal, combing}, 1);
    PointSet set = make(torus, settings);
    EXPECT_TRUE(of(set, Kind::stipples).curvature.empty());
    EXPECT_TRUE(of(set, combing).curvature.empty());
    EXPECT_EQ(of(set, principal).curvature.size(), 3 * of(set, principal).count());
    of(settings, Kind::stipples).with_curvature = of(settings, combing).with_curvature = true;
    set = make(torus, settings);
    for (const Which& kind : {Which(Kind::stipples), principal, combing}) {
        const Layer& marks = of(set, kind);
        ASSERT_EQ(marks.curvature.size(), 3 * marks.count());
        for (std::int64_t i = 0; i < marks.count(); ++i) {
            const glm::dvec3 p = position(set, kind, i);
            const double rho = std::hypot(p.x, p.y);
            const glm::dvec3 k = vec(marks.curvature, i);
            EXPECT_NEAR(k.y, -1.0 / 0.35, 1e-4);
            EXPECT_NEAR(k.x, -(rho - 1.0) / 0.35 / rho, 1e-4);
            EXPECT_NEAR(k.z, (k.x - k.y) / (std::abs(k.x) + std::abs(k.y) + 1e-3 / torus.diagonal()), 1e-4);
        }
    }
}

} // namespace
} // namespace hrbfnpr::published::recursion_test
