// SPDX-License-Identifier: MIT
// Strokes along the caller's directions.
#include "support/point_sets.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::strokes::field_test {
namespace {

using namespace marks;
using namespace test;

// What a field says at a place, and what became of its calls.
struct Caller {
    glm::dvec3 (*direction)(const glm::dvec3& p, const glm::dvec3& n) = nullptr;
    std::int64_t calls = 0;
    std::int64_t most = 0;
    double farthest = 0.0;
    std::int32_t result = 0;

    static std::int32_t call(void* user, std::int64_t count, const double* positions, const double* normals,
                             double* directions) {
        auto& self = *static_cast<Caller*>(user);
        ++self.calls;
        self.most = std::max(self.most, count);
        for (std::int64_t i = 0; i < count; ++i) {
            const glm::dvec3 p(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
            const glm::dvec3 n(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
            EXPECT_NEAR(glm::length(n), 1.0, 1e-9);
            self.farthest = std::max(self.farthest, glm::length(p));
            const glm::dvec3 d = self.direction(p, n);
            for (int k = 0; k < 3; ++k) directions[3 * i + k] = d[k];
        }
        return self.result;
    }
};

generate::Settings along(Caller& caller, std::int64_t budget, Symmetry symmetry = Symmetry::line) {
    generate::Settings settings = blue({Kind::field}, budget);
    settings.layers[0].strokes.symmetry = symmetry;
    settings.layers[0].strokes.direction = {Caller::call, &caller};
    return settings;
}

// A helix about z, at 30 degrees: no principal direction of anything here.
glm::dvec3 helix(const glm::dvec3& p, const glm::dvec3& n) {
    const glm::dvec3 around = glm::normalize(glm::dvec3(-p.y, p.x, 0.0));
    const glm::dvec3 across = glm::cross(n, around);
    return 17.0 * (std::cos(0.5236) * around + std::sin(0.5236) * across) + 5.0 * n; // not tangent, not unit
}

double degrees_between_lines(const glm::dvec3& a, const glm::dvec3& b) {
    return 57.29577951308232 * std::acos(std::min(1.0, std::abs(glm::dot(a, b))));
}

// How far strokes and what they say of their directions are off the field, where it is smooth.
template <class Where>
void expect_follows(const PointSet& set, const Caller& caller, double most, Where where) {
    const Layer& marks = set.layers[0];
    std::array<double, 2> sum{};
    std::array<std::int64_t, 2> legs{};
    double worst = 0.0;
    std::int64_t others = 0;
    for (std::int64_t s = 0; s < marks.strokes(); ++s)
        for (std::int64_t i = marks.stroke_first[s]; i + 1 < marks.stroke_first[s + 1]; ++i) {
            const glm::dvec3 a = position(set, marks, i);
            const glm::dvec3 b = position(set, marks, i + 1);
            if (!where(a) || !where(b)) continue;
            const glm::dvec3 middle = 0.5 * (a + b);
            const glm::dvec3 n = glm::normalize(vec(marks.normal, i) + vec(marks.normal, i + 1));
            const std::uint32_t direction = marks.direction_of(i);
            const auto off = [&](const glm::dvec3& along, const glm::dvec3& p, const glm::dvec3& normal) {
                const glm::dvec3 d = caller.direction(p, normal);
                const glm::dvec3 first = glm::normalize(d - glm::dot(d, normal) * normal);
                return degrees_between_lines(along, direction == 0 ? first : glm::cross(normal, first));
            };
            ++legs[direction];
            double leg = off(glm::normalize(b - a), middle, n);
            double own = off(vec(marks.direction, i), a, vec(marks.normal, i));
            if (leg > 45.0) { // of a cross's stroke, which is the other direction's for most of its length
                ++others;
                leg = 90.0 - leg;
                own = 90.0 - own;
            }
            sum[direction] += leg;
            worst = std::max(worst, leg);
            EXPECT_LT(own, 0.1);
        }
    for (const std::size_t d : {0U, 1U}) {
        ASSERT_GT(legs[d], marks.count() / 5);
        EXPECT_LT(sum[d] / static_cast<double>(legs[d]), most) << d;
    }
    EXPECT_LT(worst, 6.0 * most);
    EXPECT_LE(others, marks.count() / 1000);
}

TEST(Field, StrokesFollowIt) {
    const Torus torus;
    const Sphere sphere;
    for (const Symmetry symmetry : {Symmetry::line, Symmetry::cross}) {
        Caller caller{helix};
        const PointSet ring = make(torus, along(caller, 20000, symmetry));
        expect_sound(ring, torus);
        expect_follows(ring, caller, 0.25, [](const glm::dvec3&) { return true; });
        EXPECT_GT(ring.layers[0].count(), 18000);
        EXPECT_LE(caller.most, 4096);
        const PointSet ball = make(sphere, along(caller, 20000, symmetry));
        expect_sound(ball, sphere);
        // The poles are singular.
        expect_follows(ball, caller, 0.25, [](const glm::dvec3& p) { return std::abs(p.z) < 0.9; });
        EXPECT_GT(ball.layers[0].count(), 17000);
    }
}

TEST(Field, WithoutDirectionsItIsSmooth) {
    const Torus torus;
    Caller caller{[](const glm::dvec3& p, const glm::dvec3& n) { return p.x > 0.3 ? glm::dvec3(0.0) : helix(p, n); }};
    const PointSet set = make(torus, along(caller, 8000));
    expect_sound(set, torus);
    std::int64_t without = 0;
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i) without += position(set, set.layers[0], i).x > 0.3;
    EXPECT_GT(without, 1500) << "the strokes go on through what the field leaves out";
    Caller nowhere{[](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(0.0); }};
    expect_sound(make(torus, along(nowhere, 2000)), torus);
    Caller normal{[](const glm::dvec3&, const glm::dvec3& n) { return 1e300 * n; }};
    expect_sound(make(torus, along(normal, 2000)), torus);
}

TEST(Field, IsAskedAtAbsolutePlaces) {
    for (const double scale : {1.0, 1e15}) {
        const AnyField large(cube(scale), [scale](const glm::dvec3& p) -> Field {
            const glm::dvec3 q = p / scale;
            return {glm::dot(q, q) - 0.5, 2.0 / scale * q, identity(2.0 / scale / scale)};
        });
        Caller caller{helix};
        const PointSet set = make(large, along(caller, 2000));
        EXPECT_GT(set.layers[0].count(), 1000);
        EXPECT_NEAR(caller.farthest, scale * std::sqrt(0.5), 0.01 * scale);
    }
}

TEST(Field, PublishedStrokesFollowItToo) {
    const Sphere sphere;
    Caller caller{helix};
    generate::Settings settings = recursion({Kind::field}, 3);
    settings.layers[0].strokes.direction = {Caller::call, &caller};
    const std::vector<double> seeds = spiral_seeds(64);
    use_points(settings, seeds);
    settings.seeds.initial_step = 0.05;
    const PointSet set = make(sphere, settings);
    expect_sound(set, sphere);
    EXPECT_EQ(set.layers[0].count(), 64 * 2 * 27);
    EXPECT_EQ(set.layers[0].strokes(), 128);
    const Layer& marks = set.layers[0];
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        const glm::dvec3 p = position(set, marks, i);
        if (std::abs(p.z) > 0.9) continue;
        const glm::dvec3 n = vec(marks.normal, i);
        const glm::dvec3 d = helix(p, n);
        glm::dvec3 exact = glm::normalize(d - glm::dot(d, n) * n);
        if (marks.direction_of(i) == 1) exact = glm::cross(n, exact);
        EXPECT_LT(degrees_between_lines(vec(marks.direction, i), exact), 0.1) << i;
    }
    Caller nowhere{[](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(0.0); }};
    settings.layers[0].strokes.direction = {Caller::call, &nowhere};
    expect_sound(make(sphere, settings), sphere);
}

TEST(Field, ThatFailsIsReported) {
    const Torus torus;
    for (const Distribution distribution : {Distribution::blue_noise, Distribution::published}) {
        Caller fails{helix};
        fails.result = 3;
        generate::Settings settings = along(fails, 1000);
        settings.distribution = distribution;
        expect_error(Status::callback, {"direction_function returned 3"}, [&] { (void)make(torus, settings); });
        EXPECT_EQ(fails.calls, 1);
        Caller nan{[](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(1.0, std::nan(""), 0.0); }};
        settings.layers[0].strokes.direction = {Caller::call, &nan};
        expect_error(Status::callback, {"direction_function gave 1 nan 0"}, [&] { (void)make(torus, settings); });
    }
}

} // namespace
} // namespace hrbfnpr::strokes::field_test
