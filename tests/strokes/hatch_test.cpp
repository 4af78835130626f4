// SPDX-License-Identifier: MIT
// Evenly spaced strokes: distances, order, directions, ends.
#include "support/line_spacing.h"

#include "geometry/tangent_frame.h"

#include <algorithm>
#include <map>

namespace hrbfnpr::strokes::hatch_test {
namespace {

using namespace marks;
using namespace test;

struct Stroke {
    std::int64_t begin = 0, end = 0; // marks
    [[nodiscard]] std::int64_t count() const { return end - begin; }
};

// The strokes in the order of the arrays, each of which must lie in one piece, from place 0 on.
std::vector<Stroke> strokes_of(const Layer& marks) {
    std::vector<Stroke> strokes;
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        if (marks.stroke[2 * i + 1] == 0) strokes.push_back({i, i});
        EXPECT_EQ(marks.stroke[2 * i + 1], static_cast<std::uint32_t>(i - strokes.back().begin));
        EXPECT_EQ(marks.stroke[2 * i], marks.stroke[2 * strokes.back().begin]);
        strokes.back().end = i + 1;
    }
    return strokes;
}

// Of a share of the ranks.
Spacing spacing_of(const PointSet& set, Kind kind, double share, double unit) {
    const Layer& marks = of(set, kind);
    return test::spacing_of(marks, {unit, 0.12 * marks.report.step, 0},
                            [&](std::int64_t i) { return static_cast<double>(marks.rank[i]) >= 1.0 - share; });
}

void expect_even(const PointSet& set, Kind kind, double most_variation, double most_alone) {
    const double separation = of(set, kind).report.step;
    for (const double share : {1.0, 0.5, 0.25}) {
        const Spacing spacing = spacing_of(set, kind, share, separation / share);
        EXPECT_NEAR(spacing.mean, 1.0, 0.1) << share;
        EXPECT_LE(spacing.variation, share < 1.0 ? 1.1 * most_variation : most_variation) << share;
        EXPECT_LE(spacing.alone, most_alone) << share;
    }
}

// Marks are a step apart, and neither they nor their directions turn sharply.
void expect_flowing(const PointSet& set, Kind kind, double step) {
    const Layer& marks = of(set, kind);
    for (const Stroke& stroke : strokes_of(marks)) {
        ASSERT_GE(stroke.count(), 3);
        for (std::int64_t i = stroke.begin + 1; i < stroke.end; ++i) {
            const glm::dvec3 leg = position(set, kind, i) - position(set, kind, i - 1);
            ASSERT_NEAR(glm::length(leg), step, 0.25 * step) << i;
            ASSERT_GT(glm::dot(vec(marks.direction, i), vec(marks.direction, i - 1)), 0.5) << i;
            ASSERT_GT(glm::dot(vec(marks.direction, i), leg), 0.5 * glm::length(leg)) << i;
            if (i < stroke.begin + 2) continue;
            const glm::dvec3 before = position(set, kind, i - 1) - position(set, kind, i - 2);
            ASSERT_GT(glm::dot(leg, before), 0.5 * glm::length(leg) * glm::length(before)) << i; // 60 degrees
        }
    }
}

void expect_tapered(const Layer& marks) {
    ASSERT_EQ(marks.width.size(), marks.count());
    std::int64_t open = 0;
    for (const Stroke& stroke : strokes_of(marks)) {
        const float tip = marks.width[stroke.begin];
        if (tip == 1.0F || marks.width[stroke.end - 1] == 1.0F) continue; // closed, or goes on in the other set
        ++open;
        EXPECT_NEAR(tip, 0.3F, 1e-6F);
        EXPECT_EQ(tip, marks.width[stroke.end - 1]);
        EXPECT_GT(marks.width[(stroke.begin + stroke.end) / 2], 0.95F);
        for (std::int64_t i = stroke.begin + 1; i <= (stroke.begin + stroke.end - 1) / 2; ++i)
            ASSERT_GE(marks.width[i], marks.width[i - 1]);
    }
    EXPECT_GT(open, 0);
}

TEST(Hatch, IsEvenOnATorusAtEveryShareOfItsRanks) {
    const Torus torus;
    for (const Symmetry field : {Symmetry::line, Symmetry::cross}) {
        generate::Settings settings = blue({Kind::principal}, 60000);
        for (LayerSettings& layer : settings.layers) layer.strokes.symmetry = field;
        const PointSet set = make(torus, settings);
        expect_sound(set, torus);
        expect_even(set, Kind::principal, 0.25, 0.03);
        expect_flowing(set, Kind::principal, 0.2 * of(set, Kind::principal).report.step);
        expect_tapered(of(set, Kind::principal));
    }
}

TEST(Hatch, IsEvenOnASphereWhereNoDirectionIsPrincipal) {
    const Sphere sphere;
    for (const Kind kind : {Kind::principal, Kind::combing}) {
        const PointSet set = make(sphere, blue({kind}, 60000));
        expect_sound(set, sphere);
        expect_even(set, kind, 0.25, 0.03);
        expect_flowing(set, kind, 0.2 * of(set, kind).report.step);
    }
}

// The mean gap is the separation, so a share of the ranks has that share of the ink, in each set.
TEST(Hatch, RanksFallAndAreSharesOfEachSetsInk) {
    const PointSet set = make(Torus(), blue({Kind::principal}, 30000));
    const Layer& marks = of(set, Kind::principal);
    const std::vector<Stroke> strokes = strokes_of(marks);
    EXPECT_EQ(marks.strokes(), static_cast<std::int64_t>(strokes.size()));
    std::array<std::int64_t, 2> all{};
    std::array<std::int64_t, 2> before{};
    for (const Stroke& stroke : strokes) all[marks.stroke[2 * stroke.begin] & 1U] += stroke.count();
    std::array<float, 2> last{1.0F, 1.0F};
    for (const Stroke& stroke : strokes) {
        const std::size_t s = marks.stroke[2 * stroke.begin] & 1U;
        const double middle = static_cast<double>(before[s]) + 0.5 * static_cast<double>(stroke.count());
        const float rank = marks.rank[stroke.begin];
        EXPECT_NEAR(rank, 1.0 - middle / static_cast<double>(all[s]), 1e-6);
        EXPECT_LT(rank, last[s]);
        last[s] = rank;
        for (std::int64_t i = stroke.begin; i < stroke.end; ++i) ASSERT_EQ(marks.rank[i], rank);
        before[s] += stroke.count();
    }
    EXPECT_NEAR(static_cast<double>(all[0]), static_cast<double>(all[1]), 0.1 * static_cast<double>(all[0]));
    for (std::size_t i = 1; i < strokes.size(); ++i)
        EXPECT_GE(marks.level[strokes[i].begin], marks.level[strokes[i - 1].begin]) << "coarse passes first";
}

TEST(Hatch, DirectionsAreThePrincipalOnesOfATorus) {
    const Torus torus;
    for (const Symmetry field : {Symmetry::line, Symmetry::cross}) {
        generate::Settings settings = blue({Kind::principal}, 40000);
        for (LayerSettings& layer : settings.layers) layer.strokes.symmetry = field;
        const PointSet set = make(torus, settings);
        const Layer& marks = of(set, Kind::principal);
        std::vector<double> error;
        for (std::int64_t i = 0; i < marks.count(); ++i) {
            const glm::dvec3 p = position(set, Kind::principal, i);
            const glm::dvec3 around = glm::normalize(glm::dvec3(-p.y, p.x, 0.0));
            const double cosine = std::abs(glm::dot(around, vec(marks.direction, i)));
            // Set 1 (d2, the smaller curvature, by sign) is the meridians: the tube bends away most.
            const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
            const double off = (marks.stroke[2 * i] & 1U) == 0 ? std::atan2(sine, cosine) : std::atan2(cosine, sine);
            error.push_back(off * 57.29577951308232);
        }
        std::sort(error.begin(), error.end());
        double mean = 0.0;
        for (const double e : error) mean += e / static_cast<double>(error.size());
        EXPECT_LE(mean, 0.05);
        EXPECT_LE(error[error.size() * 95 / 100], 0.2);
    }
}

TEST(Hatch, KeepsToTheBudgetByLeavingOutTheLastStrokes) {
    for (const std::int64_t budget : {2, 50, 1000, 20000}) {
        const PointSet set = make(Torus(), blue({Kind::principal}, budget));
        const Layer& marks = of(set, Kind::principal);
        EXPECT_LE(marks.count(), budget);
        EXPECT_TRUE(budget < 1000 || marks.count() >= budget * 85 / 100) << marks.count();
        EXPECT_GE(marks.report.full_count, marks.count());
    }
}

TEST(Hatch, SeparationStepAndLengthAreAsAskedFor) {
    const Torus torus;
    generate::Settings settings = blue({Kind::principal}, 0);
    of(settings, Kind::principal).strokes.separation = 0.06;
    of(settings, Kind::principal).strokes.step = 0.02;
    of(settings, Kind::principal).strokes.longest = 0.5;
    const PointSet set = make(torus, settings);
    const Layer& marks = of(set, Kind::principal);
    EXPECT_EQ(marks.report.step, 0.06);
    expect_flowing(set, Kind::principal, 0.02);
    for (const Stroke& stroke : strokes_of(marks)) EXPECT_LE(stroke.count(), 27);
    EXPECT_NEAR(static_cast<double>(marks.count()), 2.0 * torus.area() / (0.06 * 0.02),
                0.15 * static_cast<double>(marks.count()));
    // Half the budget is the first half of the same strokes.
    of(settings, Kind::principal).budget = marks.count() / 2;
    const PointSet half = make(torus, settings);
    const Layer& kept = of(half, Kind::principal);
    ASSERT_LE(kept.count(), marks.count() / 2);
    EXPECT_GT(kept.count(), marks.count() / 2 - 100);
    EXPECT_GT(kept.report.full_count, kept.count());
    // Steps longer than strokes are traced in.
    of(settings, Kind::principal).budget = 0;
    of(settings, Kind::principal).strokes.longest = 0.0;
    of(settings, Kind::principal).strokes.step = 0.1;
    expect_flowing(make(torus, settings), Kind::principal, 0.1);
}

TEST(Hatch, ASeparationThatMakesTooManyMarksIsRefused) {
    generate::Settings settings = blue({Kind::principal}, 0);
    of(settings, Kind::principal).strokes.separation = 1e-6;
    expect_error(Status::invalid_argument, {"layers[0]", "separation", "budget"},
                 [&] { (void)make(Sphere(), settings); });
}

// Fields of a plane are constant: strokes are straight, parallel, and all but as far apart as can be.
TEST(Hatch, IsStraightOnAPlane) {
    const Plane plane({0.0, 0.0, 1.0}, 0.0, cube(1.0));
    const PointSet set = make(plane, blue({Kind::principal}, 10000));
    const Layer& marks = of(set, Kind::principal);
    const glm::dvec3 first = vec(marks.direction, 0);
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        const double cosine = std::abs(glm::dot(first, vec(marks.direction, i)));
        EXPECT_TRUE(cosine < 1e-3 || cosine > 0.999) << i << " " << cosine;
    }
    // Few strokes, so that it takes several sets to tell; many of a quarter of them are at the border.
    for (const double share : {1.0, 0.5, 0.25}) {
        double variation = 0.0;
        for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
            generate::Settings settings = blue({Kind::principal}, 10000);
            settings.random_seed = seed;
            const PointSet strokes = make(plane, settings);
            const double separation = of(strokes, Kind::principal).report.step / share;
            const Spacing spacing = spacing_of(strokes, Kind::principal, share, separation);
            EXPECT_NEAR(spacing.mean, 1.0, 0.1) << share;
            EXPECT_LE(spacing.alone, 0.15) << share;
            variation += 0.25 * spacing.variation;
        }
        EXPECT_LE(variation, 0.25) << share;
    }
    // Nothing on the other side of a thin sheet keeps a stroke away.
    const ThinSlab slab(0.004);
    const PointSet two = make(slab, blue({Kind::principal}, 20000));
    const Layer& both = of(two, Kind::principal);
    std::int64_t above = 0;
    for (std::int64_t i = 0; i < both.count(); ++i) above += vec(both.normal, i).z > 0.0 ? 1 : 0;
    EXPECT_NEAR(static_cast<double>(above), 0.5 * static_cast<double>(both.count()),
                0.06 * static_cast<double>(both.count()));
}

// Combing strokes cross the borders of Stark's regions, and follow his directions inside them.
TEST(Hatch, CombingFollowsStarksFieldAwayFromItsBorders) {
    const PointSet set = make(Sphere(), blue({Kind::combing}, 40000));
    const Layer& marks = of(set, Kind::combing);
    std::int64_t inside = 0;
    std::int64_t follows = 0;
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        const glm::dvec3 n = vec(marks.normal, i);
        std::array<double, 3> a{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
        std::sort(a.begin(), a.end());
        if (a[1] - a[0] < 0.3) continue;
        ++inside;
        const geometry::TangentFrame frame = geometry::combing_frame(n);
        const glm::dvec3 d = vec(marks.direction, i);
        const double cosine = std::max(std::abs(glm::dot(d, frame.r)), std::abs(glm::dot(d, frame.u)));
        follows += cosine > 0.9999 ? 1 : 0;
    }
    EXPECT_GT(inside, marks.count() / 4);
    EXPECT_GT(follows, inside * 95 / 100);
}

TEST(Hatch, IsTheSameForAnyNumberOfThreads) {
    const Torus torus;
    for (const Symmetry field : {Symmetry::line, Symmetry::cross}) {
        generate::Settings settings = blue({Kind::principal, Kind::combing}, 8000);
        for (LayerSettings& layer : settings.layers) layer.strokes.symmetry = field;
        const PointSet one = make(torus, settings);
        for (const int threads : {2, 3, 7}) {
            base::Runtime several;
            several.parallel = base::Parallel(threads, nullptr, nullptr);
            EXPECT_TRUE(same_bits(one, generate::generate(several, torus, {}, settings, {}))) << threads;
        }
    }
}

} // namespace
} // namespace hrbfnpr::strokes::hatch_test
