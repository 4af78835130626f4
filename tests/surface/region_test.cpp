// SPDX-License-Identifier: MIT
#include "surface/region.h"

#include "support/analytic.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

namespace hrbfnpr::surface::region_test {
namespace {

using namespace test;

base::Runtime& runtime() {
    static base::Runtime instance;
    return instance;
}

base::Array<std::uint8_t> inside_of(const implicit::Implicit& implicit, std::initializer_list<glm::dvec3> points) {
    geometry::VecArray array(runtime().memory);
    for (const glm::dvec3& p : points) array.push_back(p);
    base::Array<std::uint8_t> inside(runtime().memory);
    contains(runtime(), implicit, array, inside);
    return inside;
}

TEST(Region, IsTheBoxAndATwentiethOfItsDiagonal) {
    const Sphere sphere(2.0, {1.0, 0.0, 0.0});
    const geometry::Bounds region = search_region(sphere);
    EXPECT_NEAR(region.min.x, -1.0 - 0.05 * std::sqrt(48.0), 1e-14);
    EXPECT_NEAR(region.max.y, 2.0 + 0.05 * std::sqrt(48.0), 1e-14);
}

// The estimate is the slope at the steepest corner, times 1.5.
TEST(LipschitzEstimate, IsTheSteepestSlopeOnAGrid) {
    EXPECT_NEAR(lipschitz_estimate(runtime(), Plane({3.0, 0.0, 4.0}, 0.0, cube(1.0))), 7.5, 1e-14);
    const SquareSphere sphere(1.0);
    EXPECT_NEAR(lipschitz_estimate(runtime(), sphere), 1.5 * 2.0 * glm::length(search_region(sphere).max), 1e-12);
}

TEST(LipschitzEstimate, IgnoresNonFiniteValues) {
    const AnyField half(cube(1.0), [](const glm::dvec3& p) -> Field {
        return {p.x, {p.x > 0.0 ? std::nan("") : 2.0, 0.0, 0.0}, {}};
    });
    EXPECT_NEAR(lipschitz_estimate(runtime(), half), 3.0, 1e-14);
    const AnyField flat(cube(1.0), [](const glm::dvec3&) -> Field { return {}; });
    EXPECT_GT(lipschitz_estimate(runtime(), flat), 0.0);
}

TEST(Contains, PointsWithNegativeFInTheRegion) {
    const Sphere sphere;
    const auto inside = inside_of(sphere, {{0, 0, 0}, {0.99, 0, 0}, {1.0, 0, 0}, {1.01, 0, 0}, {0, -0.7, 0.7}});
    const std::array<int, 5> wanted = {1, 1, 0, 0, 1};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(inside[static_cast<std::int64_t>(i)], wanted[i]) << i;
    EXPECT_EQ(sphere.evaluations, 5);
}

TEST(Contains, NothingBeyondTheRegionOrNonFinite) {
    const Plane half_space({0, 0, 1}, 0.0, cube(1.0)); // f < 0 for all z < 0
    const double edge = 1.0 + 0.05 * std::sqrt(12.0);
    const auto inside = inside_of(half_space, {{0, 0, -edge + 1e-9}, {0, 0, -edge - 1e-9}, {9, 0, -1}, {0, 0, 0.1}});
    EXPECT_EQ(inside[0], 1);
    EXPECT_EQ(inside[1], 0);
    EXPECT_EQ(inside[2], 0);
    EXPECT_EQ(inside[3], 0);
    EXPECT_EQ(half_space.evaluations, 2) << "f is not asked for beyond the region";
    const AnyField broken(cube(1.0), [](const glm::dvec3&) -> Field { return {std::nan(""), {}, {}}; });
    EXPECT_EQ(inside_of(broken, {{0, 0, 0}})[0], 0);
}

TEST(Contains, AcceptsNoPoints) { EXPECT_EQ(inside_of(Sphere(), {}).size(), 0); }

} // namespace
} // namespace hrbfnpr::surface::region_test
