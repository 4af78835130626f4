// SPDX-License-Identifier: MIT
// Tests blue noise: evenness of every prefix, coverage, thin and open sheets.
#include "support/point_sets.h"

#include "geometry/point_tree.h"
#include "stipples/candidates.h"

#include <algorithm>

namespace hrbfnpr::stipples::blue_noise_test {
namespace {

using namespace marks;
using namespace test;

// Distances to nearest neighbours over that of the densest packing of the same number of marks on the area, sqrt(2 /
// sqrt(3) area / n). A hexagonal grid has 1 and 1, independent marks about 0 and 0.465.
struct Evenness {
    double smallest;
    double mean;
};

Evenness evenness(const PointSet& set, double share, double area) {
    const Layer& marks = of(set, Kind::stipples);
    const auto count = static_cast<std::int64_t>(share * static_cast<double>(marks.count()));
    geometry::VecArray points(runtime().memory);
    for (std::int64_t i = 0; i < count; ++i) points.push_back(vec(marks.position, i));
    const geometry::PointTree tree(points, {});
    double smallest = 1e300;
    double sum = 0.0;
    for (std::int64_t at = 0; at < count; ++at) {
        smallest = std::min(smallest, tree.nearest_other(at));
        sum += tree.nearest_other(at);
    }
    const auto n = static_cast<double>(count);
    const double densest = std::sqrt(2.0 / std::sqrt(3.0) * area / n);
    return {smallest / densest, sum / n / densest};
}

constexpr double sphere_area = 4.0 * 3.14159265358979323846;

TEST(BlueNoise, EveryPrefixIsEven) {
    const Sphere sphere;
    const Torus torus;
    const PointSet on_sphere = make(sphere, blue({Kind::stipples}, 8000));
    const PointSet on_torus = make(torus, blue({Kind::stipples}, 8000));
    EXPECT_EQ(of(on_sphere, Kind::stipples).count(), 8000);
    expect_sound(on_sphere, sphere);
    expect_sound(on_torus, torus);
    for (const double share : {0.02, 0.1, 0.3, 0.5, 1.0}) {
        const Evenness s = evenness(on_sphere, share, sphere_area);
        EXPECT_GT(s.smallest, 0.6) << share;
        EXPECT_GT(s.mean, 0.74) << share;
        const Evenness t = evenness(on_torus, share, torus.area());
        EXPECT_GT(t.smallest, 0.6) << share;
        EXPECT_GT(t.mean, 0.74) << share;
    }
}

TEST(BlueNoise, TheEvennessMeasureRejectsThePublishedRecursion) {
    const Sphere sphere;
    generate::Settings settings = recursion({Kind::stipples}, 3);
    const std::vector<double> seeds = spiral_seeds(64);
    use_points(settings, seeds);
    const Evenness e = evenness(make(sphere, settings), 1.0, sphere_area);
    EXPECT_LT(e.smallest, 0.4);
    EXPECT_LT(e.mean, 0.72);
}

// Each eighth of the sphere, and the outer and inner half of a torus, get marks in proportion to their area.
TEST(BlueNoise, IsUniformByArea) {
    const PointSet sphere = make(SquareSphere(), blue({Kind::stipples}, 8000));
    std::array<int, 8> octants{};
    for (std::int64_t i = 0; i < 8000; ++i) {
        const glm::dvec3 p = position(sphere, Kind::stipples, i);
        ++octants[(p.x > 0.0 ? 1U : 0U) + (p.y > 0.0 ? 2U : 0U) + (p.z > 0.0 ? 4U : 0U)];
    }
    for (const int count : octants) EXPECT_NEAR(count, 1000, 40);
    const PointSet torus = make(Torus(), blue({Kind::stipples}, 8000));
    int outer = 0;
    for (std::int64_t i = 0; i < 8000; ++i)
        if (const glm::dvec3 p = position(torus, Kind::stipples, i); std::hypot(p.x, p.y) > 1.0) ++outer;
    // The share of the outer half is 1/2 + r / (pi R).
    EXPECT_NEAR(outer / 8000.0, 0.5 + 0.35 / 3.14159265, 0.01);
}

TEST(BlueNoise, RanksFollowTheOrder) {
    const PointSet set = make(Sphere(), blue({Kind::stipples}, 1000));
    const Layer& marks = of(set, Kind::stipples);
    for (std::int64_t i = 0; i < 1000; ++i) {
        EXPECT_NEAR(marks.rank[i], 1.0 - (static_cast<double>(i) + 0.5) / 1000.0, 1e-6);
        EXPECT_EQ(marks.stroke[2 * i], 2 * i);
        EXPECT_EQ(marks.stroke[2 * i + 1], 0U);
        EXPECT_EQ(marks.level[i], 0);
    }
    EXPECT_EQ(set.distribution, Distribution::blue_noise);
    const LevelReport& report = marks.report.level[0];
    EXPECT_GE(report.attempted, 5500);
    EXPECT_EQ(report.placed, 1000);
    EXPECT_EQ(marks.report.full_count, 1000);
}

TEST(BlueNoise, SpacingMatchesTheSurfaceArea) {
    const Torus torus;
    for (const std::int64_t budget : {1, 7, 100, 3000, 20000}) {
        const PointSet set = make(torus, blue({Kind::stipples}, budget));
        EXPECT_EQ(of(set, Kind::stipples).count(), budget);
        const double expected = std::sqrt(torus.area() / static_cast<double>(budget));
        EXPECT_NEAR(set.spacing, expected, 0.03 * expected);
    }
}

// With few candidates a sweep's first step may use up its own, while the last step, whose distance is smaller, still
// has some.
TEST(BlueNoise, OrderingEndsIfCandidatesRunOut) {
    const Torus torus;
    const Site site{runtime(), torus, 1e-6, 1};
    geometry::VecArray seed(runtime().memory);
    seed.push_back({1.35, 0.0, 0.0});
    const geometry::Bounds region = torus.bounds().grown(0.1);
    for (const std::int64_t wanted : {4000, 6000, 9000, 13000}) {
        const SurfaceCells cells =
            find_surface_cells(site, seed, region, 2.2 * std::sqrt(torus.area() / static_cast<double>(wanted)));
        for (const std::int64_t each : {1, 2, 3}) {
            Candidates candidates = draw_candidates(site, cells, each * wanted, Kind::stipples);
            const OrderedMarks marks = progressive_order(site, candidates, wanted);
            EXPECT_GT(marks.size(), wanted * (each == 1 ? 6 : 9) / 10) << each;
        }
    }
}

TEST(BlueNoise, ReachesAllComponentsThatHaveASeed) {
    const TwoTori tori;
    const PointSet set = make(tori, blue({Kind::stipples}, 4000));
    expect_sound(set, tori);
    int second = 0;
    for (std::int64_t i = 0; i < 4000; ++i) {
        const glm::dvec3 p = position(set, Kind::stipples, i);
        if (std::abs(Torus(1.0, 0.3).at(p).value) > 1e-3) ++second;
    }
    EXPECT_NEAR(second, 2000, 60);
    generate::Settings one = blue({Kind::stipples}, 1000);
    const std::vector<double> seed = {1.3, 0.0, 0.0};
    use_points(one, seed);
    const PointSet flat = make(tori, one);
    for (std::int64_t i = 0; i < 1000; ++i) {
        const glm::dvec3 p = position(flat, Kind::stipples, i);
        EXPECT_NEAR(Torus(1.0, 0.3).at(p).value, 0.0, 1e-5) << "the linked one is not reached";
    }
}

// The two faces are closer to each other than the marks. Each face gets its own even order.
TEST(BlueNoise, ThinSheetsAreCoveredOnBothFaces) {
    const ThinSlab slab(0.004);
    const PointSet set = make(slab, blue({Kind::stipples}, 2000));
    expect_sound(set, slab, 2e-6);
    for (const std::int64_t prefix : {200, 1000, 2000}) {
        int upper = 0;
        for (std::int64_t i = 0; i < prefix; ++i)
            if (position(set, Kind::stipples, i).z > 0.0) ++upper;
        EXPECT_NEAR(static_cast<double>(upper) / static_cast<double>(prefix), 0.5, 0.04) << prefix;
    }
}

// This holds if f is no distance, too: a Newton step from between the faces lands far outside.
TEST(BlueNoise, EachFaceOfAThinSheetIsEven) {
    const ThinSlab slab(0.004);
    for (const std::int64_t budget : {2000, 20000}) {
        const PointSet set = make(slab, blue({Kind::stipples}, budget));
        EXPECT_EQ(of(set, Kind::stipples).count(), budget);
        geometry::VecArray upper(runtime().memory);
        for (std::int64_t i = 0; i < of(set, Kind::stipples).count(); ++i)
            if (const glm::dvec3 p = position(set, Kind::stipples, i); p.z > 0.0) upper.push_back(p);
        const geometry::PointTree tree(upper, {});
        double smallest = 1e300;
        for (std::int64_t at = 0; at < tree.size(); ++at) smallest = std::min(smallest, tree.nearest_other(at));
        EXPECT_GT(smallest, 0.62 * std::sqrt(2.0 / std::sqrt(3.0)) * set.spacing) << budget;
    }
}

// The lens has a rim far sharper than the spacing of marks.
TEST(BlueNoise, MarksKeepApartAroundASharpRim) {
    const AnyField lens({{-1.0, -1.0, -0.05}, {1.0, 1.0, 0.05}}, [](const glm::dvec3& p) {
        constexpr double flat = 400.0;
        Field field;
        const glm::dvec3 slope(2.0 * p.x, 2.0 * p.y, 2.0 * flat * p.z);
        field.value = p.x * p.x + p.y * p.y + flat * p.z * p.z - 1.0;
        field.gradient = slope;
        return field;
    });
    const PointSet set = make(lens, blue({Kind::stipples}, 3000));
    const Layer& marks = of(set, Kind::stipples);
    EXPECT_GE(marks.count(), 2940);
    const double densest = std::sqrt(2.0 / std::sqrt(3.0)) * set.spacing;
    double smallest = 1e300;
    for (std::int64_t i = 0; i < marks.count(); ++i)
        for (std::int64_t j = 0; j < i; ++j) {
            if (glm::dot(vec(marks.normal, i), vec(marks.normal, j)) < 0.5) continue;
            smallest = std::min(smallest, glm::distance(vec(marks.position, i), vec(marks.position, j)));
        }
    EXPECT_GT(smallest, 0.64 * densest);
}

TEST(BlueNoise, OpenSheetsEndALittleOutsideTheBounds) {
    const Plane plane({0.0, 0.0, 1.0}, 0.0, {{-1.0, -1.0, 0.0}, {1.0, 1.0, 0.0}});
    const PointSet set = make(plane, blue({Kind::stipples, Kind::hatch}, 3000));
    const double margin = 0.03 * std::sqrt(8.0);
    EXPECT_NEAR(set.bounds.max.x, 1.0 + margin, 0.05);
    EXPECT_LE(set.bounds.max.x, 1.0 + margin) << "strokes that reach farther are cut";
    EXPECT_GE(set.bounds.min.y, -1.0 - margin);
    expect_sound(set, plane);
    const LayerReport& strokes = of(set, Kind::hatch).report;
    std::int64_t placed = 0;
    for (const LevelReport& level : strokes.level) placed += level.placed;
    EXPECT_EQ(of(set, Kind::hatch).count(), placed);
    const Evenness e = evenness(set, 1.0, std::pow(2.0 + 2.0 * margin, 2));
    EXPECT_GT(e.smallest, 0.6);
    EXPECT_GT(e.mean, 0.74);
    EXPECT_NEAR(set.spacing, (2.0 + 2.0 * margin) / std::sqrt(3000.0), 0.03 * set.spacing);
}

// A single sample is a plane whose bounds have no size. Marks fill some square of it.
TEST(BlueNoise, OneSampleGivesASquareOfItsPlane) {
    const std::vector<double> sample = {3.0, 2.0, 1.0};
    const Plane plane({0.0, 1.0, 0.0}, 2.0, {{3.0, 2.0, 1.0}, {3.0, 2.0, 1.0}});
    const PointSet set = make(plane, blue({Kind::stipples, Kind::hatch}, 2000), {sample, 0.0});
    EXPECT_EQ(of(set, Kind::stipples).count(), 2000);
    expect_sound(set, plane);
    EXPECT_NEAR(set.bounds.min.x, 2.5, 0.1);
    EXPECT_NEAR(set.bounds.max.z, 1.5, 0.1);
}

// The function's other sheet is away from the samples and gets no marks.
TEST(BlueNoise, SheetsFarFromTheSamplesStayEmpty) {
    const AnyField two(cube(1.0), [](const glm::dvec3& p) {
        const Field inner = Sphere(1.0).at(p);
        Field outer = Sphere(1.2).at(p);
        if (std::abs(inner.value) <= std::abs(outer.value)) return inner;
        outer.value = -outer.value;
        outer.gradient = -outer.gradient;
        return outer;
    });
    const std::vector<double> samples = spiral_seeds(100);
    const PointSet set = make(two, blue({Kind::stipples}, 2000), {samples, 0.3});
    for (std::int64_t i = 0; i < 2000; ++i) EXPECT_NEAR(glm::length(position(set, Kind::stipples, i)), 1.0, 1e-6);
}

TEST(BlueNoise, SmallSurfacesInLargeBoxesAreFound) {
    const SquareSphere sphere(0.02, 50.0); // a hundredth of the box; the cells of the seeds are three times as large
    const PointSet set = make(sphere, blue({Kind::stipples}, 2000));
    EXPECT_GE(of(set, Kind::stipples).count(), 1996) << "few come to rest beside another";
    expect_sound(set, sphere);
    const double area = sphere_area * 0.02 * 0.02;
    EXPECT_NEAR(set.spacing, std::sqrt(area / 2000.0), 0.05 * set.spacing);
}

} // namespace
} // namespace hrbfnpr::stipples::blue_noise_test
