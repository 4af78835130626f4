// SPDX-License-Identifier: MIT
#include "surface/cast_rays.h"

#include "support/analytic.h"
#include "support/runtime.h"
#include "surface/region.h"

#include <gtest/gtest.h>

namespace hrbfnpr::surface::cast_rays_test {
namespace {

using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();

base::Runtime& runtime() {
    static base::Runtime instance;
    return instance;
}

struct Line {
    glm::dvec3 origin;
    glm::dvec3 direction;
};

Rays rays_of(const std::vector<Line>& lines) {
    Rays rays(runtime().memory);
    for (const Line& line : lines) {
        rays.origin.push_back(line.origin);
        rays.direction.push_back(line.direction);
    }
    return rays;
}

RayHits cast(const implicit::Implicit& implicit, const std::vector<Line>& lines, const RaySettings& settings = {}) {
    RayHits hits(runtime().memory);
    cast_rays(runtime(), implicit, settings, rays_of(lines), hits);
    return hits;
}

RaySettings at_most(std::int32_t hits) {
    RaySettings settings;
    settings.maximum_hits = hits;
    return settings;
}

// Returns rays that start all around and aim at points all over the inside.
std::vector<Line> many_lines(int count, double from = 3.0, double to = 0.9) {
    std::vector<Line> lines;
    for (int i = 0; i < count; ++i) {
        const auto [x, y, z] = spiral_point(i, count);
        const auto [u, v, w] = spiral_point((i * 37) % count, count);
        const glm::dvec3 origin = from * glm::dvec3(x, y, z);
        lines.push_back({origin, to * glm::dvec3(u, v, w) - origin});
    }
    return lines;
}

// Returns the roots of |o + t d| = radius in ascending order.
std::array<double, 2> sphere_roots(const Line& line, double radius) {
    const double a = glm::dot(line.direction, line.direction);
    const double b = glm::dot(line.origin, line.direction);
    const double root = std::sqrt(b * b - a * (glm::dot(line.origin, line.origin) - radius * radius));
    return {(-b - root) / a, (-b + root) / a};
}

void expect_sphere(const implicit::Implicit& sphere, const std::vector<Line>& lines, const RaySettings& settings) {
    const RayHits hits = cast(sphere, lines, settings);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const auto i = static_cast<std::int64_t>(k);
        ASSERT_EQ(hits.status[i], RayStatus::hit) << k;
        ASSERT_EQ(hits.count[i], 2) << k;
        const auto roots = sphere_roots(lines[k], 1.0);
        for (const int h : {0, 1}) {
            const glm::dvec3 p = lines[k].origin + roots[static_cast<std::size_t>(h)] * lines[k].direction;
            EXPECT_NEAR(hits.t[2 * i + h], roots[static_cast<std::size_t>(h)], 1e-8) << k;
            EXPECT_NEAR(glm::distance(hits.position[2 * i + h], p), 0.0, 1e-8);
            EXPECT_NEAR(glm::distance(hits.normal[2 * i + h], p), 0.0, 1e-8);
            EXPECT_EQ(hits.entering[2 * i + h], 1 - h);
        }
    }
}

TEST(CastRays, HitsASphereAtItsSurface) {
    // The number of rays is more than a batch, and not a multiple of it.
    expect_sphere(Sphere(), many_lines(1000), at_most(2));
    expect_sphere(SquareSphere(), many_lines(700), at_most(2));
    RaySettings settings = at_most(2);
    settings.lipschitz = 1.0;
    expect_sphere(Sphere(), many_lines(300), settings);
}

// A step that changes f by more than the bound allows is taken back, even if it ends inside the other side of the tube.
TEST(CastRays, ABoundThatProvesTooSmallIsRaised) {
    RaySettings settings = at_most(4);
    settings.lipschitz = 0.06;
    const RayHits hits = cast(Torus(1.0, 0.35), {{{-1.5, 0, 0}, {1, 0, 0}}}, settings); // f = 0.15 allows a step of 2.5
    ASSERT_EQ(hits.count[0], 4);
    EXPECT_NEAR(hits.t[0], 0.15, 1e-8);
    EXPECT_NEAR(hits.t[3], 2.85, 1e-8);
    settings.lipschitz = 1e-300;
    EXPECT_EQ(cast(Torus(1.0, 0.35), {{{-1.5, 0, 0}, {1, 0, 0}}}, settings).status[0], RayStatus::miss);
}

TEST(CastRays, RaysPastTheSurfaceMiss) {
    const RayHits hits = cast(Sphere(),
                              {{{-3, 0, 1.02}, {1, 0, 0}},    // past the sphere, through the region
                               {{-3, 0, 1.5}, {1, 0, 0}},     // past the region
                               {{-3, 0, 0}, {-1, 0, 0}},      // away from the sphere
                               {{0.99, 0.99, 0}, {1, 1, 0}}}, // from within the region, outward
                              at_most(2));
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(hits.status[i], RayStatus::miss) << i;
        EXPECT_EQ(hits.count[i], 0);
        for (int h = 0; h < 2; ++h) {
            EXPECT_EQ(hits.t[2 * i + h], infinity);
            EXPECT_EQ(hits.normal[2 * i + h], glm::dvec3(0.0));
            EXPECT_EQ(hits.position[2 * i + h], glm::dvec3(0.0));
        }
    }
}

// Chords longer than a smallest step are found. A touch changes no sign and does not count.
TEST(CastRays, GrazingRaysHitOnlyIfTheyCross) {
    const double smallest = 1e-4 * std::sqrt(12.0);
    for (const double factor : {1.01, 1.5, 4.0, 40.0}) {
        const double half = 0.5 * factor * smallest;
        const double height = std::sqrt(1.0 - half * half);
        const RayHits hits = cast(Sphere(), {{{-3, 0, height}, {1, 0, 0}}}, at_most(2));
        ASSERT_EQ(hits.count[0], 2) << factor;
        EXPECT_NEAR(hits.t[0], 3.0 - half, 1e-8);
        EXPECT_NEAR(hits.t[1], 3.0 + half, 1e-8);
    }
    EXPECT_EQ(cast(SquareSphere(), {{{-3, 0, 1}, {1, 0, 0}}}).status[0], RayStatus::miss);
}

TEST(CastRays, ARayFromInsideLeaves) {
    const RayHits hits = cast(Sphere(), {{{0.2, 0, 0}, {0, 0, 2}}, {{0, 0, 0}, {1, 0, 0}}}, at_most(3));
    EXPECT_NEAR(hits.t[0], 0.5 * std::sqrt(0.96), 1e-8);
    EXPECT_EQ(hits.count[0], 1);
    EXPECT_EQ(hits.entering[0], 0);
    EXPECT_NEAR(hits.t[3], 1.0, 1e-8);
    EXPECT_NEAR(glm::distance(hits.normal[3], {1, 0, 0}), 0.0, 1e-8);
}

TEST(CastRays, FindsAllFourHitsOfATorusInOrder) {
    const Torus torus(1.0, 0.35);
    const std::array<double, 4> wanted = {1.65, 2.35, 3.65, 4.35};
    const std::vector<Line> line = {{{-3, 0, 0}, {1, 0, 0}}};
    const RayHits all = cast(torus, line, at_most(6));
    EXPECT_EQ(all.status[0], RayStatus::hit);
    ASSERT_EQ(all.count[0], 4);
    for (int h = 0; h < 4; ++h) {
        EXPECT_NEAR(all.t[h], wanted[static_cast<std::size_t>(h)], 1e-8);
        EXPECT_NEAR(glm::distance(all.normal[h], {h % 2 == 0 ? -1 : 1, 0, 0}), 0.0, 1e-8);
        EXPECT_EQ(all.entering[h], 1 - h % 2);
    }
    EXPECT_EQ(all.t[4], infinity);
    EXPECT_EQ(all.entering[4], 0);
    // The first hit does not depend on the number of hits requested.
    EXPECT_EQ(cast(torus, line).t[0], all.t[0]);
    EXPECT_EQ(cast(torus, line).status[0], RayStatus::hit);
}

TEST(CastRays, ReportsMoreHitsThanThereIsRoomFor) {
    const Torus torus(1.0, 0.35);
    const std::vector<Line> line = {{{-3, 0, 0}, {1, 0, 0}}};
    for (const int room : {2, 3, 4}) {
        const RayHits hits = cast(torus, line, at_most(room));
        EXPECT_EQ(hits.count[0], room);
        EXPECT_EQ(hits.status[0], room < 4 ? RayStatus::truncated : RayStatus::hit) << room;
        EXPECT_NEAR(hits.t[room - 1], room == 2 ? 2.35 : room == 3 ? 3.65 : 4.35, 1e-8);
    }
}

// At each hit f is 0 and the normal is the gradient. Every sign change of a fine scan is a hit.
TEST(CastRays, HitsMatchAFineScan) {
    const Torus torus(1.0, 0.35);
    const std::vector<Line> lines = many_lines(400, 2.5, 0.7);
    const RayHits hits = cast(torus, lines, at_most(4));
    int four = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const auto i = static_cast<std::int64_t>(k);
        std::vector<double> roots;
        constexpr int places = 20000;
        const auto f = [&](double t) { return torus.at(lines[k].origin + t * lines[k].direction).value; };
        for (int j = 0; j < places; ++j)
            if ((f(3.0 * j / places) < 0.0) != (f(3.0 * (j + 1) / places) < 0.0)) roots.push_back(3.0 * j / places);
        ASSERT_EQ(hits.count[i], static_cast<int>(roots.size())) << k;
        for (std::size_t h = 0; h < roots.size(); ++h) {
            const auto at = 4 * i + static_cast<std::int64_t>(h);
            EXPECT_NEAR(hits.t[at], roots[h], 3.1 / places);
            EXPECT_NEAR(torus.at(hits.position[at]).value, 0.0, 1e-9);
            EXPECT_NEAR(glm::distance(hits.normal[at], torus.at(hits.position[at]).gradient), 0.0, 1e-8);
        }
        four += roots.size() == 4 ? 1 : 0;
    }
    EXPECT_GT(four, 10);
}

TEST(CastRays, TheRangeLimitsTheHits) {
    const Torus torus(1.0, 0.35);
    const std::vector<Line> line = {{{-3, 0, 0}, {1, 0, 0}}};
    const auto between = [&](double from, double to) {
        RaySettings settings = at_most(6);
        settings.t_min = from;
        settings.t_max = to;
        return cast(torus, line, settings);
    };
    EXPECT_EQ(between(0.0, 1.64).count[0], 0);
    EXPECT_EQ(between(0.0, 1.66).count[0], 1);
    EXPECT_EQ(between(1.66, 3.0).count[0], 1);
    EXPECT_NEAR(between(1.66, 3.0).t[0], 2.35, 1e-8);
    EXPECT_EQ(between(1.66, 3.0).entering[0], 0);
    EXPECT_EQ(between(-9.0, 9.0).count[0], 4);
    EXPECT_EQ(between(2.0, 2.0).status[0], RayStatus::miss);
    EXPECT_EQ(between(5.0, infinity).status[0], RayStatus::miss);
    // t may be negative, too.
    RaySettings settings;
    settings.t_min = -10.0;
    EXPECT_NEAR(cast(torus, {{{3, 0, 0}, {1, 0, 0}}}, settings).t[0], -4.35, 1e-8);
}

TEST(CastRays, TIsMeasuredInLengthsOfTheDirection) {
    for (const double length : {1e-200, 1e-3, 0.3, 7.0, 1e200}) {
        RaySettings settings;
        settings.t_max = 2.5 / length;
        const RayHits hits = cast(Sphere(), {{{-3, 0, 0}, {length, 0, 0}}}, settings);
        ASSERT_EQ(hits.status[0], RayStatus::hit) << length;
        EXPECT_NEAR(hits.t[0] * length, 2.0, 1e-8);
        EXPECT_NEAR(glm::distance(hits.normal[0], {-1, 0, 0}), 0.0, 1e-8);
        settings.t_max = 1.9 / length;
        EXPECT_EQ(cast(Sphere(), {{{-3, 0, 0}, {length, 0, 0}}}, settings).status[0], RayStatus::miss) << length;
    }
}

TEST(CastRays, DistantOriginsStillHitTheSurface) {
    const RayHits hits = cast(Sphere(), {{{-1e9, 0, 0.5}, {1, 0, 0}}, {{-1e300, 0, 0}, {1, 0, 0}}});
    EXPECT_NEAR(glm::length(hits.position[0]), 1.0, 1e-8);
    EXPECT_NEAR(hits.t[0], 1e9 - std::sqrt(0.75), 1e-6);
    EXPECT_NE(hits.status[1], RayStatus::not_finite);
    // f is never evaluated outside the region, although coordinates are rounded to multiples of 1 or 2 here.
    const AnyField bounded(cube(1.0), [](const glm::dvec3& p) -> Field {
        const glm::dvec3 q = glm::abs(p);
        return {std::max({q.x, q.y, q.z}) < 1.174 ? glm::length(p) - 1.0 : std::nan(""), p / glm::length(p), {}};
    });
    std::vector<Line> lines;
    for (int i = 0; i < 300; ++i) {
        const auto [x, y, z] = spiral_point(i, 300);
        lines.push_back({1e16 * glm::dvec3(x, y, z), -glm::dvec3(x, y, z)});
    }
    const RayHits far = cast(bounded, lines, at_most(2));
    for (int i = 0; i < 300; ++i) EXPECT_NE(far.status[i], RayStatus::not_finite) << i;
}

TEST(CastRays, NonFiniteValuesEndARay) {
    const AnyField broken(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {p.x > 0.5 ? std::nan("") : p.x + 0.5, {1.0, 0.0, 0.0}, {}};
    });
    const RayHits hits =
        cast(broken, {{{-3, 0, 0}, {1, 0, 0}}, {{3, 0, 0}, {-1, 0, 0}}, {{0, -3, 0}, {0, 1, 0}}}, at_most(2));
    EXPECT_EQ(hits.status[0], RayStatus::not_finite);
    EXPECT_EQ(hits.count[0], 1) << "what was found before is kept";
    EXPECT_NEAR(hits.t[0], 2.5, 1e-8);
    EXPECT_EQ(hits.status[1], RayStatus::not_finite);
    EXPECT_EQ(hits.count[1], 0);
    EXPECT_EQ(hits.status[2], RayStatus::miss);
    const AnyField no_gradient(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {p.x, {std::nan(""), 0.0, 0.0}, {}};
    });
    EXPECT_EQ(cast(no_gradient, {{{-3, 0, 0}, {1, 0, 0}}}).status[0], RayStatus::not_finite);
}

// Newton's steps alone would run away or circle on these functions.
TEST(CastRays, BisectionHelpsWhereNewtonDoesNot) {
    const AnyField jump(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {p.x < 0.3 ? 1.0 : -1.0, {0.0, 0.0, 1.0}, {}}; // no root and no slope, but a sign change
    });
    const AnyField cube_root(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {std::cbrt(p.x - 0.3), {std::pow(std::abs(p.x - 0.3), -2.0 / 3.0) / 3.0, 0.0, 0.0}, {}};
    });
    const AnyField flat(cube(1.0), [](const glm::dvec3& p) -> Field {
        const double x = p.x - 0.3;
        return {x * x * x, {3.0 * x * x, 0.0, 0.0}, {}};
    });
    const AnyField circling(cube(1.0), [](const glm::dvec3& p) -> Field { // from 0.3 + x Newton's step goes to 0.3 - x
        const double root = std::sqrt(std::abs(p.x - 0.3));
        return {p.x < 0.3 ? -root : root, {0.5 / root, 0.0, 0.0}, {}};
    });
    const AnyField lying(cube(1.0), [](const glm::dvec3& p) -> Field { // the slope points away from the root
        return {p.x < 0.3 ? 1.0 : -1.0, {1e12, 0.0, 0.0}, {}};
    });
    const std::array<const implicit::Implicit*, 5> fields = {&jump, &cube_root, &flat, &circling, &lying};
    for (const implicit::Implicit* f : fields) {
        const RayHits hits = cast(*f, {{{-3.0, 0.2, 0.1}, {1, 0, 0}}, {{3.0, 0.2, 0.1}, {-1, 0, 0}}});
        EXPECT_EQ(hits.status[0], RayStatus::hit);
        EXPECT_NEAR(hits.t[0], 3.3, 1e-8);
        EXPECT_EQ(hits.status[1], RayStatus::hit);
        EXPECT_NEAR(hits.t[1], 2.7, 1e-8);
    }
}

TEST(CastRays, PartsThinnerThanTheSmallestStepMayBeMissed) {
    const ThinSlab slab(1e-3); // two faces 2e-3 apart
    const double diagonal = slab.diagonal();
    RaySettings settings = at_most(4);
    EXPECT_EQ(cast(slab, {{{0, 0, -1}, {0, 0, 1}}}, settings).count[0], 2);
    settings.smallest_step = 0.5e-3 / diagonal;
    EXPECT_EQ(cast(slab, {{{0, 0, -1}, {0, 0, 1}}}, settings).count[0], 2);
    settings.smallest_step = 0.05; // longer than the slab: only an end of the search is guaranteed
    EXPECT_NE(cast(slab, {{{0, 0, -1}, {0, 0, 1}}}, settings).status[0], RayStatus::not_finite);
}

TEST(CastRays, EvaluationLimitKeepsHits) {
    const Sphere sphere;
    RaySettings settings = at_most(2);
    settings.lipschitz = 1.0;
    for (const int limit : {1, 2, 4}) {
        settings.evaluation_limit = limit;
        sphere.evaluations = 0;
        const RayHits hits = cast(sphere, {{{-3, 0, 0.3}, {1, 0, 0}}}, settings);
        EXPECT_EQ(hits.status[0], RayStatus::evaluation_limit);
        EXPECT_EQ(sphere.evaluations, limit);
    }
    settings.evaluation_limit = 1000;
    sphere.evaluations = 0;
    EXPECT_EQ(cast(sphere, {{{-3, 0, 0.3}, {1, 0, 0}}}, settings).count[0], 2);
    EXPECT_LT(sphere.evaluations, 60);
}

TEST(CastRays, ALargerBoundNeedsMoreEvaluations) {
    const Sphere sphere;
    RaySettings settings;
    std::int64_t before = 0;
    for (const double bound : {1.0, 4.0, 16.0}) {
        settings.lipschitz = bound;
        sphere.evaluations = 0;
        EXPECT_NEAR(cast(sphere, {{{-3, 0, 0.3}, {1, 0, 0}}}, settings).t[0], 3.0 - std::sqrt(0.91), 1e-8);
        EXPECT_GT(sphere.evaluations, before);
        before = sphere.evaluations;
    }
}

TEST(CastRays, ToleranceIsMeasuredInDiagonals) {
    RaySettings settings;
    settings.tolerance = 1e-2;
    settings.smallest_step = 0.1;
    const std::vector<Line> line = {{{-3, 0, 0.3}, {1, 0, 0}}};
    const double wanted = 3.0 - std::sqrt(0.91);
    EXPECT_NEAR(cast(SquareSphere(), line, settings).t[0], wanted, 1e-2 * std::sqrt(12.0));
    settings.tolerance = 1e-15;
    EXPECT_NEAR(cast(SquareSphere(), line, settings).t[0], wanted, 1e-14);
}

TEST(CastRays, RaysDoNotDependOnEachOther) {
    const Torus torus;
    const std::vector<Line> lines = many_lines(700);
    const RayHits hits = cast(torus, lines, at_most(2));
    for (std::size_t k = 0; k < lines.size(); k += 37) {
        const auto i = static_cast<std::int64_t>(k);
        const RayHits alone = cast(torus, {lines[k]}, at_most(2));
        EXPECT_EQ(alone.count[0], hits.count[i]);
        EXPECT_EQ(alone.t[0], hits.t[2 * i]);
        EXPECT_EQ(alone.t[1], hits.t[2 * i + 1]);
    }
}

TEST(CastRays, AcceptsNoRays) {
    const Sphere sphere;
    EXPECT_EQ(cast(sphere, {}, at_most(3)).t.size(), 0);
    EXPECT_EQ(sphere.evaluations, 0);
}

} // namespace
} // namespace hrbfnpr::surface::cast_rays_test
