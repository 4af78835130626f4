// SPDX-License-Identifier: MIT
// Tests projection and rays where a surface has creases.
#include "support/runtime.h"
#include "support/sharp_shapes.h"
#include "surface/cast_rays.h"
#include "surface/curvature.h"
#include "surface/project.h"
#include "surface/region.h"
#include "surface/sheets_meet.h"

#include <gtest/gtest.h>

namespace hrbfnpr::surface::creases_test {
namespace {

using namespace test;

base::Runtime& runtime() {
    static base::Runtime instance = with_threads(2);
    return instance;
}

glm::dvec3 pseudo_random(int i) {
    return {std::sin(12.9898 * i), std::sin(78.233 * i + 1.0), std::sin(37.719 * i + 2.0)};
}

// Two half-spaces that meet in the z axis, with this angle between their sides.
std::unique_ptr<SharpShape> wedge(double angle, bool convex) {
    const double half = 0.5 * angle;
    std::vector<Sharp> both{plane({-std::sin(half), std::cos(half), 0.0}, 0.0),
                            plane({-std::sin(half), -std::cos(half), 0.0}, 0.0)};
    return std::make_unique<SharpShape>(cube(1.0), convex ? max_of(std::move(both)) : min_of(std::move(both)));
}

int not_converged(const implicit::Implicit& shape, double reach, double worst_share = 1e9) {
    Projection p(runtime().memory);
    constexpr int count = 3000;
    for (int i = 0; i < count; ++i) p.position.push_back(reach * pseudo_random(i + 1));
    geometry::VecArray from(runtime().memory);
    for (int i = 0; i < count; ++i) from.push_back(p.position[i]);
    project(runtime(), shape, {}, p);
    int left = 0;
    for (int i = 0; i < count; ++i) {
        if (p.status[i] != ProjectionStatus::converged) {
            ++left;
            continue;
        }
        double value = 0.0;
        const glm::dvec3 at = p.position[i];
        shape.evaluate({&at.x, &at.y, &at.z, 1}, {&value, {}, {}});
        EXPECT_LE(std::abs(value), 2e-9 * shape.diagonal()) << i;
        EXPECT_LE(glm::distance(at, from[i]), worst_share * shape.diagonal()) << i;
    }
    return left;
}

TEST(ProjectAtCreases, ReachesEveryShapeFromEverywhere) {
    EXPECT_EQ(not_converged(*sharp_cube(), 2.0, 1.0), 0);
    EXPECT_EQ(not_converged(*bored_cube(), 2.0, 1.0), 0);
    EXPECT_EQ(not_converged(*stepped_shaft(), 1.5, 1.0), 0);
    EXPECT_EQ(not_converged(*two_balls(true), 1.6, 1.0), 0);
    EXPECT_EQ(not_converged(*two_balls(false), 1.6, 1.0), 0);
    EXPECT_EQ(not_converged(*capped_cone(), 1.3, 1.0), 0);
    EXPECT_EQ(not_converged(*fading_wedge(), 1.3, 1.0), 0);
}

// Descent alone zigzags: between two sides at 3 degrees it takes a thousand steps.
TEST(ProjectAtCreases, ReachesAcuteEdges) {
    for (const double angle : {0.05, 0.2, 0.5, 1.0})
        for (const bool convex : {true, false}) EXPECT_EQ(not_converged(*wedge(angle, convex), 1.0), 0) << angle;
}

// The balls do not meet, so |f| of their intersection has a minimum between them that is not 0.
Sharp no_intersection() { return max_of({sphere({-1.0, 0.0, 0.0}, 0.6), sphere({1.0, 0.0, 0.0}, 0.6)}); }

TEST(ProjectBySearch, EscapesALocalMinimumOfF) {
    const SharpShape shape(cube(4.0), min_of({no_intersection(), sphere({0.0, 3.0, 0.0}, 0.7)}));
    EXPECT_EQ(not_converged(shape, 3.0), 0);
    Projection p(runtime().memory);
    p.position.push_back({0.01, 0.02, -0.01});
    project(runtime(), shape, {}, p);
    ASSERT_EQ(p.status[0], ProjectionStatus::converged);
    EXPECT_NEAR(glm::distance(p.position[0], {0.0, 3.0, 0.0}), 0.7, 1e-7);
    const glm::dvec3 normal = (p.position[0] - glm::dvec3(0.0, 3.0, 0.0)) / 0.7;
    EXPECT_LE(glm::distance(p.gradient[0], normal), 1e-6);
}

TEST(ProjectBySearch, ReportsThatThereIsNoSurface) {
    const SharpShape shape(cube(2.0), no_intersection());
    EXPECT_EQ(not_converged(shape, 2.0), 3000);
    Projection p(runtime().memory);
    p.position.push_back({0.3, 0.4, 0.0});
    project(runtime(), shape, {}, p);
    EXPECT_EQ(p.status[0], ProjectionStatus::not_converged);
    EXPECT_LE(std::abs(p.position[0].x), 1.5) << "the last iterate of descent stays";
}

// The second sphere is outside the search region, so it does not count.
TEST(ProjectBySearch, StaysInTheSearchRegion) {
    const SharpShape shape(cube(2.0), min_of({no_intersection(), sphere({0.0, 3.4, 0.0}, 0.7)}));
    EXPECT_EQ(not_converged(shape, 0.1), 3000);
}

TEST(ProjectAtCreases, FindsWhereSheetsMeet) {
    const auto shape = sharp_cube();
    const glm::dvec3 corner = glm::transpose(odd_turn()) * glm::dvec3(1.0);
    Meeting three;
    for (const std::int32_t sheet : {0, 2, 4}) three.add(sheet);
    const MeetingPlace at = find_meeting(*shape, {three, corner + glm::dvec3(0.1, -0.05, 0.07), 1.0}, 1e-12);
    ASSERT_TRUE(at.found);
    EXPECT_LE(glm::distance(at.position, corner), 1e-12);
    EXPECT_NEAR(glm::dot(at.gradient[0], at.gradient[1]), 0.0, 1e-12);
    Meeting opposite; // the cube's sides 0 and 1 are parallel
    opposite.add(0);
    opposite.add(1);
    EXPECT_FALSE(find_meeting(*shape, {opposite, corner, 10.0}, 1e-12).found);
    Meeting many;
    for (const std::int32_t sheet : {0, 2, 4, 5}) many.add(sheet);
    EXPECT_FALSE(many.has(0));
    EXPECT_TRUE(many.has(5));
}

// Rays pass an edge of the cube at a small distance on either side, and the normals of hits are checked.
TEST(RaysAtCreases, HitNextToEdges) {
    const glm::dmat3 back = glm::transpose(odd_turn());
    const auto shape = sharp_cube();
    for (const double beside : {1e-3, 1e-5, 1e-7}) {
        Rays rays(runtime().memory);
        for (int i = 0; i < 40; ++i)
            for (const double sign : {-1.0, 1.0}) {
                // The rays run along x - z over the edge x = z = 1.
                const double y = -0.95 + 0.045 * i;
                rays.origin.push_back(back * (glm::dvec3(1.0, y, 1.0) +
                                              (sign * beside) * glm::normalize(glm::dvec3(1.0, 0.0, 1.0)) +
                                              glm::dvec3(2.0, 0.0, -2.0)));
                rays.direction.push_back(back * glm::dvec3(-1.0, 0.0, 1.0));
            }
        RayHits hits(runtime().memory);
        RaySettings settings;
        settings.maximum_hits = 2;
        settings.smallest_step = 1e-8;
        settings.evaluation_limit = 1000000;
        cast_rays(runtime(), *shape, settings, rays, hits);
        for (std::int64_t i = 0; i < rays.origin.size(); ++i) {
            ASSERT_EQ(hits.count[i], i % 2 == 0 ? 2 : 0) << beside << ' ' << i;
            if (i % 2 != 0) continue;
            EXPECT_LE(glm::distance(hits.normal[2 * i], back * glm::dvec3(1.0, 0.0, 0.0)), 1e-9);
            EXPECT_LE(glm::distance(hits.normal[2 * i + 1], back * glm::dvec3(0.0, 0.0, 1.0)), 1e-9);
            EXPECT_NEAR(glm::distance(hits.position[2 * i], hits.position[2 * i + 1]), 2.0 * beside, 1e-8);
        }
    }
}

TEST(RaysAtCreases, InsideAndCurvatureUseTheActiveSheet) {
    const auto shape = stepped_shaft();
    geometry::VecArray points(runtime().memory);
    for (const glm::dvec3& p : {glm::dvec3(0.9999999, 0.0, -0.0000001), glm::dvec3(1.0000001, 0.0, -0.5),
                                glm::dvec3(0.5000001, 0.0, 0.0000001), glm::dvec3(0.4999999, 0.0, 0.5)})
        points.push_back(p);
    base::Array<std::uint8_t> inside(runtime().memory);
    contains(runtime(), *shape, points, inside);
    for (std::int64_t i = 0; i < 4; ++i) EXPECT_EQ(inside[i], i % 3 == 0 ? 1 : 0) << i;
    geometry::VecArray on(runtime().memory);
    on.push_back({0.5, 0.0, 1e-6});   // on the thin cylinder, beside the ring
    on.push_back({0.500001, 0.0, 0}); // on the ring, beside the cylinder
    base::Array<Curvature> curvature(runtime().memory);
    principal_curvatures(runtime(), *shape, on, curvature);
    EXPECT_NEAR(curvature[0].k2, -2.0, 1e-9);
    EXPECT_NEAR(curvature[0].k1, 0.0, 1e-9);
    EXPECT_NEAR(curvature[1].k1, 0.0, 1e-9);
    EXPECT_NEAR(curvature[1].k2, 0.0, 1e-9);
}

} // namespace
} // namespace hrbfnpr::surface::creases_test
