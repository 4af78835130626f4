// SPDX-License-Identifier: MIT
// Compares the answers of nearby faces with those of the tree of all faces.
#include "mesh/nearby_faces.h"

#include "meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nearby_faces_test {

namespace mesh = hrbfnpr::mesh;
using hrbfnpr::test::torus;
using namespace mesh_test;

namespace {

const hrbfnpr::base::Runtime& runtime() {
    static const hrbfnpr::base::Runtime instance;
    return instance;
}

glm::dvec3 within_one(int i) { return {std::sin(12.9898 * i), std::sin(78.233 * i + 1.0), std::sin(37.719 * i + 2.0)}; }

// A torus, the place of one of its vertices and the middle of one of its edges.
struct Ring {
    mesh::Mesh ring = made(runtime(), torus(60, 24, 0.3));
    mesh::FaceTree tree{runtime(), ring.vertex, ring.triangle};
    glm::dvec3 vertex = ring.vertex[7];
    glm::dvec3 on_edge = 0.5 * (ring.corners(100)[0] + ring.corners(100)[1]);
};

TEST(NearbyFaces, FindTheNearestFaceOfAll) {
    const Ring r;
    int on_edges = 0, alone = 0;
    for (const double half : {0.02, 0.1, 0.4})
        for (int i = 0; i < 3000; ++i) {
            const glm::dvec3 centre = i % 2 == 0 ? r.vertex : r.on_edge;
            const mesh::NearbyFaces nearby(runtime().memory, r.tree, centre, half);
            const glm::dvec3 p = centre + 1.2 * half * within_one(i);
            const auto expected = r.tree.nearest(p);
            const auto found = nearby.nearest(p, HUGE_VAL);
            ASSERT_EQ(found.face, expected.face) << i;
            ASSERT_EQ(found.squared, expected.squared) << i;
            ASSERT_EQ(found.place, expected.place) << i;
            ASSERT_EQ(nearby.nearest(p, 1.1 * expected.squared).face, expected.face) << i;
            ASSERT_EQ(nearby.nearest(p, 0.5 * expected.squared).face, -1) << i;
            const bool is_alone = r.tree.nearest_alone(p, HUGE_VAL).alone;
            alone += is_alone ? 1 : 0;
            on_edges += is_alone ? 0 : 1;
        }
    EXPECT_GT(alone, 1000) << "it tells little";
    EXPECT_GT(on_edges, 1000) << "it tells little";
}

TEST(NearbyFaces, MeetRaysLikeAllFaces) {
    const Ring r;
    int hits = 0, changes = 0;
    for (const double half : {0.05, 0.4})
        for (int i = 0; i < 1000; ++i) {
            const mesh::NearbyFaces nearby(runtime().memory, r.tree, r.vertex, half);
            const glm::dvec3 from = r.vertex + 1.2 * half * within_one(i);
            const glm::dvec3 to = r.vertex + 1.2 * half * within_one(i + 5000);
            const auto expected = r.tree.first_hit(from, to - from, 1e-6, 1.0);
            ASSERT_EQ(nearby.first_hit(from, to - from, 1e-6, 1.0).t, expected.t) << i;
            const int winding = r.tree.winding_beyond(from, to);
            ASSERT_EQ(nearby.winding_beyond(from, to), winding) << i;
            hits += expected.face >= 0 ? 1 : 0;
            changes += winding != 0 ? 1 : 0;
        }
    EXPECT_GT(hits, 300) << "it tells little";
    EXPECT_GT(changes, 300) << "it tells little";
}

// Places on a flat square of two faces have the same distance from both along the diagonal.
TEST(FaceTree, TellsWhetherTheNearestFaceIsAlone) {
    hrbfnpr::base::Array<glm::dvec3> vertex(runtime().memory);
    for (const glm::dvec3& p : {glm::dvec3{0, 0, 0}, glm::dvec3{1, 0, 0}, glm::dvec3{1, 1, 0}, glm::dvec3{0, 1, 0}})
        vertex.push_back(p);
    hrbfnpr::base::Array<mesh::Triangle> triangle(runtime().memory);
    triangle.push_back({0, 1, 2});
    triangle.push_back({0, 2, 3});
    const mesh::FaceTree tree(runtime(), vertex, triangle);
    EXPECT_FALSE(tree.nearest_alone({0.3, 0.3, 0.5}, HUGE_VAL).alone);
    EXPECT_FALSE(tree.nearest_alone({-1.0, -2.0, 0.5}, HUGE_VAL).alone);
    EXPECT_TRUE(tree.nearest_alone({0.6, 0.3, 0.5}, HUGE_VAL).alone);
    EXPECT_EQ(tree.nearest_alone({0.6, 0.3, 0.5}, HUGE_VAL).face, 0);
    EXPECT_EQ(tree.nearest_alone({0.3, 0.6, 0.5}, HUGE_VAL).face, 1);
    EXPECT_EQ(tree.nearest_alone({0.3, 0.6, 0.5}, 0.2).face, -1);
}

} // namespace

} // namespace nearby_faces_test
