// SPDX-License-Identifier: MIT
#include "picture/sharp_edges.h"

#include "mesh_shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace picture_tests::sharp_edges_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;
using hrbfnpr::mesh::EdgesInFile;
using testing::ElementsAre;
using testing::IsEmpty;

class SharpEdges : public testing::Test {
protected:
    base::Memory memory;
    Pool pool{memory};

    Vector<Edge> edges(std::initializer_list<Edge> list) { return {list, &pool}; }
    Points points(std::initializer_list<glm::dvec3> list) { return {list, &pool}; }
    Vector<Edge> all_edges(const Shape& shape) {
        return {find_edges(shape.triangles, shape.points.size(), pool).ends, &pool};
    }
};

TEST_F(SharpEdges, AreFoundAmongPointsAtTheSamePlaces) {
    const Points of = points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}});
    const Vector<Edge> sharp = edges({{3, 1}, {1, 2}});
    EXPECT_THAT(edges_among(points({of[2], of[1], of[0]}), sharp, of, pool), ElementsAre(Edge{2, 1}, Edge{1, 0}));
    EXPECT_THAT(edges_among(points({of[1], of[2]}), sharp, of, pool), ElementsAre(Edge{0, 1}));
    EXPECT_THAT(edges_among(points({}), sharp, of, pool), IsEmpty());
    EXPECT_THAT(edges_among(of, edges({}), of, pool), IsEmpty());
}

TEST_F(SharpEdges, WithNonFinitePointsAreLeftOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Points of = points({{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, nan, 1}});
    EXPECT_THAT(edges_among(points({of[1], of[2]}), edges({{0, 1}, {2, 1}, {3, 2}}), of, pool),
                ElementsAre(Edge{1, 0}));
}

TEST_F(SharpEdges, OnABallCountIfThereAreEnough) {
    const Shape ball = shape_of(test::icosphere(1), pool);
    const Vector<Edge> all = all_edges(ball);
    EXPECT_EQ(said_of_edges(ball.points, ball.triangles, all, pool), EdgesInFile::all_are_sharp);
    EXPECT_EQ(said_of_edges(ball.points, ball.triangles, edges({}), pool), EdgesInFile::nothing);
    Vector<Edge> some(all.begin(), all.begin() + 2, &pool); // Only 2 of 120 edges are sharp.
    EXPECT_EQ(said_of_edges(ball.points, ball.triangles, some, pool), EdgesInFile::nothing);
    some.assign(all.begin(), all.begin() + 3);
    EXPECT_EQ(said_of_edges(ball.points, ball.triangles, some, pool), EdgesInFile::some_are_sharp);
    some.assign(all.begin(), all.end() - 3);
    EXPECT_EQ(said_of_edges(ball.points, ball.triangles, some, pool), EdgesInFile::some_are_sharp);
}

TEST_F(SharpEdges, InsideFlatPolygonsDoNotCount) {
    // Only the edges of the box bend. Diagonals of its sides and edges between its cells do not.
    const Shape box = shape_of(test::box(1, 1, 1, 2), pool); // Each side has separate vertices.
    const Vector<Edge> all = all_edges(box);
    EXPECT_EQ(said_of_edges(box.points, box.triangles, all, pool), EdgesInFile::all_are_sharp);
    Vector<Edge> bent(&pool);
    for (const Edge& edge : all) {
        const glm::dvec3 middle =
            0.5 * (box.points[static_cast<std::size_t>(edge[0])] + box.points[static_cast<std::size_t>(edge[1])]);
        int on_sides = 0;
        for (int axis = 0; axis < 3; ++axis) on_sides += middle[axis] == 0.0 || middle[axis] == 1.0 ? 1 : 0;
        if (on_sides == 2) bent.push_back(edge);
    }
    EXPECT_EQ(bent.size(), 48U); // Each of twelve edges has two, repeated for two sides.
    EXPECT_EQ(said_of_edges(box.points, box.triangles, bent, pool), EdgesInFile::all_are_sharp);
}

TEST_F(SharpEdges, AreIgnoredIfThereAreFewFaces) {
    const Shape four = shape_of(test::tetrahedron(), pool); // It has six edges.
    EXPECT_EQ(said_of_edges(four.points, four.triangles, all_edges(four), pool), EdgesInFile::nothing);
    Shape flat(pool); // Its face has no area and so no normal.
    flat.points = points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    flat.triangles.assign(20, Triangle{0, 1, 2});
    EXPECT_EQ(said_of_edges(flat.points, flat.triangles, edges({{0, 1}}), pool), EdgesInFile::nothing);
}

} // namespace
} // namespace picture_tests::sharp_edges_test
