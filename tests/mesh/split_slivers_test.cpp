// SPDX-License-Identifier: MIT
// Tests faces without an area between other faces, as CAD programs write them.
#include "base/random.h"
#include "meshes.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace split_slivers_test {

namespace mesh = hrbfnpr::mesh;
using hrbfnpr::test::box;
using hrbfnpr::test::with_threads;
using mesh::Mesh;
using namespace mesh_test;

namespace {

// Cuts a face in two at a place on one side. A face without an area fills the slit between it and the face across that
// side.
void cut(Triangles& shape, std::size_t face, std::size_t side, double share) {
    const std::size_t first = 3 * face;
    const std::int32_t a = shape.triangles[first + side], b = shape.triangles[first + (side + 1) % 3];
    const std::int32_t c = shape.triangles[first + (side + 2) % 3];
    const auto at = [&](std::size_t axis) {
        const double from = shape.vertices[3 * static_cast<std::size_t>(a) + axis];
        return from + share * (shape.vertices[3 * static_cast<std::size_t>(b) + axis] - from);
    };
    const std::int32_t middle = shape.add(at(0), at(1), at(2));
    shape.triangles[first] = a;
    shape.triangles[first + 1] = middle;
    shape.triangles[first + 2] = c;
    shape.face(middle, b, c);
    shape.face(a, b, middle);
}

double thinnest(const Mesh& shape) {
    double result = 1.0;
    for (std::int64_t face = 0; face < shape.faces(); ++face) {
        const auto p = shape.corners(face);
        const double longest =
            std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
        result = std::min(result, glm::length(mesh::doubled_area(p)) / (longest * longest));
    }
    return result;
}

// Turns a mesh and rounds it to single precision, like a file.
Triangles turned_and_rounded(const Triangles& from) {
    Triangles result = from;
    const glm::dmat3 turn(0.36, 0.48, -0.8, -0.8, 0.6, 0.0, 0.48, 0.64, 0.6);
    for (std::size_t i = 0; i < from.vertices.size(); i += 3) {
        const glm::dvec3 p = turn * glm::dvec3(from.vertices[i], from.vertices[i + 1], from.vertices[i + 2]);
        for (std::size_t k = 0; k < 3; ++k)
            result.vertices[i + k] = static_cast<double>(static_cast<float>(p[static_cast<glm::length_t>(k)]));
    }
    return result;
}

TEST(SplitSlivers, LeavesNoSlit) {
    const auto runtime = with_threads(2);
    Triangles shape = box(1.0, 1.0, 1.0, 1);
    cut(shape, 3, 1, 0.4);
    const Mesh made_of = made(runtime, shape);
    EXPECT_TRUE(made_of.report.closed);
    EXPECT_EQ(made_of.report.degenerate_faces, 1);
    EXPECT_EQ(made_of.faces(), 14);
    EXPECT_NEAR(made_of.report.volume, 1.0, 1e-12);
    EXPECT_NEAR(made_of.report.area, 6.0, 1e-12);
    for (const std::int32_t given : made_of.given_face) EXPECT_LT(given, 14);
}

// Many slivers are beside each other, share corners and are cut again. Some are within the sides of others.
TEST(SplitSlivers, RemovesManyAdjacentSlivers) {
    const auto runtime = with_threads(2);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Triangles shape = box(1.0, 1.0, 1.0, 2);
        for (std::uint64_t i = 0; i < 60; ++i) {
            const auto u = hrbfnpr::base::uniform4(seed, i, hrbfnpr::base::Purpose::probe);
            const auto face = static_cast<std::size_t>(u[0] * static_cast<double>(shape.faces()));
            cut(shape, face, static_cast<std::size_t>(3.0 * u[1]), 0.25 + 0.5 * u[2]);
        }
        for (const bool rounded : {false, true}) {
            const Mesh made_of = made(runtime, rounded ? turned_and_rounded(shape) : shape);
            EXPECT_TRUE(made_of.report.closed) << seed << rounded;
            EXPECT_EQ(made_of.report.components, 1) << seed << rounded;
            EXPECT_NEAR(made_of.report.volume, 1.0, 1e-5) << seed << rounded;
            EXPECT_GE(made_of.report.degenerate_faces, 60) << seed << rounded;
            EXPECT_GT(thinnest(made_of), 1e-6) << seed << rounded;
        }
    }
}

// The two places at one end of the needle differ only by rounding.
TEST(SplitSlivers, JoinsTheEndsOfNeedles) {
    const auto runtime = with_threads(2);
    Triangles shape = box(1.0, 1.0, 1.0, 1);
    cut(shape, 3, 1, 1e-8);
    const Mesh made_of = made(runtime, shape);
    EXPECT_TRUE(made_of.report.closed);
    EXPECT_EQ(made_of.vertex.size(), 8);
    EXPECT_EQ(made_of.faces(), 12);
}

TEST(SplitSlivers, KeepsThinFaces) {
    const auto runtime = with_threads(2);
    Triangles shape;
    const std::int32_t a = shape.add(0, 0, 0), b = shape.add(1, 0, 0), c = shape.add(0.5, 1e-5, 0),
                       d = shape.add(0.5, -1, 0);
    shape.face(a, b, c);
    shape.face(b, a, d);
    const Mesh made_of = made(runtime, shape);
    EXPECT_EQ(made_of.faces(), 2);
    EXPECT_EQ(made_of.report.degenerate_faces, 0);
}

} // namespace

} // namespace split_slivers_test
