// SPDX-License-Identifier: MIT
#include "picture/strays.h"

#include "base/random.h"
#include "geometry/vec.h"
#include "support/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace picture_test::strays_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

class Strays : public testing::Test {
protected:
    base::Memory memory;
    Pool pool{memory};

    // Adds samples of a sphere, scaled and moved.
    void add_sphere(Points& to, std::int64_t count, double scale = 1.0, const glm::dvec3& at = glm::dvec3(0.0)) const {
        for (std::int64_t i = 0; i < count; ++i) {
            const auto p = test::spiral_point(i, count);
            to.push_back(at + scale * glm::dvec3(p[0], p[1], p[2]));
        }
    }
    static std::vector<std::int64_t> numbers(const PointMask& mask) {
        std::vector<std::int64_t> found;
        for (std::size_t i = 0; i < mask.size(); ++i)
            if (mask[i] != 0) found.push_back(static_cast<std::int64_t>(i));
        return found;
    }
    std::vector<std::int64_t> far_of(const Points& points) { return numbers(far_from_most(points, pool)); }
    std::vector<std::int64_t> strays_of(const Points& points) {
        return numbers(find_strays(points, base::Parallel(), pool));
    }
};

using Numbers = std::vector<std::int64_t>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST_F(Strays, AreFewAndFarFromTheRest) {
    Points points(&pool);
    add_sphere(points, 2000);
    EXPECT_EQ(far_of(points), Numbers{});
    Points near(points, &pool);
    near.emplace_back(3.0, 0.0, 0.0);
    EXPECT_EQ(far_of(near), Numbers{}) << "not so far";
    Points many(points, &pool);
    add_sphere(many, 40, 1.0, {30.0, 0.0, 0.0});
    EXPECT_EQ(far_of(many), Numbers{}) << "not so few";
    points.emplace_back(9.0, 0.0, 0.0);
    points.emplace_back(0.0, -20.0, 0.0);
    EXPECT_EQ(far_of(points), (Numbers{2000, 2001}));
    points.emplace_back(nan, 0.0, 0.0);
    points.emplace_back(1e308, -1e308, 1e308); // Its distance overflows to infinity.
    EXPECT_EQ(far_of(points), (Numbers{2000, 2001, 2003}));
}

TEST_F(Strays, AreAbsentInTooLittleData) {
    Points points(&pool);
    EXPECT_EQ(far_of(points), Numbers{});
    EXPECT_EQ(strays_of(points), Numbers{});
    points.emplace_back(nan, nan, nan);
    EXPECT_EQ(far_of(points), Numbers{});
    points.assign(500, glm::dvec3(1.0, 2.0, 3.0)); // All points are at one place.
    EXPECT_EQ(far_of(points), Numbers{});
    EXPECT_EQ(strays_of(points), Numbers{});
    points.assign(500, glm::dvec3(0.0)); // One point differs by the least double, so no cell can grow.
    points[3].x = 5e-324;
    EXPECT_EQ(strays_of(points), Numbers{});
    for (std::size_t i = 0; i < points.size(); ++i) points[i].x = i % 2 == 0 ? 1.7e308 : -1.7e308;
    EXPECT_EQ(strays_of(points), Numbers{});
}

TEST_F(Strays, AreDustAroundASphere) {
    Points dusty(&pool);
    add_sphere(dusty, 1500);
    for (std::int64_t i = 0; i < 30; ++i) {
        const auto p = test::spiral_point(i, 30);
        dusty.push_back((2.0 + 0.04 * static_cast<double>(i)) * glm::dvec3(p[0], p[1], p[2]));
    }
    Numbers expected;
    for (std::int64_t i = 1500; i < 1530; ++i) expected.push_back(i);
    EXPECT_EQ(strays_of(dusty), expected);

    Points two(&pool); // Two spacings.
    add_sphere(two, 400);
    add_sphere(two, 200, 0.05, {3.0, 0.0, 0.0});
    for (std::int64_t i = 0; i < 12; ++i) {
        const auto p = test::spiral_point(i, 12);
        two.emplace_back(8.0 * p[0], 3.0 * p[1], 2.0 * p[2]);
    }
    expected.clear();
    for (std::int64_t i = 600; i < 612; ++i) expected.push_back(i);
    EXPECT_EQ(strays_of(two), expected);
}

// Adds points in the box of the points, and returns for each one whether it is far from the points before.
std::vector<bool> add_dust(Points& points, std::size_t count, double far) {
    geometry::Bounds box;
    for (const glm::dvec3& p : points) box.extend(p);
    const std::size_t before = points.size();
    std::vector<bool> is_far;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto random = base::uniform4(7, i, base::Purpose::probe, 1);
        points.push_back(box.min + glm::dvec3(random[0], random[1], random[2]) * (box.max - box.min));
        double nearest = far;
        for (std::size_t k = 0; k < before; ++k) nearest = std::min(nearest, glm::distance(points[k], points.back()));
        is_far.push_back(nearest >= far);
    }
    return is_far;
}

// Dust in the box of an object is found without any of its points, for few and for many points.
TEST_F(Strays, AreDustInTheBoxOfAnObject) {
    for (const std::int64_t count : {2400, 9600}) {
        const test::Samples torus = test::even_torus(count);
        Points points(&pool);
        for (std::size_t i = 0; i < torus.points.size(); i += 3)
            points.emplace_back(torus.points[i], torus.points[i + 1], torus.points[i + 2]);
        EXPECT_EQ(strays_of(points), Numbers{}) << count;
        const auto before = static_cast<std::int64_t>(points.size());
        const double spacing = 4.0 / std::sqrt(static_cast<double>(before));
        const std::vector<bool> is_far = add_dust(points, points.size() / 20, 4.0 * spacing);
        const PointMask found = find_strays(points, base::Parallel(), pool);
        EXPECT_EQ(std::count(found.begin(), found.begin() + before, 1), 0) << count;
        std::int64_t far = 0, missed = 0;
        for (std::size_t i = 0; i < is_far.size(); ++i) {
            far += is_far[i] ? 1 : 0;
            missed += is_far[i] && found[static_cast<std::size_t>(before) + i] == 0 ? 1 : 0;
        }
        EXPECT_GT(far, 0);
        EXPECT_LE(100 * missed, 3 * far) << count;
    }
}

// Coarse parts, wires and edges are no dust.
TEST_F(Strays, AreAbsentInCoarseParts) {
    Points coarse(&pool);
    Points all(&pool);
    add_sphere(all, 4000);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].z < 0.3 || i % 12 == 0) coarse.push_back(all[i]);
    EXPECT_LE(strays_of(coarse).size(), 5U);
    Points wire(&pool);
    add_sphere(wire, 1500);
    for (int i = 0; i < 300; ++i) {
        const double a = 0.07 * i;
        wire.emplace_back(3.0 + 0.5 * std::cos(a), 0.5 * std::sin(a), 0.15 * a);
    }
    EXPECT_EQ(strays_of(wire), Numbers{});
    Points cube(&pool);
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            for (int i = 0; i < 400; ++i) {
                glm::dvec3 p(side);
                p[(axis + 1) % 3] = 0.1 * (i % 20) - 0.95;
                p[(axis + 2) % 3] = 0.1 * (i / 20) - 0.95;
                cube.push_back(p);
            }
    EXPECT_EQ(strays_of(cube), Numbers{});
}

TEST_F(Strays, AreAbsentInUnevenPoints) {
    Points flat(&pool);
    add_sphere(flat, 3000);
    for (glm::dvec3& p : flat) p.z = 0.0;
    EXPECT_EQ(strays_of(flat), Numbers{});
    Points half(&pool);
    add_sphere(half, 1500);
    for (std::int64_t i = 0; i < 300; ++i) { // A sixth of the points is far from the others.
        const auto p = test::spiral_point(i, 300);
        half.push_back((20.0 + static_cast<double>(i)) * glm::dvec3(p[0], p[1], p[2]));
    }
    EXPECT_EQ(strays_of(half), Numbers{});
}

// ---- Values that stand for no data

Shape grid(Pool& pool) {
    Shape shape(pool);
    for (int i = 0; i < 100; ++i) shape.points.emplace_back(i % 10, i / 10, 2.0 + std::sin(static_cast<double>(i)));
    shape.normals.assign(100, glm::dvec3(0.0, 0.0, 1.0));
    return shape;
}

TEST_F(Strays, NoDataValuesAreLeftOut) {
    Shape shape = grid(pool);
    shape.columns = shape.rows = 10;
    shape.points[3].z = shape.points[7].z = -9999.0;
    shape.points[8].x = nan;
    const NoData found = leave_out_no_data(shape, pool);
    EXPECT_EQ(found.points, 2);
    EXPECT_EQ(found.value, -9999.0);
    ASSERT_EQ(shape.points.size(), 98U);
    EXPECT_EQ(shape.normals.size(), 98U);
    EXPECT_EQ(shape.points[3].x, 4.0);
    EXPECT_EQ(shape.columns, 0) << "it is no image any more";
}

TEST_F(Strays, ARealDepthIsNotTakenForNoData) {
    Shape deep = grid(pool);
    deep.points[3].z = -9999.0;
    for (std::size_t i = 8; i < 40; ++i) deep.points[i].z = -9990.0;
    EXPECT_EQ(leave_out_no_data(deep, pool).points, 0);
    Shape alone(pool);
    alone.points.assign(3, glm::dvec3(-9999.0));
    EXPECT_EQ(leave_out_no_data(alone, pool).points, 0);
    EXPECT_EQ(alone.points.size(), 3U);
}

TEST_F(Strays, FacesAreLeftOutWithTheirPoints) {
    Shape mesh = grid(pool);
    mesh.points[3].z = mesh.points[7].z = -9999.0;
    mesh.triangles = {{{2, 3, 4}}};
    EXPECT_EQ(leave_out_no_data(mesh, pool).points, 0) << "no face would be left";
    EXPECT_EQ(mesh.points.size(), 100U);
    mesh.triangles = {{{0, 1, 2}, {2, 3, 4}, {5, 6, 8}}};
    mesh.sharp_edges = {{{3, 4}, {6, 8}}};
    EXPECT_EQ(leave_out_no_data(mesh, pool).points, 2);
    ASSERT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
    EXPECT_EQ(mesh.triangles[1], (Triangle{4, 5, 6}));
    ASSERT_EQ(mesh.sharp_edges.size(), 1U);
    EXPECT_EQ(mesh.sharp_edges[0], (Edge{5, 6}));
    EXPECT_EQ(mesh.points.size(), 98U);
}

} // namespace
} // namespace picture_test::strays_test
