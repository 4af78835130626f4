// SPDX-License-Identifier: MIT
// Tests lines along the caller's directions.
#include "support/caller_directions.h"
#include "support/point_sets.h"

namespace hrbfnpr::hatching::function_test {
namespace {

using namespace marks;
using namespace test;

generate::Settings along(Caller& caller, std::int64_t budget) {
    generate::Settings settings = blue({Kind::hatch}, budget);
    settings.layers[0].hatching.direction = caller.function();
    return settings;
}

// Lines are evened out where a field spreads, so they deviate from it by a few degrees.
template <class Where>
void expect_follows(const PointSet& set, Where where) {
    const Layer& marks = set.layers[0];
    double sum = 0.0;
    std::int64_t looked_at = 0;
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        const glm::dvec3 p = position(set, marks, i);
        if (!where(p)) continue;
        const double off = degrees_off_helix(vec(marks.direction, i), p, vec(marks.normal, i));
        EXPECT_LT(off, 30.0) << i;
        sum += off;
        ++looked_at;
    }
    ASSERT_GT(looked_at, marks.count() / 2);
    EXPECT_LT(sum / static_cast<double>(looked_at), 5.0);
}

TEST(DirectionFunction, IsFollowedByTheLines) {
    const Torus torus;
    const Sphere sphere;
    Caller caller{helix};
    const PointSet ring = make(torus, along(caller, 10000));
    expect_sound(ring, torus);
    expect_follows(ring, [](const glm::dvec3&) { return true; });
    EXPECT_LE(caller.most, 4096);
    const PointSet ball = make(sphere, along(caller, 10000));
    expect_sound(ball, sphere);
    expect_follows(ball, [](const glm::dvec3& p) { return std::abs(p.z) < 0.8; }); // the poles are singular
}

TEST(DirectionFunction, WithoutDirectionsLinesAreSmooth) {
    const Torus torus;
    Caller caller{[](const glm::dvec3& p, const glm::dvec3& n) { return p.x > 0.3 ? glm::dvec3(0.0) : helix(p, n); }};
    const PointSet set = make(torus, along(caller, 8000));
    expect_sound(set, torus);
    std::int64_t without = 0;
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i) without += position(set, set.layers[0], i).x > 0.3;
    EXPECT_GT(without, 1500) << "lines go on through what the function leaves out";
    Caller nowhere{no_direction};
    expect_sound(make(torus, along(nowhere, 2000)), torus);
    Caller normal{[](const glm::dvec3&, const glm::dvec3& n) { return 1e300 * n; }};
    expect_sound(make(torus, along(normal, 2000)), torus);
}

TEST(DirectionFunction, IsCalledWithAbsolutePositions) {
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

} // namespace
} // namespace hrbfnpr::hatching::function_test
