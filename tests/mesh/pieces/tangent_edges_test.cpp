// SPDX-License-Identifier: MIT
#include "mesh/pieces/tangent_edges.h"

#include "mesh/meshes.h"
#include "mesh/pieces/creases.h"
#include "mesh/pieces/has_creases.h"
#include "support/rounded_meshes.h"
#include "support/runtime.h"
#include "support/sharp_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace tangent_edges_test {

namespace mesh = hrbfnpr::mesh;
namespace test = hrbfnpr::test;
using hrbfnpr::test::Triangles;

namespace {

struct Found {
    explicit Found(const Triangles& from)
        : runtime(test::with_threads(1)), shape(mesh_test::made(runtime, from)),
          sides(mesh::find_tangent_edges(runtime, shape,
                                         mesh::find_creases(runtime, shape, {45.0, shape.bounds.diagonal()}).cut)) {}

    [[nodiscard]] std::pair<glm::dvec3, glm::dvec3> ends(std::int64_t side) const {
        const auto& corner = shape.triangle[side / 3];
        return {shape.vertex[corner[static_cast<std::size_t>(side % 3)]],
                shape.vertex[corner[static_cast<std::size_t>((side + 1) % 3)]]};
    }
    // The total length of the edges that are accepted.
    template <class Accept>
    [[nodiscard]] double length(Accept&& accept) const {
        double sum = 0.0;
        for (const std::int64_t side : sides) {
            const auto [from, to] = ends(side);
            if (accept(from) && accept(to)) sum += 0.5 * glm::distance(from, to); // Each edge has two sides.
        }
        return sum;
    }
    [[nodiscard]] double length() const {
        return length([](const glm::dvec3&) { return true; });
    }

    hrbfnpr::base::Runtime runtime;
    mesh::Mesh shape;
    hrbfnpr::base::Array<std::int64_t> sides;
};

double quarter_in_chords(int parts) { return parts * 2.0 * std::sin(0.25 * 3.141592653589793 / parts); }

// Rounds the coordinates to single precision, as an STL file does, after moving the mesh away from the origin.
Triangles in_single_precision(Triangles mesh) {
    for (double& x : mesh.vertices) x = static_cast<double>(static_cast<float>(x + 0.7));
    return mesh;
}

using ProfilePoint2 = std::array<double, 2>;

// Adds an arc to an outline, without a first point that the outline has already. Angles are in quarters of a turn.
void add_arc2(std::vector<ProfilePoint2>& outline, double x, double y, double radius, double from, double to,
              int parts) {
    for (int i = 0; i <= parts; ++i) {
        const double angle = 1.5707963267948966 * (from + (to - from) * i / parts);
        const ProfilePoint2 p{x + radius * std::cos(angle), y + radius * std::sin(angle)};
        const auto is_at = [&](const ProfilePoint2& other) {
            return std::hypot(p[0] - other[0], p[1] - other[1]) < 1e-9;
        };
        if (outline.empty() || !(is_at(outline.back()) || is_at(outline.front()))) outline.push_back(p);
    }
}

// A wall of some height over a convex outline, with its two ends.
Triangles extruded(const std::vector<ProfilePoint2>& outline, double height) {
    Triangles mesh;
    std::vector<std::vector<std::int32_t>> rows(2);
    for (const double z : {0.0, height})
        for (const ProfilePoint2& p : outline) rows[z > 0.0 ? 1 : 0].push_back(mesh.add(p[0], p[1], z));
    test::join_rows(mesh, rows[0], rows[1], false);
    for (std::size_t i = 2; i < outline.size(); ++i) {
        mesh.face(rows[0][0], rows[0][i], rows[0][i - 1]);
        mesh.face(rows[1][0], rows[1][i - 1], rows[1][i]);
    }
    return mesh;
}

TEST(TangentEdges, BoundTheFilletsOfABox) {
    for (const int parts : {3, 4, 6, 12, 24})
        for (const bool other_diagonal : {false, true})
            for (const bool is_rounded : {false, true}) {
                const double r = 0.25;
                const Triangles box = test::rounded_box(1.0, 1.5, 2.0, r, parts, other_diagonal);
                const Found found(is_rounded ? in_single_precision(box) : box);
                const double lines = 8.0 * 2.0 * ((1.0 - r) + (1.5 - r) + (2.0 - r));
                EXPECT_NEAR(found.length(), lines + 24.0 * r * quarter_in_chords(parts), 1e-5) << parts;
            }
}

TEST(TangentEdges, AreTheCirclesOfAPinThatRunsOutIntoItsPlate) {
    for (const int parts : {3, 4, 8, 20})
        for (const int around : {24, 48, 96})
            for (const bool other_diagonal : {false, true}) {
                const Found found(in_single_precision(test::pin_on_plate(0.3, parts, around, other_diagonal)));
                const double circle = 2.0 * around * std::sin(3.141592653589793 / around);
                const double circles = 1.3 + 1.0 + 1.0 + 0.7;
                EXPECT_NEAR(found.length(), circles * circle, 1e-3) << parts << ' ' << around << ' ' << other_diagonal;
            }
}

TEST(TangentEdges, AreTheEndsOfTheCylinderOfACapsule) {
    for (const int parts : {4, 8, 20})
        for (const int around : {16, 48}) {
            const Found found(test::capsule(3.0, parts, around));
            EXPECT_NEAR(found.length(), 4.0 * around * std::sin(3.141592653589793 / around), 1e-9) << parts;
        }
}

// A slot between flat ends, whose edges are shorter than its faces are wide, and a wall of two radii.
TEST(TangentEdges, GoFromCreaseToCrease) {
    std::vector<ProfilePoint2> slot;
    add_arc2(slot, 30.0, 0.0, 10.0, -1.0, 1.0, 12);
    add_arc2(slot, -30.0, 0.0, 10.0, 1.0, 3.0, 12);
    EXPECT_NEAR(Found(extruded(slot, 2.0)).length(), 4.0 * 2.0, 1e-9);
    EXPECT_NEAR(Found(extruded(slot, 20.0)).length(), 4.0 * 20.0, 1e-9);
    std::vector<ProfilePoint2> egg;
    add_arc2(egg, 0.0, 0.0, 20.0, -1.0, 1.0, 40);
    add_arc2(egg, 0.0, 10.0, 10.0, 1.0, 2.0, 12);
    add_arc2(egg, 0.0, -10.0, 10.0, 2.0, 3.0, 12);
    EXPECT_NEAR(Found(extruded(egg, 40.0)).length(), 4.0 * 40.0, 1e-9);
}

TEST(TangentEdges, RoundShapesHaveNone) {
    EXPECT_EQ(Found(test::icosphere(3)).sides.size(), 0);
    EXPECT_EQ(Found(test::torus(40, 24, 0.4)).sides.size(), 0);
    EXPECT_EQ(Found(test::stepped_shaft(64)).sides.size(), 0);
    EXPECT_EQ(Found(test::socket(96)).sides.size(), 0);
    EXPECT_EQ(Found(test::box(1.0, 2.0, 3.0, 4)).sides.size(), 0);
    EXPECT_EQ(Found(test::gear(16, 2)).sides.size(), 0);
    std::vector<test::ProfilePoint> cone{{0.0, 0.0}};
    for (int i = 0; i <= 20; ++i) cone.push_back({i == 20 ? 0.0 : 10.0 - 0.5 * i, 1.25 * i});
    EXPECT_EQ(Found(test::turned_part(cone, 64)).sides.size(), 0);
}

TEST(TangentEdges, NoiseHasNone) {
    std::mt19937 random(7);
    for (const double noise : {1e-4, 1e-3, 1e-2})
        for (Triangles mesh : {test::icosphere(4), test::torus(60, 40, 0.4), test::box(1.0, 1.0, 1.0, 12)}) {
            std::normal_distribution<double> off(0.0, noise);
            for (double& x : mesh.vertices) x += off(random);
            EXPECT_EQ(Found(mesh).sides.size(), 0) << noise;
        }
}

} // namespace
} // namespace tangent_edges_test
