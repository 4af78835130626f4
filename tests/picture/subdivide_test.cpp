// SPDX-License-Identifier: MIT
#include "picture/subdivide.h"

#include "mesh_shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace picture_tests::subdivide_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;
using testing::ElementsAre;

class Subdivide : public testing::Test {
protected:
    base::Memory memory;
    Pool pool{memory};

    // Returns a ball of radius 1 with 80 faces.
    Shape ball() { return shape_of(test::icosphere(1), pool); }

    Shape cube() {
        Shape shape(pool);
        for (const double x : {0.0, 1.0})
            for (const double y : {0.0, 1.0})
                for (const double z : {0.0, 1.0}) shape.points.emplace_back(x, y, z);
        using Quad = std::array<std::int64_t, 4>;
        for (const Quad& q : {Quad{0, 1, 3, 2}, Quad{4, 6, 7, 5}, Quad{0, 4, 5, 1}, Quad{2, 3, 7, 6}, Quad{0, 2, 6, 4},
                              Quad{1, 5, 7, 3}}) {
            shape.triangles.push_back({q[0], q[1], q[2]});
            shape.triangles.push_back({q[0], q[2], q[3]});
        }
        return shape;
    }

    // Returns a prism of eight sides, radius 1 and height 2, with sharp rims.
    Shape cylinder(bool knows_rims) {
        Shape shape(pool);
        for (const double z : {0.0, 2.0})
            for (int i = 0; i < sides; ++i) {
                const double turn = 6.283185307179586 * i / sides;
                shape.points.emplace_back(std::cos(turn), std::sin(turn), z);
            }
        join_prism(shape);
        if (!knows_rims) return shape;
        shape.has_sharp_edges = true;
        for (std::int64_t i = 0; i < sides; ++i) {
            const std::int64_t j = (i + 1) % sides;
            shape.sharp_edges.insert(shape.sharp_edges.end(), {{j, i}, {i + sides, j + sides}});
        }
        return shape;
    }

    // Returns a square pillar with chamfers, 2 wide and 4 high.
    Shape pillar() {
        Shape shape(pool);
        for (const double z : {0.0, 4.0}) {
            const std::array<glm::dvec2, sides> ring{
                {{1, 0.9}, {0.9, 1}, {-0.9, 1}, {-1, 0.9}, {-1, -0.9}, {-0.9, -1}, {0.9, -1}, {1, -0.9}}};
            for (const glm::dvec2& p : ring) shape.points.emplace_back(p, z);
        }
        join_prism(shape);
        return shape;
    }

    static constexpr std::int64_t sides = 8;

    static void join_prism(Shape& shape) {
        for (std::int64_t i = 0; i < sides; ++i) {
            const std::int64_t j = (i + 1) % sides;
            shape.triangles.push_back({i, j, j + sides});
            shape.triangles.push_back({i, j + sides, i + sides});
        }
        for (std::int64_t i = 1; i + 1 < sides; ++i) {
            shape.triangles.push_back({0, i + 1, i});
            shape.triangles.push_back({sides, sides + i, sides + i + 1});
        }
    }
};

double volume_of(const Shape& shape) {
    double sum = 0.0;
    for (const Triangle& face : shape.triangles)
        sum += glm::dot(shape.points[static_cast<std::size_t>(face[0])], doubled_area_of(shape.points, face));
    return sum / 6.0;
}

TEST_F(Subdivide, MakesACoarseBallRoundThroughItsVertices) {
    const Shape given = ball();
    const Shape fine = subdivide(given, 3, 60.0, pool);
    ASSERT_EQ(fine.triangles.size(), 64 * given.triangles.size());
    ASSERT_EQ(fine.points.size(), given.triangles.size() * 32 + 2); // This is Euler's formula.
    for (std::size_t i = 0; i < fine.points.size(); ++i) {
        const double radius = glm::length(fine.points[i]);
        if (i < given.points.size()) {
            EXPECT_NEAR(radius, 1.0, 2e-3); // Plain subdivision gives 0.93.
        }
        EXPECT_GT(radius, 0.985); // Middles of the given faces have 0.94.
        EXPECT_LT(radius, 1.005);
    }
    const double ball_volume = 4.0 / 3.0 * 3.141592653589793;
    EXPECT_GT(volume_of(fine), 0.96 * ball_volume);
    EXPECT_LT(volume_of(fine), ball_volume);
    EXPECT_FALSE(fine.has_sharp_edges);
}

TEST_F(Subdivide, MeasuresHowCoarseAMeshIs) {
    const Shape given = ball();
    // Edges are 0.55 long and bend by 16.5 to 18 degrees. The diagonal is 3.4.
    EXPECT_NEAR(coarseness(given, 90.0, pool), 0.00832568926515175, 1e-15);
    EXPECT_NEAR(mean_edge(given, pool), 0.168090774457395, 1e-14);
    const Shape fine = subdivide(given, 3, 60.0, pool);
    EXPECT_LT(coarseness(fine, 90.0, pool), coarseness(given, 90.0, pool) / 40.0);
    const Shape twice = subdivide(given, 2, 60.0, pool);
    const Vector<double> rise = raised(given, twice, parents_of(80, twice.triangles.size(), pool), pool);
    ASSERT_EQ(rise.size(), twice.points.size());
    EXPECT_NEAR(*std::max_element(rise.begin(), rise.end()), 0.01724447870194666, 1e-14);
    Shape point(pool);
    point.points.assign(3, glm::dvec3(1.0));
    point.triangles.push_back({0, 1, 2});
    EXPECT_EQ(mean_edge(point, pool), 0.0);
    EXPECT_EQ(coarseness(point, 90.0, pool), 0.0);
}

TEST_F(Subdivide, KeepsBordersAndTheirCorners) {
    const Shape sheet = shape_of(wall({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 4), pool);
    const Shape fine = subdivide(sheet, 2, 60.0, pool);
    double area = 0.0;
    for (const Triangle& face : fine.triangles) {
        const glm::dvec3 doubled = doubled_area_of(fine.points, face);
        EXPECT_GT(doubled.z, 0.0);
        area += doubled.z / 2.0;
    }
    EXPECT_NEAR(area, 16.0, 1e-12);
    for (const std::size_t corner : {0U, 4U, 20U, 24U}) EXPECT_EQ(fine.points[corner], sheet.points[corner]);
    for (const glm::dvec3& p : fine.points) EXPECT_EQ(p.z, 0.0);
}

TEST_F(Subdivide, KeepsSharpEdgesUnlessTheAngleRoundsAll) {
    const Shape fine = subdivide(cube(), 2, 60.0, pool);
    EXPECT_NEAR(volume_of(fine), 1.0, 1e-12);
    for (const glm::dvec3& p : fine.points) {
        const glm::dvec3 off = glm::min(glm::abs(p), glm::abs(p - 1.0));
        EXPECT_LT(std::min({off.x, off.y, off.z}), 1e-12);
    }
    EXPECT_GT(volume_of(subdivide(cube(), 2, 180.0, pool)), 1.05); // The shape is rounded through the corners.
}

TEST_F(Subdivide, RoundsBetweenTheSharpEdgesOfTheFile) {
    const Shape fine = subdivide(cylinder(true), 3, 180.0, pool);
    ASSERT_TRUE(fine.has_sharp_edges);
    EXPECT_EQ(fine.sharp_edges.size(), 2U * 8U * 8U); // Each edge of both rims is divided in eight.
    for (const glm::dvec3& p : fine.points) {
        EXPECT_GT(p.z, -1e-9);
        EXPECT_LT(p.z, 2.0 + 1e-9);
        if (p.z > 0.05 && p.z < 1.95) {
            EXPECT_GT(std::hypot(p.x, p.y), 0.97); // The sides of the prism have 0.924.
            EXPECT_LT(std::hypot(p.x, p.y), 1.02);
        }
    }
    for (const Edge& edge : fine.sharp_edges)
        for (const std::int64_t end : edge) {
            const double z = fine.points[static_cast<std::size_t>(end)].z;
            EXPECT_LT(std::min(std::abs(z), std::abs(z - 2.0)), 1e-9);
        }
    const Shape round = subdivide(cylinder(false), 3, 180.0, pool);
    const auto higher = [](const glm::dvec3& p) { return p.z > 2.01; };
    EXPECT_TRUE(std::any_of(round.points.begin(), round.points.end(), higher));
}

TEST_F(Subdivide, KeepsBevelsFlatIfTheFileMarksSharpEdges) {
    Shape given = pillar();
    const double volume = volume_of(given);
    EXPECT_GT(std::abs(volume_of(subdivide(given, 2, 180.0, pool)) / volume - 1.0), 0.01);
    given.has_sharp_edges = true; // No edge is sharp.
    const Shape fine = subdivide(given, 2, 180.0, pool);
    EXPECT_NEAR(volume_of(fine), volume, 1e-9);
    for (const glm::dvec3& p : fine.points) {
        const double x = std::abs(p.x), y = std::abs(p.y);
        const bool on_side = std::abs(std::max(x, y) - 1.0) < 1e-9 || std::abs(x + y - 1.9) < 1e-9;
        EXPECT_TRUE(on_side || std::abs(p.z) < 1e-9 || std::abs(p.z - 4.0) < 1e-9);
    }
    EXPECT_NEAR(coarseness(given, 90.0, pool), 0.0, 1e-9);
}

TEST_F(Subdivide, LeavesFinePartsUnchanged) {
    Shape two = cylinder(true);
    const std::size_t faces = two.triangles.size();
    const Shape other = shape_of(test::icosphere(3), pool); // It bulges by 0.0005 of its diagonal.
    for (const glm::dvec3& p : other.points) two.points.push_back(p + 5.0);
    for (Triangle face : other.triangles) {
        for (std::int64_t& corner : face) corner += 16;
        two.triangles.push_back(face);
    }
    const DividedParts made = subdivide_coarse_parts(two, 2, 180.0, 0.002, pool);
    ASSERT_EQ(made.shape.triangles.size(), 16 * faces + other.triangles.size());
    std::map<std::int64_t, int> count;
    for (const std::int64_t parent : made.parents) ++count[parent];
    for (const auto& [parent, parts] : count) EXPECT_EQ(parts, parent < static_cast<std::int64_t>(faces) ? 16 : 1);
    EXPECT_EQ(count.size(), two.triangles.size());
    const Vector<double> rise = raised(two, made.shape, made.parents, pool);
    const double most = *std::max_element(rise.begin(), rise.end());
    EXPECT_GT(most, 0.005); // An eighth of the cylinder bulges by 0.076 of 12.
    EXPECT_LT(most, 0.02);
    const DividedParts same = subdivide_coarse_parts(two, 2, 180.0, 1.0, pool);
    EXPECT_EQ(same.shape.triangles, two.triangles);
    EXPECT_EQ(same.parents.size(), two.triangles.size());
    EXPECT_EQ(same.parents[5], 5);
}

TEST_F(Subdivide, AcceptsEdgesOfThreeFacesAndUnusedVertices) {
    Shape given(pool);
    given.points.assign({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {9, 9, 9}});
    given.triangles.assign({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
    const Shape fine = subdivide(given, 2, 60.0, pool);
    EXPECT_EQ(fine.triangles.size(), 48U);
    for (const glm::dvec3& p : fine.points) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
    for (const std::size_t i : {0U, 1U, 5U}) EXPECT_EQ(fine.points[i], given.points[i]);
}

TEST_F(Subdivide, ChangesNothingInZeroRounds) {
    const Shape given = cylinder(true);
    const Shape same = subdivide(given, 0, 60.0, pool);
    EXPECT_EQ(same.points, given.points);
    EXPECT_EQ(same.triangles, given.triangles);
    EXPECT_EQ(same.sharp_edges, given.sharp_edges);
}

TEST_F(Subdivide, RefusesMeshesItCannotDivide) {
    const auto message = [&](const Shape& shape, std::int32_t rounds) {
        try {
            static_cast<void>(subdivide(shape, rounds, 60.0, pool));
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message(Shape(pool), 1), "there are no faces to subdivide");
    EXPECT_EQ(message(cube(), 7), "rounds is 7; it must be from 0 to 6");
    EXPECT_EQ(message(shape_of(test::icosphere(4), pool), 5),
              "5120 faces become 5242880 after 5 rounds of subdivision, and 4000000 are the most: use fewer rounds");
}

// ---- What it stands on

TEST_F(Subdivide, KnowsTheEdgesOfFaces) {
    const Vector<Triangle> faces({{2, 1, 0}, {1, 2, 3}, {1, 2, 4}}, &pool);
    const FaceEdges edges = find_edges(faces, 5, pool);
    EXPECT_THAT(edges.ends,
                ElementsAre(Edge{0, 1}, Edge{0, 2}, Edge{1, 2}, Edge{1, 3}, Edge{1, 4}, Edge{2, 3}, Edge{2, 4}));
    EXPECT_THAT(edges.sides_of(2), ElementsAre(0, 1, 2)); // These are the sides 0 of faces 0, 1 and 2.
    EXPECT_FALSE(edges.is_plain(2));
    EXPECT_EQ(edges.of_side[3], 0); // Side 1 of face 0 goes from 1 to 0.
    EXPECT_EQ(edges.face(3), 0U);
    EXPECT_EQ(find_edges(Vector<Triangle>(&pool), 0, pool).size(), 0U);
}

TEST_F(Subdivide, PercentilesAndSumsAreCorrect) {
    Vector<double> numbers({5, 1, 4, 2, 3}, &pool);
    EXPECT_EQ(percentile(numbers, 50.0), 3.0);
    EXPECT_DOUBLE_EQ(percentile(numbers, 90.0), 4.6);
    EXPECT_EQ(percentile(numbers, 100.0), 5.0);
    EXPECT_EQ(percentile(numbers, 0.0), 1.0);
    Vector<double> none(&pool);
    EXPECT_EQ(percentile(none, 50.0), 0.0);
    numbers[2] = std::nan("");
    EXPECT_TRUE(std::isnan(percentile(numbers, 50.0)));
    EXPECT_EQ(sum_in_pairs({}), 0.0);
    const Vector<double> thousand(1000, 0.1, &pool);
    EXPECT_NEAR(sum_in_pairs(thousand), 100.0, 1e-13); // A plain sum is off by 1.4e-12.
    EXPECT_TRUE(std::isnan(box_diagonal_of(Points({{0, 0, 0}, {1, std::nan(""), 0}}, &pool))));
    EXPECT_EQ(box_diagonal_of(Points({{1, 2, 3}, {4, 6, 3}}, &pool)), 5.0);
    EXPECT_EQ(box_diagonal_of(Points(&pool)), 0.0);
}

} // namespace
} // namespace picture_tests::subdivide_test
