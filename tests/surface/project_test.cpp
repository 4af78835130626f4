// SPDX-License-Identifier: MIT
#include "surface/project.h"

#include "support/analytic.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

namespace hrbfnpr::surface::project_test {
namespace {

using namespace test;

base::Runtime& runtime() {
    static base::Runtime instance;
    return instance;
}

Projection run(const implicit::Implicit& implicit, std::initializer_list<glm::dvec3> points,
               const ProjectionSettings& settings = {}) {
    Projection projection(runtime().memory);
    for (const glm::dvec3& p : points) projection.position.push_back(p);
    project(runtime(), implicit, settings, projection);
    return projection;
}

glm::dvec3 pseudo_random(int i) {
    return {std::sin(12.9898 * i), std::sin(78.233 * i + 1.0), std::sin(37.719 * i + 2.0)};
}

TEST(Project, ReachesTheNearestPointOfASphereInOneStep) {
    const Sphere sphere(2.0);
    const Projection p = run(sphere, {{5.0, 0.0, 0.0}, {0.0, -0.3, 0.0}});
    EXPECT_EQ(p.status[0], ProjectionStatus::converged);
    EXPECT_NEAR(glm::distance(p.position[0], {2.0, 0.0, 0.0}), 0.0, 1e-14);
    EXPECT_NEAR(glm::distance(p.position[1], {0.0, -2.0, 0.0}), 0.0, 1e-14);
    EXPECT_NEAR(glm::distance(p.gradient[0], {1.0, 0.0, 0.0}), 0.0, 1e-14);
    EXPECT_EQ(sphere.evaluations, 4) << "one evaluation at the start and one at the end";
}

TEST(Project, ConvergesOnFunctionsThatAreNoDistance) {
    const SquareSphere sphere(1.0);
    Projection p(runtime().memory);
    constexpr int count = 1000; // more than a batch, and not a multiple of it
    for (int i = 0; i < count; ++i) p.position.push_back(3.0 * pseudo_random(i + 1));
    project(runtime(), sphere, {}, p);
    for (int i = 0; i < count; ++i) {
        ASSERT_EQ(p.status[i], ProjectionStatus::converged) << i;
        EXPECT_NEAR(glm::length(p.position[i]), 1.0, 1e-8);
        EXPECT_NEAR(glm::distance(p.gradient[i], 2.0 * p.position[i]), 0.0, 1e-15);
    }
}

TEST(Project, APointOnTheSurfaceStaysBitForBit) {
    const glm::dvec3 on(0.6, 0.8, 0.0);
    const Projection p = run(SquareSphere(1.0), {on});
    EXPECT_EQ(p.position[0], on);
    EXPECT_EQ(p.gradient[0], 2.0 * on);
}

TEST(Project, PointsDoNotDependOnEachOther) {
    const Torus torus;
    Projection many(runtime().memory);
    for (int i = 0; i < 700; ++i) many.position.push_back(1.5 * pseudo_random(i));
    geometry::VecArray starts(runtime().memory);
    for (int i = 0; i < 700; ++i) starts.push_back(many.position[i]);
    project(runtime(), torus, {}, many);
    for (int i = 0; i < 700; i += 37) {
        const Projection alone = run(torus, {starts[i]});
        EXPECT_EQ(alone.position[0], many.position[i]);
        EXPECT_EQ(alone.gradient[0], many.gradient[i]);
        EXPECT_EQ(alone.status[0], many.status[i]);
    }
}

// f^2 has a minimum that is not 0. Steepest descent must stop there and report it.
TEST(Project, ReportsCriticalPointsAndLocalMinima) {
    const AnyField bowl(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {glm::dot(p, p) + 0.5, 2.0 * p, identity(2.0)};
    });
    const Projection p = run(bowl, {{0.0, 0.0, 0.0}, {0.3, 0.2, 0.1}});
    EXPECT_EQ(p.status[0], ProjectionStatus::zero_gradient);
    EXPECT_NE(p.status[1], ProjectionStatus::converged);
    EXPECT_LT(glm::length(p.position[1]), 0.1) << "the last iterate is kept, and f^2 fell";
}

TEST(Project, ReportsNonFinitePoints) {
    const AnyField broken(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {p.x > 0.0 ? std::nan("") : p.x + 0.5, {1.0, 0.0, 0.0}, {}};
    });
    const Projection p = run(broken, {{0.5, 0.0, 0.0}, {-0.7, 0.0, 0.0}, {std::nan(""), 0.0, 0.0}});
    EXPECT_EQ(p.status[0], ProjectionStatus::not_finite);
    EXPECT_EQ(p.status[1], ProjectionStatus::converged);
    EXPECT_EQ(p.status[2], ProjectionStatus::not_finite);
}

// The computed length of such a gradient is infinite, so the distance f / |grad f| would be 0.
TEST(Project, AGradientTooLargeToSquareIsRejected) {
    const AnyField steep(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {1e200 * (p.x - 0.5), {1e200, 0.0, 0.0}, {}};
    });
    EXPECT_NE(run(steep, {{0.9, 0.0, 0.0}}).status[0], ProjectionStatus::converged);
}

// A trial step to a point where f is not finite does not lower f^2, so the step is halved.
TEST(Project, BacktracksFromNonFiniteValues) {
    // f = sqrt(x) - 2 is zero at 4. Newton's step from 20 ends at x < 0.
    const AnyField root(cube(10.0), [](const glm::dvec3& p) -> Field {
        return {std::sqrt(p.x) - 2.0, {0.5 / std::sqrt(p.x), 0.0, 0.0}, {}};
    });
    const Projection p = run(root, {{20.0, 0.0, 0.0}});
    EXPECT_EQ(p.status[0], ProjectionStatus::converged);
    EXPECT_NEAR(p.position[0].x, 4.0, 1e-6);
}

// On arctan full Newton steps overshoot and diverge. Armijo's rule makes them converge.
TEST(Project, ArmijoTamesNewtonSteps) {
    const AnyField arctan(cube(5.0), [](const glm::dvec3& p) -> Field {
        return {std::atan(p.x), {1.0 / (1.0 + p.x * p.x), 0.0, 0.0}, {}};
    });
    const Projection p = run(arctan, {{4.0, 0.0, 0.0}});
    EXPECT_EQ(p.status[0], ProjectionStatus::converged);
    EXPECT_NEAR(p.position[0].x, 0.0, 1e-7);
}

// With sigma near 1/2, only steps that lower f^2 almost to zero are accepted: for f = x^2 - 1 the Newton step from 2 to
// 1.25 lowers f^2 = 9 to 0.316, which is 3.5 % of it.
TEST(Project, ArmijoSlopeFollowsTheRule) {
    const AnyField parabola(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {p.x * p.x - 1.0, {2.0 * p.x, 0.0, 0.0}, {}};
    });
    ProjectionSettings settings;
    settings.evaluation_limit = 2;
    settings.armijo_slope = 0.48; // requires f^2 <= 4 %: accepted
    EXPECT_NEAR(run(parabola, {{2.0, 0.0, 0.0}}, settings).position[0].x, 1.25, 1e-14);
    settings.armijo_slope = 0.49; // requires f^2 <= 2 %: rejected
    EXPECT_NEAR(run(parabola, {{2.0, 0.0, 0.0}}, settings).position[0].x, 2.0, 1e-14);
    settings.evaluation_limit = 3; // half the step, to 1.625: f^2 = 2.69 is 30 %, and 51 % are enough
    EXPECT_NEAR(run(parabola, {{2.0, 0.0, 0.0}}, settings).position[0].x, 1.625, 1e-14);
    settings.armijo_factor = 0.25;
    EXPECT_NEAR(run(parabola, {{2.0, 0.0, 0.0}}, settings).position[0].x, 1.8125, 1e-14);
}

TEST(Project, EvaluationLimitIsKept) {
    const SquareSphere sphere(1.0);
    ProjectionSettings settings;
    for (const int limit : {1, 2, 5}) {
        settings.evaluation_limit = limit;
        sphere.evaluations = 0;
        const Projection p = run(sphere, {{100.0, 0.0, 0.0}}, settings);
        EXPECT_EQ(p.status[0], ProjectionStatus::not_converged);
        EXPECT_EQ(sphere.evaluations, limit);
    }
}

TEST(Project, ToleranceIsMeasuredInDiagonals) {
    const double diagonal = std::sqrt(12.0);
    const Plane plane({0.0, 0.0, 2.0}, 0.0, cube(1.0));
    ProjectionSettings settings;
    settings.tolerance = 0.01;
    EXPECT_EQ(run(plane, {{0.0, 0.0, 0.0099 * diagonal}}, settings).position[0].z, 0.0099 * diagonal);
    EXPECT_NEAR(run(plane, {{0.0, 0.0, 0.0101 * diagonal}}, settings).position[0].z, 0.0, 1e-15);
}

TEST(Project, AcceptsNoPoints) {
    const Projection p = run(Sphere(), {});
    EXPECT_EQ(p.status.size(), 0);
}

} // namespace
} // namespace hrbfnpr::surface::project_test
