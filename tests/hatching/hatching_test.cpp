// SPDX-License-Identifier: MIT
// Tests evenly spaced, nested lines: distances, levels, directions, ends.
#include "support/line_spacing.h"
#include "support/sharp_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::hatching::hatching_test {
namespace {

using namespace marks;
using namespace test;

generate::Settings hatched(double separation, double angle = 0.0) {
    generate::Settings settings = blue({Kind::hatch}, 0);
    of(settings, Kind::hatch).hatching.separation = separation;
    of(settings, Kind::hatch).hatching.angle = angle;
    return settings;
}

const Layer& hatch_of(const PointSet& set) { return of(set, Kind::hatch); }

// The spacing of marks up to level `levels`. A line that winds round is its own neighbour.
Spacing spacing_of(const PointSet& set, int levels, double unit) {
    const Layer& marks = hatch_of(set);
    const SpacingSettings settings{unit, 0.24 * marks.report.step, 12};
    return test::spacing_of(marks, settings, [&](std::int64_t i) { return marks.level[i] <= levels; });
}

// Checks the spacing of all lines, and of the lines that remain with one and two levels less: where the field spreads,
// these have fewer places to begin new lines.
void expect_even(const PointSet& set, double most_variation, double most_alone) {
    const LayerReport& report = hatch_of(set).report;
    ASSERT_GE(report.levels, 2);
    for (int without = 0; without <= 2; ++without) {
        const Spacing spacing =
            spacing_of(set, static_cast<int>(report.levels) - without, std::ldexp(report.step, without));
        EXPECT_NEAR(spacing.mean, 1.0, 0.06) << without;
        EXPECT_LE(spacing.variation, (1.0 + 0.25 * without) * most_variation) << without;
        EXPECT_LE(spacing.alone, most_alone) << without;
    }
}

// Each level has as many lines as all levels before it together.
void expect_nested(const PointSet& set) {
    const Layer& marks = hatch_of(set);
    std::vector<double> count(static_cast<std::size_t>(marks.report.levels) + 1);
    for (std::int64_t i = 0; i < marks.count(); ++i) count.at(marks.level[i]) += 1.0;
    double before = count[0];
    for (std::size_t level = 1; level < count.size(); ++level) {
        EXPECT_NEAR(count[level] / before, 1.0, level < 2 ? 0.35 : 0.15) << level;
        before += count[level];
    }
    std::int64_t changes = 0;
    for (std::int64_t i = 1; i < marks.count(); ++i) {
        EXPECT_LE(marks.rank[i], marks.rank[i - 1]);
        if (marks.stroke[2 * i] == marks.stroke[2 * i - 2] && marks.level[i] != marks.level[i - 1]) ++changes;
    }
    EXPECT_LE(static_cast<double>(changes), 0.02 * static_cast<double>(marks.count()));
}

// Marks are a step apart and lie on the surface, and lines do not turn sharply.
void expect_flowing(const PointSet& set, const Analytic& surface, double step) {
    const Layer& marks = hatch_of(set);
    expect_sound(set, surface);
    std::int64_t sharp = 0;
    for (std::int64_t i = 1; i < marks.count(); ++i) {
        if (marks.stroke[2 * i] != marks.stroke[2 * i - 2]) continue;
        const glm::dvec3 leg = vec(marks.position, i) - vec(marks.position, i - 1);
        ASSERT_NEAR(glm::length(leg), step, 0.6 * step) << i;
        if (glm::dot(vec(marks.direction, i), vec(marks.direction, i - 1)) < 0.9) ++sharp;
    }
    EXPECT_LE(static_cast<double>(sharp), 2e-3 * static_cast<double>(marks.count()));
}

TEST(Hatching, IsEvenAndNestedOnATorus) {
    const Torus torus;
    const PointSet set = make(torus, hatched(0.03));
    expect_even(set, 0.14, 0.02);
    expect_nested(set);
    expect_flowing(set, torus, 0.012);
    const Layer& marks = hatch_of(set);
    // Without additional forks in each level, the waves have 0.124.
    EXPECT_LE(spacing_of(set, static_cast<int>(marks.report.levels), marks.report.step).variation, 0.115);
    EXPECT_EQ(marks.report.step, 0.03);
    EXPECT_NEAR(static_cast<double>(marks.count()), torus.area() / (0.03 * 0.012),
                0.06 * static_cast<double>(marks.count()));
}

TEST(Hatching, IsEvenOnASphereGuidedByTheAxisAlone) {
    const Sphere sphere;
    const PointSet set = make(sphere, hatched(0.03));
    expect_even(set, 0.13, 0.05);
    expect_flowing(set, sphere, 0.012);
    // The lines run around the axis, at right angles to it.
    const Layer& marks = hatch_of(set);
    double sum = 0.0;
    double count = 0.0;
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        if (std::abs(vec(marks.normal, i).y) > 0.8) continue;
        sum += std::abs(vec(marks.direction, i).y);
        count += 1.0;
    }
    EXPECT_LT(sum / count, 0.05);
}

// The mean angle between lines and rings around the tube, the direction of the largest curvature, in degrees.
double mean_angle_to_rings(const PointSet& set) {
    const Layer& marks = hatch_of(set);
    double sum = 0.0;
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        const glm::dvec3 p = position(set, Kind::hatch, i);
        const glm::dvec3 along = glm::normalize(glm::dvec3(-p.y, p.x, 0.0));
        const glm::dvec3 ring = glm::cross(vec(marks.normal, i), along);
        const glm::dvec3 d = vec(marks.direction, i);
        sum += std::atan(glm::dot(d, along) / glm::dot(d, ring)) * 180.0 / std::numbers::pi;
    }
    return sum / static_cast<double>(marks.count());
}

TEST(Hatching, FollowsTheLargerCurvatureTurnedByTheAngle) {
    const Torus torus;
    EXPECT_NEAR(mean_angle_to_rings(make(torus, hatched(0.04))), 0.0, 2.0);
    // The turn from ring to along is clockwise: n x along = ring.
    EXPECT_NEAR(mean_angle_to_rings(make(torus, hatched(0.04, 30.0 * std::numbers::pi / 180.0))), -30.0, 3.0);
}

TEST(Hatching, FollowsAFunction) {
    generate::Settings settings = hatched(0.04);
    of(settings, Kind::hatch).hatching.direction.function = [](void*, std::int64_t count, const double* positions,
                                                               const double*, double* directions) -> std::int32_t {
        for (std::int64_t i = 0; i < count; ++i) {
            directions[3 * i] = -positions[3 * i + 1];
            directions[3 * i + 1] = positions[3 * i];
            directions[3 * i + 2] = 0.0;
        }
        return 0;
    };
    const PointSet set = make(Torus(), settings);
    for (std::int64_t i = 0; i < hatch_of(set).count(); ++i) {
        const glm::dvec3 p = position(set, Kind::hatch, i);
        const glm::dvec3 along = glm::normalize(glm::dvec3(-p.y, p.x, 0.0));
        EXPECT_GT(std::abs(glm::dot(along, vec(hatch_of(set).direction, i))), 0.95) << i;
    }
}

// Lines of a plane are straight, and the other side of a thin sheet does not change the lines.
TEST(Hatching, IsStraightOnAPlane) {
    const Plane plane({0.0, 0.0, 1.0}, 0.0, cube(1.0));
    const PointSet set = make(plane, hatched(0.03));
    const Layer& marks = hatch_of(set);
    for (std::int64_t i = 0; i < marks.count(); ++i)
        EXPECT_GT(std::abs(glm::dot(vec(marks.direction, 0), vec(marks.direction, i))), 0.98) << i;
    expect_even(set, 0.13, 0.1);
    const ThinSlab slab(0.004);
    const PointSet both = make(slab, hatched(0.03));
    expect_even(both, 0.13, 0.1);
}

// A plane with rounding errors in its curvature.
FieldFunction fitted_plane(const glm::dvec3& n) {
    return [n](const glm::dvec3& p) {
        const double k = 1e-9 * std::sin(7.0 * (p.x + p.y + p.z));
        const double l = 1e-9 * std::sin(5.0 * (p.x - 2.0 * p.y - p.z));
        return Field{glm::dot(n, p) - 1.0, n, {k, l, k + l, k - l, l, k}};
    };
}

// On the two sides across the axis nothing else sets a direction.
TEST(Hatching, IsStraightOnEachSideOfACube) {
    std::vector<Sharp> sides;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            glm::dvec3 n(0.0);
            n[axis] = sign;
            sides.emplace_back(fitted_plane(n));
        }
    const SharpShape box(cube(1.1), max_of(std::move(sides)));
    const PointSet set = make(box, hatched(0.03));
    const Layer& marks = hatch_of(set);
    std::array<glm::dvec3, 6> first{};
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        const glm::dvec3 p = vec(marks.position, i);
        const glm::dvec3 q = glm::abs(p);
        if (q.x + q.y + q.z - std::max({q.x, q.y, q.z}) - std::min({q.x, q.y, q.z}) > 0.97)
            continue; // a mark at an edge
        const int axis = q.x > q.y && q.x > q.z ? 0 : q.y > q.z ? 1 : 2;
        glm::dvec3& along = first[static_cast<std::size_t>(2 * axis + (p[axis] > 0.0 ? 1 : 0))];
        if (along == glm::dvec3(0.0)) along = vec(marks.direction, i);
        EXPECT_GT(std::abs(glm::dot(along, vec(marks.direction, i))), 0.98) << i;
    }
    for (const glm::dvec3& along : first) EXPECT_NE(along, glm::dvec3(0.0));
}

TEST(Hatching, MarkCountIsCloseToTheBudget) {
    for (const std::int64_t budget : {1000, 20000}) {
        const PointSet set = make(Torus(), blue({Kind::hatch}, budget));
        EXPECT_NEAR(static_cast<double>(hatch_of(set).count()), static_cast<double>(budget),
                    0.15 * static_cast<double>(budget));
    }
}

TEST(Hatching, TooSmallASeparationIsRefused) {
    generate::Settings tiny = hatched(1e-6);
    expect_error(Status::invalid_argument, {"layers[0]", "separation"}, [&] { (void)make(Sphere(), tiny); });
}

} // namespace
} // namespace hrbfnpr::hatching::hatching_test
