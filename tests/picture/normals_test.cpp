// SPDX-License-Identifier: MIT
#include "picture/normals.h"

#include "picture/statistics.h"
#include "support/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace picture_test::normals_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

class Normals : public testing::Test {
protected:
    base::Memory memory;
    Pool pool{memory};

    // Returns points of the unit sphere, which are also its normals.
    Points sphere(std::int64_t count) {
        Points points(&pool);
        for (std::int64_t i = 0; i < count; ++i) {
            const auto p = test::spiral_point(i, count);
            points.emplace_back(p[0], p[1], p[2]);
        }
        return points;
    }
    template <class Turned>
    static Points turned_where(Points normals, Turned&& turned) {
        for (std::size_t i = 0; i < normals.size(); ++i)
            if (turned(i)) normals[i] = -normals[i];
        return normals;
    }
    NormalsLook look(const Points& points, const Points& normals, bool even = false) {
        return look_at_normals(points, normals, even, pool);
    }
};

// The same rules in Python computed the expected numbers.
TEST_F(Normals, LookOutwardOnABall) {
    const Points ball = sphere(250);
    const NormalsLook outward = look(ball, ball);
    EXPECT_NEAR(outward.closed, 1.0234579554273797, 1e-12);
    EXPECT_EQ(outward.against, 0.0);
    EXPECT_EQ(outward.flipped, 0.0);
    EXPECT_EQ(outward.outside_in, 0.0);
    EXPECT_FALSE(outward.inward() || outward.mixed());
    EXPECT_EQ(normals_in_words(outward, pool), "normals point outward");
    EXPECT_NEAR(look(ball, ball, true).closed, 0.9561150766565927, 1e-12);
    const NormalsLook inward = look(ball, turned_where(ball, [](std::size_t) { return true; }));
    EXPECT_NEAR(inward.closed, -1.0234579554273797, 1e-12);
    EXPECT_TRUE(inward.inward());
    EXPECT_FALSE(inward.mixed());
}

TEST_F(Normals, AreMixedIfSomeAreTurned) {
    const Points ball = sphere(250);
    const NormalsLook some = look(ball, turned_where(ball, [](std::size_t i) { return i % 4 == 0; }));
    EXPECT_NEAR(some.closed, 0.5053796432748427, 1e-12);
    EXPECT_NEAR(some.against, 0.008, 1e-12);
    EXPECT_NEAR(some.flipped, 0.2550510257216822, 1e-12); // A quarter of the normals is turned.
    EXPECT_TRUE(some.mixed());
    EXPECT_EQ(normals_in_words(some, pool), "some normals point outward, others inward");
    const NormalsLook patch = look(ball, turned_where(ball, [&](std::size_t i) { return ball[i].x > 0.3; }));
    EXPECT_NEAR(patch.closed, 0.3763303343231941, 1e-12);
    EXPECT_NEAR(patch.flipped, 0.043929829960344835, 1e-12);
    EXPECT_FALSE(patch.mixed()); // This is a known gap: hrbfnpr_orient would see the patch.
}

TEST_F(Normals, AreJudgedByAFewOfManySamples) {
    const Points ball = sphere(20'000);
    const NormalsLook outward = look(ball, ball);
    EXPECT_NEAR(outward.closed, 1.0, 0.05);
    EXPECT_FALSE(outward.mixed());
    EXPECT_NEAR(look(ball, turned_where(ball, [](std::size_t i) { return i % 10 == 0; })).flipped, 0.1, 0.02);
}

TEST_F(Normals, TellNothingAboutTooFewPoints) {
    const auto expect_nothing = [&](const Points& points) {
        const NormalsLook found = look(points, points);
        EXPECT_EQ(found.closed, 0.0);
        EXPECT_FALSE(found.inward() || found.mixed());
    };
    expect_nothing(Points(&pool));
    expect_nothing(sphere(1));
    expect_nothing(sphere(5));
    expect_nothing(Points(20, glm::dvec3(0.0, 0.0, 1.0), &pool)); // All points are at one place.
    Points pairs = sphere(20); // Ten points share each place, so no spacing is known.
    for (std::size_t i = 0; i < 20; ++i) pairs[i] = pairs[i % 2];
    EXPECT_FALSE(look(pairs, pairs).inward());
}

TEST_F(Normals, TellLessOnOpenSurfaces) {
    const Points ball = sphere(250);
    Points cap(&pool);
    for (const glm::dvec3& p : ball)
        if (p.z > 0.5) cap.push_back(p);
    EXPECT_NEAR(look(cap, cap).closed, 0.51225215951168, 1e-12);
    Points sheet(&pool);
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) sheet.emplace_back(i + 0.1 * std::sin(7.0 * j), j, 0.0);
    const Points up(sheet.size(), glm::dvec3(0.0, 0.0, 1.0), &pool);
    const NormalsLook flat = look(sheet, up);
    EXPECT_NEAR(flat.closed, 0.0, 0.1);
    EXPECT_EQ(normals_in_words(flat, pool), "open surface, normals kept");
}

// ---- Samples at one place

TEST_F(Normals, AreAveragedAtSharedPlaces) {
    const double s = std::sqrt(0.5);
    Points points({{1, 0, 0}, {0, 0, 0}, {2, 0, 0}, {0, 0, 0}, {-0.0, 0, 0}, {2, 0, 0}, {3, 0, 0}}, &pool);
    Points normals({{0, 0, 1}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 0}, {0, 0, -1}, {1, 0, 0}}, &pool);
    const SharedPlaces places = merge_shared_places(points, normals, pool);
    EXPECT_EQ(places.joined, 1);
    EXPECT_EQ(places.left_out, 1);
    EXPECT_EQ(points, Points({{1, 0, 0}, {0, 0, 0}, {3, 0, 0}}, &pool));
    ASSERT_EQ(normals.size(), 3U);
    EXPECT_NEAR(normals[1].x, std::sqrt(0.2), 1e-15); // This is the mean of one normal along x and two along y.
    EXPECT_NEAR(normals[1].y, std::sqrt(0.8), 1e-15);

    Points same({{1, 0, 0}, {1, 0, 0}, {0, 0, 0}}, &pool); // Equal normals both stay.
    Points equal({{s, s, 0}, {s, s, 0}, {0, 0, 1}}, &pool);
    EXPECT_EQ(merge_shared_places(same, equal, pool).joined, 0);
    EXPECT_EQ(same.size(), 3U);
    Points none(&pool);
    EXPECT_EQ(merge_shared_places(none, none, pool).left_out, 0);
}

// ---- Points along curves

// Returns circles around the tube of a torus of radii 3 and 1.
Points rings(int count, int each, Pool& pool) {
    Points points(&pool);
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < each; ++j) {
            const double a = 2.0 * std::numbers::pi * i / count;
            const double b = 2.0 * std::numbers::pi * (j + 0.5) / each;
            const double r = 3.0 + std::cos(b);
            points.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
        }
    return points;
}

TEST_F(Normals, PointsLieAlongCurves) {
    EXPECT_TRUE(lie_along_curves(rings(9, 40, pool), pool));
    EXPECT_FALSE(lie_along_curves(rings(60, 18, pool), pool));
    EXPECT_FALSE(lie_along_curves(sphere(2000), pool));
    EXPECT_FALSE(lie_along_curves(rings(9, 3000, pool), pool)) << "too many are not asked";
    Points few = rings(9, 40, pool);
    few.resize(10);
    EXPECT_FALSE(lie_along_curves(few, pool));
    EXPECT_FALSE(lie_along_curves(Points(&pool), pool));
}

// ---- Numbers

TEST_F(Normals, RandomSubsetsAreEvenAndTheSameEachTime) {
    const auto chosen = random_subset(100'000, 1000, 5, 1, pool);
    ASSERT_EQ(chosen.size(), 1000U);
    EXPECT_TRUE(std::is_sorted(chosen.begin(), chosen.end()));
    EXPECT_EQ(std::adjacent_find(chosen.begin(), chosen.end()), chosen.end());
    EXPECT_GE(chosen.front(), 0);
    EXPECT_LT(chosen.back(), 100'000);
    const auto low = std::lower_bound(chosen.begin(), chosen.end(), 50'000) - chosen.begin();
    EXPECT_NEAR(static_cast<double>(low), 500.0, 80.0); // The tolerance is five standard deviations.
    EXPECT_EQ(chosen, random_subset(100'000, 1000, 5, 1, pool));
    EXPECT_NE(chosen, random_subset(100'000, 1000, 6, 1, pool));
    EXPECT_NE(chosen, random_subset(100'000, 1000, 5, 2, pool));
    EXPECT_EQ(random_subset(3, 7, 1, 1, pool), (Vector<std::int64_t>({0, 1, 2}, &pool)));
    EXPECT_TRUE(random_subset(0, 7, 1, 1, pool).empty());
    EXPECT_TRUE(random_subset(7, 0, 1, 1, pool).empty());
}

TEST_F(Normals, MediansAreCorrectAndKeepNaN) {
    const auto median = [&](std::initializer_list<double> numbers) {
        Vector<double> copy(numbers, &pool);
        return median_of(copy);
    };
    EXPECT_EQ(median({3.0, 1.0, 2.0}), 2.0);
    EXPECT_EQ(median({4.0, 1.0, 9.0, 2.0}), 3.0);
    EXPECT_EQ(median({7.0}), 7.0);
    EXPECT_TRUE(std::isnan(median({})));
    EXPECT_TRUE(std::isnan(median({1.0, std::numeric_limits<double>::quiet_NaN(), 2.0})));
}

} // namespace
} // namespace picture_test::normals_test
