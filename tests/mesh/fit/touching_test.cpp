// SPDX-License-Identifier: MIT
#include "mesh/fit/outer.h"

#include "mesh/meshes.h"
#include "support/runtime.h"

#include <glm/gtx/component_wise.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace touching_test {

namespace mesh = hrbfnpr::mesh;
using hrbfnpr::test::box;
using hrbfnpr::test::with_threads;
using namespace mesh_test;

namespace {

// Looks for touching parts with this number of sample places.
mesh::PartContact find(const Triangles& from, double near, std::int64_t places, int threads = 2, bool crossing = true) {
    const auto runtime = with_threads(threads);
    const mesh::Mesh shape = made(runtime, from);
    const mesh::FaceTree tree(runtime, shape.vertex, shape.triangle);
    const mesh::MeshSamples at = mesh::random_samples(runtime, shape, places, 1, 0);
    return mesh::find_part_contact(runtime, shape, tree, at, near, !crossing);
}

const Triangles cube = box(1.0, 1.0, 1.0, 1);

TEST(Touching, IsFoundWherePartsAreNear) {
    EXPECT_LT(find(cube.with(cube.moved(1.0, 1.011, 0.0, 0.0)), 0.01, 500).one, 0);
    const mesh::PartContact found = find(cube.with(cube.moved(1.0, 1.009, 0.0, 0.0)), 0.01, 500);
    EXPECT_EQ(found.one + found.other, 1);
    EXPECT_NEAR(found.place.x, 1.0045, 0.0046);
}

// Few samples are near the crossing, so it is found from edges whose ends are on different sides of a face.
TEST(Touching, IsFoundWherePartsCross) {
    // One corner is inside another, and a bar goes through two faces, though its edges meet faces of the bar itself
    // before.
    const Triangles bar = box(3.0, 0.02, 0.02, 1).moved(1.0, -1.0, 0.4, 0.3);
    for (const Triangles& two : {cube.with(cube.moved(1.0, 0.999, 0.999, 0.999)), cube.with(bar), bar.with(cube)}) {
        const mesh::PartContact found = find(two, 1e-6, 10);
        EXPECT_GE(found.one, 0);
        EXPECT_EQ(found.one + found.other, 1);
        EXPECT_GE(glm::compMin(found.place), 0.0);
        EXPECT_LE(glm::compMax(found.place), 1.0);
    }
    EXPECT_LT(find(cube.with(cube.moved(1.0, 1.001, 0.999, 0.999)), 1e-6, 10).one, 0);
}

// Turns a mesh about z and then about y.
Triangles turned_by(const Triangles& from, double about_z, double about_y) {
    Triangles result = from;
    for (std::size_t i = 0; i < from.vertices.size(); i += 3) {
        const double x = std::cos(about_z) * from.vertices[i] - std::sin(about_z) * from.vertices[i + 1];
        result.vertices[i + 1] = std::sin(about_z) * from.vertices[i] + std::cos(about_z) * from.vertices[i + 1];
        result.vertices[i] = std::cos(about_y) * x - std::sin(about_y) * from.vertices[i + 2];
        result.vertices[i + 2] = std::sin(about_y) * x + std::cos(about_y) * from.vertices[i + 2];
    }
    return result;
}

// Two squares form a star, and their edges cross each other. Only rounding decides whether an edge goes through a face.
TEST(Touching, IsFoundWherePartsCrossOnEdgesAlone) {
    const Triangles square = box(2.0, 2.0, 1.0, 1).moved(1.0, -1.0, -1.0, 0.0);
    const Triangles star = square.with(turned_by(square, 0.25 * std::numbers::pi, 0.0));
    for (int turn = 0; turn < 20; ++turn) {
        const mesh::PartContact found = find(turned_by(star, 0.37 * turn, 0.23 * turn), 1e-6, 200);
        EXPECT_GE(found.one, 0) << turn;
        EXPECT_EQ(found.one + found.other, 1) << turn;
    }
    // A box that is completely inside crosses nothing.
    const Triangles hollow = box(0.4, 0.4, 0.4, 1).moved(1.0, 0.3, 0.3, 0.3);
    EXPECT_LT(find(cube.with(hollow), 1e-6, 200).one, 0);
}

// Samples beside the line where two parts cross are near the other part. They do not count as near.
TEST(Touching, CrossingPartsDoNotCountAsNear) {
    const Triangles beside = cube.with(cube.moved(1.0, 1.009, 0.0, 0.0));
    const Triangles crossing = cube.with(cube.moved(1.0, 0.5, 0.4, 0.3));
    EXPECT_GE(find(beside, 0.01, 500, 2, false).one, 0);
    EXPECT_GE(find(crossing, 0.01, 2000, 2, true).one, 0);
    EXPECT_LT(find(crossing, 0.01, 2000, 2, false).one, 0);
}

} // namespace

} // namespace touching_test
