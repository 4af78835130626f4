// SPDX-License-Identifier: MIT
// Tests solids that share faces or edges.
#include "meshes.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace walls_test {

namespace mesh = hrbfnpr::mesh;
using hrbfnpr::test::box;
using hrbfnpr::test::with_threads;
using mesh::Mesh;
using namespace mesh_test;

namespace {

const Triangles cube = box(1.0, 1.0, 1.0, 1);

Triangles at(double x, double y, double z) { return cube.moved(1.0, x, y, z); }

// Mirrors the box in y, which cuts its faces along the other diagonals.
Triangles cut_otherwise(const Triangles& from) {
    Triangles result = from;
    for (std::size_t i = 0; i < from.vertices.size(); i += 3) result.vertices[i + 1] = 1.0 - from.vertices[i + 1];
    return result.turned();
}

TEST(Walls, BetweenTwoBoxesAreRemoved) {
    const auto runtime = with_threads(2);
    const Mesh two = made(runtime, cube.with(at(1, 0, 0)));
    EXPECT_TRUE(two.report.closed);
    EXPECT_EQ(two.report.components, 1);
    EXPECT_EQ(two.report.repeated_faces, 4);
    EXPECT_EQ(two.faces(), 20);
    EXPECT_NEAR(two.report.area, 10.0, 1e-12);
    EXPECT_NEAR(two.report.volume, 2.0, 1e-12);
}

TEST(Walls, BetweenManyBoxesAreRemoved) {
    const auto runtime = with_threads(2);
    Triangles all;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 3; ++y)
            for (int z = 0; z < 3; ++z)
                if (x != 2 || y != 1) all = all.with(at(x, y, z)); // leaves a slot open
    const Mesh made_of = made(runtime, all);
    EXPECT_TRUE(made_of.report.closed);
    EXPECT_EQ(made_of.report.components, 1);
    EXPECT_NEAR(made_of.report.volume, 24.0, 1e-12);
    EXPECT_NEAR(made_of.report.area, 9.0 * 4 + 2 * 8 + 2 * 3, 1e-12);
    EXPECT_EQ(made_of.report.genus, 0);
}

// Faces that are cut along other diagonals are no twins, and the boxes remain two solids.
TEST(Walls, WithDifferentFacesSeparateTheSolids) {
    const auto runtime = with_threads(2);
    const Triangles other = cut_otherwise(cube).moved(1.0, 1.0, 0.0, 0.0);
    const Mesh two = made(runtime, cube.with(other));
    EXPECT_TRUE(two.report.closed);
    EXPECT_EQ(two.report.components, 2);
    EXPECT_EQ(two.report.repeated_faces, 0);
    EXPECT_EQ(two.report.nonmanifold_edges, 0);
    EXPECT_NEAR(two.report.volume, 2.0, 1e-12);
}

// Two pyramids, base on base. The bases share two faces, and each base also has other faces. The shared faces look like
// a wall, but are only a part of the contact: without them it would have a window. Turned and rounded to single
// precision, the bases are not quite in one plane.
TEST(Walls, CoveringOnlyPartOfTheContactAreKept) {
    const auto runtime = with_threads(2);
    const auto pyramid = [](double top, const std::vector<std::array<std::int32_t, 3>>& base) {
        const auto turned = [](double x, double y, double z) {
            const glm::dvec3 p = glm::dmat3(0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6) * glm::dvec3(x, y, z);
            return glm::dvec3(glm::vec3(p + glm::dvec3(40.1, 20.3, 10.7)));
        };
        Triangles result;
        for (const auto& [x, y, z] : {std::array{0.0, 0.0, 0.0},
                                      {1.0, 0.0, 0.0},
                                      {1.0, 1.0, 0.0},
                                      {0.0, 1.0, 0.0},
                                      {0.4, 0.3, 0.0},
                                      {0.5, 0.5, top}}) {
            const glm::dvec3 p = turned(x, y, z);
            static_cast<void>(result.add(p.x, p.y, p.z));
        }
        for (const auto& face : base) result.face(face[0], face[1], face[2]);
        for (std::int32_t i = 0; i < 4; ++i) result.face(i, (i + 1) % 4, 5);
        return top > 0.0 ? result : result.turned();
    };
    const Triangles upper = pyramid(1.0, {{1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}});
    const Triangles lower = pyramid(-1.0, {{1, 0, 4}, {0, 3, 4}, {3, 1, 4}, {3, 2, 1}});
    ASSERT_TRUE(made(runtime, upper).report.closed);
    ASSERT_TRUE(made(runtime, lower).report.closed);
    const Mesh two = made(runtime, upper.with(lower));
    EXPECT_TRUE(two.report.closed);
    EXPECT_EQ(two.report.components, 2);
    EXPECT_EQ(two.report.repeated_faces, 0);
    EXPECT_EQ(two.report.nonmanifold_edges, 0);
    EXPECT_EQ(two.faces(), 16);
    EXPECT_NEAR(two.report.volume, 2.0 / 3.0, 1e-5);
    std::vector<int> seen(16);
    for (std::int64_t i = 0; i < two.faces(); ++i) ++seen[static_cast<std::size_t>(two.given_face[i])];
    EXPECT_EQ(seen, std::vector<int>(16, 1));
}

TEST(Walls, SolidsThatTouchInAnEdgeAreClosed) {
    for (const int threads : {1, 3}) {
        const auto runtime = with_threads(threads);
        const Mesh two = made(runtime, cube.with(at(1, 1, 0)));
        EXPECT_TRUE(two.report.closed);
        EXPECT_EQ(two.report.components, 2);
        EXPECT_EQ(two.vertex.size(), 16);
        EXPECT_EQ(two.report.genus, 0);
        // Three cubes about one edge. One of them meets both others in walls.
        const Mesh three = made(runtime, cube.with(at(1, 1, 0)).with(at(0, 1, 0)));
        EXPECT_TRUE(three.report.closed);
        EXPECT_EQ(three.report.components, 1);
        EXPECT_NEAR(three.report.volume, 3.0, 1e-12);
    }
}

// Solids that share only a corner are two. Sheets that do stay as they are, since they have borders there.
TEST(Walls, SolidsThatTouchInACornerStaySeparate) {
    const auto runtime = with_threads(2);
    const Mesh two = made(runtime, cube.with(at(1, 1, 1)));
    EXPECT_TRUE(two.report.closed);
    EXPECT_EQ(two.report.components, 2);
    EXPECT_EQ(two.vertex.size(), 16);
    EXPECT_EQ(two.report.genus, 0);
    Triangles sheets;
    const std::int32_t middle = sheets.add(0, 0, 0);
    const std::int32_t a = sheets.add(1, 0, 0), b = sheets.add(0, 1, 0);
    const std::int32_t c = sheets.add(-1, 0, 0), d = sheets.add(0, -1, 0);
    sheets.face(middle, a, b);
    sheets.face(middle, c, d);
    EXPECT_EQ(made(runtime, sheets).vertex.size(), 5);
}

// Two wedges share an edge and reach into each other. Each keeps the faces that continue straight.
TEST(Walls, SolidsThatCrossInAnEdgeAreClosed) {
    const auto runtime = with_threads(2);
    const auto wedge = [](double first, double last) { // about the edge from (0, 0, 0) to (0, 0, 1), in degrees
        Triangles made;
        const auto corner = [&](double degrees, double z) {
            const double angle = degrees * 3.141592653589793 / 180.0;
            return made.add(std::cos(angle), std::sin(angle), z);
        };
        const std::int32_t p = made.add(0, 0, 0), q = made.add(0, 0, 1);
        const std::int32_t a = corner(first, 0), b = corner(first, 1), c = corner(last, 0), d = corner(last, 1);
        for (const std::array<std::int32_t, 3>& face :
             {std::array{p, c, a}, {q, b, d}, {p, a, b}, {p, b, q}, {p, q, d}, {p, d, c}, {a, c, d}, {a, d, b}})
            made.face(face[0], face[1], face[2]);
        return made;
    };
    const Mesh two = made(runtime, wedge(0.0, 160.0).with(wedge(100.0, 265.0)));
    EXPECT_TRUE(two.report.closed);
    EXPECT_EQ(two.report.nonmanifold_edges, 0);
    EXPECT_EQ(two.report.components, 2);
}

TEST(Walls, DoNotIncludeTwoSidedLeaves) {
    const auto runtime = with_threads(2);
    const Triangles top = box(1.0, 1.0, 1.0, 4).where([](double, double, double z) { return z > 0.999; });
    const Mesh leaf = made(runtime, top.with(top.turned()));
    EXPECT_EQ(leaf.faces(), static_cast<std::int64_t>(top.faces()));
    EXPECT_EQ(leaf.report.repeated_faces, leaf.faces());
    // A solid remains a solid if each of its faces is doubled by its reverse.
    const Mesh solid = made(runtime, cube.with(cube.turned()));
    EXPECT_EQ(solid.faces(), 12);
    EXPECT_TRUE(solid.report.closed);
    // Nor is such a leaf a wall beside a solid: its faces stay.
    const Mesh beside = made(runtime, cube.with(top.with(top.turned()).moved(1.0, 1.0, 0.0, 0.0)));
    EXPECT_EQ(beside.faces(), 12 + static_cast<std::int64_t>(top.faces()));
}

} // namespace

} // namespace walls_test
