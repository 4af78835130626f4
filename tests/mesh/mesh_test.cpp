// SPDX-License-Identifier: MIT
#include "mesh/mesh.h"

#include "base/status.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>

namespace mesh_test {

namespace mesh = hrbfnpr::mesh;
using hrbfnpr::test::box;
using hrbfnpr::test::icosphere;
using hrbfnpr::test::torus;
using mesh::Mesh;
using mesh::Parts;
using namespace mesh_test;

namespace {

const hrbfnpr::base::Runtime& runtime() {
    static const hrbfnpr::base::Runtime instance;
    return instance;
}

constexpr double pi = 3.141592653589793;

TEST(MakeMesh, ASphereIsClosedWithGenusZero) {
    const Mesh sphere = made(runtime(), icosphere(4));
    EXPECT_TRUE(sphere.report.closed);
    EXPECT_EQ(sphere.report.euler_characteristic, 2);
    EXPECT_EQ(sphere.report.genus, 0);
    EXPECT_EQ(sphere.report.components, 1);
    EXPECT_EQ(sphere.report.turned_faces + sphere.report.turned_components, 0);
    EXPECT_NEAR(sphere.report.area, 4.0 * pi, 0.03);
    EXPECT_NEAR(sphere.report.volume, 4.0 / 3.0 * pi, 0.02);
    EXPECT_EQ(sphere.faces(), 20 * 256);
}

TEST(MakeMesh, EachTorusAddsOneToTheGenus) {
    EXPECT_EQ(made(runtime(), torus(40, 20, 0.3)).report.genus, 1);
    const Mesh two = made(runtime(), torus(40, 20, 0.3).with(torus(40, 20, 0.3).moved(1.0, 5.0, 0.0, 0.0)));
    EXPECT_EQ(two.report.genus, 2);
    EXPECT_EQ(two.report.components, 2);
    EXPECT_EQ(two.component[0], 0);
    EXPECT_EQ(two.component[two.faces() - 1], 1);
}

// The corners of each face were computed separately and nearly coincide. Corners that are farther apart leave a gap.
TEST(MakeMesh, JoinsBorderVerticesThatDifferByRounding) {
    for (const double off : {1e-7, 3e-6}) {
        Triangles soup = icosphere(3).unwelded();
        for (std::size_t i = 0; i < soup.vertices.size(); ++i)
            soup.vertices[i] += off * std::sin(12.9898 * static_cast<double>(i));
        const Mesh welded = made(runtime(), soup);
        EXPECT_EQ(welded.report.closed, off < 1e-6) << off;
        if (!welded.report.closed) continue;
        EXPECT_EQ(welded.vertex.size(), 642);
        EXPECT_EQ(welded.report.welded_vertices, 3 * 20 * 64 - 642);
        EXPECT_EQ(welded.report.components, 1);
    }
    // Only borders are joined: a closed mesh keeps even its smallest faces.
    const Triangles small = icosphere(2).moved(1e-7, 0.9, 0.0, 0.0);
    EXPECT_EQ(made(runtime(), icosphere(2).with(small), Parts::all).faces(), 2 * 20 * 16);
}

TEST(MakeMesh, JoinsCoincidentVertices) {
    const Mesh welded = made(runtime(), icosphere(3).unwelded());
    EXPECT_EQ(welded.vertex.size(), 642);
    EXPECT_EQ(welded.report.welded_vertices, 3 * 20 * 64 - 642);
    EXPECT_EQ(welded.report.genus, 0);
    // The box's faces share their edges, as -0 equals 0.
    Triangles cube = box(1, 1, 1, 3);
    for (std::size_t i = 0; i < cube.vertices.size(); i += 2)
        if (cube.vertices[i] == 0.0) cube.vertices[i] = -0.0;
    EXPECT_TRUE(made(runtime(), cube).report.closed);
}

TEST(MakeMesh, LeavesOutDegenerateAndRepeatedFaces) {
    Triangles from = icosphere(2);
    from.face(0, 0, 1);
    from.face(from.triangles[1], from.triangles[2], from.triangles[0]);
    from.face(from.triangles[4], from.triangles[3], from.triangles[5]);
    const std::int32_t a = from.add(5, 0, 0), b = from.add(6, 0, 0), c = from.add(7, 0, 0);
    from.face(a, b, c);
    const Mesh kept = made(runtime(), from);
    EXPECT_EQ(kept.report.degenerate_faces, 2);
    EXPECT_EQ(kept.report.repeated_faces, 2);
    EXPECT_EQ(kept.faces(), 320);
    EXPECT_EQ(kept.vertex.size(), 162) << "vertices that no face has any more";
    EXPECT_EQ(kept.report.given_faces, 324);
    EXPECT_TRUE(kept.report.closed);
    EXPECT_EQ(kept.given_face[319], 319);
}

TEST(MakeMesh, TurnsFacesToAgreeWithNeighbours) {
    Triangles from = icosphere(3);
    for (std::size_t face = 0; face < from.faces(); face += 3)
        std::swap(from.triangles[3 * face], from.triangles[3 * face + 1]);
    const Mesh turned = made(runtime(), from);
    EXPECT_EQ(turned.report.contrary_edges, 0);
    EXPECT_EQ(turned.report.turned_faces, 427); // every third of 1280
    EXPECT_GT(turned.report.volume, 4.0);
    mesh::MeshInput as_it_is = input(from);
    as_it_is.faces = mesh::Faces::keep;
    EXPECT_GT(mesh::make_mesh(runtime(), as_it_is).report.contrary_edges, 800);
}

TEST(MakeMesh, TurnsAClosedInsideOutMesh) {
    const Mesh turned = made(runtime(), icosphere(3).turned());
    EXPECT_EQ(turned.report.turned_components, 1);
    EXPECT_GT(turned.report.volume, 4.0);
    const auto p = turned.corners(0);
    EXPECT_GT(glm::dot(mesh::doubled_area(p), p[0]), 0.0);
    const Triangles from = icosphere(3).turned();
    mesh::MeshInput as_it_is = input(from);
    as_it_is.faces = mesh::Faces::keep;
    EXPECT_LT(mesh::make_mesh(runtime(), as_it_is).report.volume, -4.0);
}

TEST(MakeMesh, TurnsAnInsideOutMeshWithHoles) {
    const auto holed = [](double, double y, double z) { return z > -0.9 && y < 0.9; };
    const Mesh right = made(runtime(), icosphere(4).where(holed));
    EXPECT_FALSE(right.report.closed);
    EXPECT_EQ(right.report.boundary_loops, 2);
    EXPECT_EQ(right.report.turned_components, 0);
    EXPECT_TRUE(std::isnan(right.report.volume));
    EXPECT_EQ(made(runtime(), icosphere(4).turned().where(holed)).report.turned_components, 1);
}

TEST(MakeMesh, DoesNotTurnABowl) {
    const auto half = [](double, double, double z) { return z > 0.0; };
    EXPECT_EQ(made(runtime(), icosphere(4).where(half)).report.turned_components, 0);
    const Mesh bowl = made(runtime(), icosphere(4).turned().where(half));
    EXPECT_EQ(bowl.report.turned_components, 0);
    EXPECT_EQ(bowl.report.boundary_loops, 1);
    EXPECT_EQ(bowl.report.genus, -1);
}

TEST(MakeMesh, LeavesOutNestedParts) {
    const Triangles nested = icosphere(3).with(icosphere(3).moved(0.5, 0, 0, 0)).with(icosphere(2).moved(0.2, 0, 0, 0));
    const Triangles apart = nested.with(icosphere(2).moved(0.3, 2, 0, 0)).with(icosphere(2).moved(0.3, 1.0, 0, 0));
    const Mesh outer = made(runtime(), apart);
    EXPECT_EQ(outer.report.components, 5);
    EXPECT_EQ(outer.report.nested_components, 2);
    EXPECT_EQ(outer.report.left_out_components, 2);
    EXPECT_EQ(outer.report.left_out_faces, 1280 + 320);
    EXPECT_EQ(outer.faces(), 1280 + 320 + 320) << "what overlaps stays";
    const Mesh all = made(runtime(), apart, Parts::all);
    EXPECT_EQ(all.report.nested_components, 2);
    EXPECT_EQ(all.report.left_out_components, 0);
    EXPECT_EQ(all.faces(), 2 * 1280 + 3 * 320);
    const Mesh largest = made(runtime(), apart, Parts::largest);
    EXPECT_EQ(largest.report.left_out_components, 4);
    EXPECT_EQ(largest.faces(), 1280);
    EXPECT_EQ(largest.bounds.max.x, 1.0);
}

// A ball, a cavity in it, and a ball in the cavity, with all combinations of windings.
TEST(MakeMesh, CavitiesFaceInwardWhateverTheirWinding) {
    const auto volume = [](double radius) { return 4.0 / 3.0 * pi * radius * radius * radius; };
    for (unsigned windings = 0; windings < 8; ++windings)
        for (const Parts parts : {Parts::all, Parts::solids}) {
            Triangles nested;
            unsigned number = 0;
            for (const double radius : {1.0, 0.6, 0.3}) {
                const Triangles ball = icosphere(4).moved(radius, 0, 0, 0);
                nested = nested.with((windings >> number++ & 1U) != 0 ? ball.turned() : ball);
            }
            const Mesh mesh = made(runtime(), nested, parts);
            EXPECT_EQ(mesh.report.cavities, 1) << windings;
            EXPECT_EQ(mesh.report.nested_components, 2) << windings;
            EXPECT_EQ(mesh.report.left_out_components, 0) << windings;
            EXPECT_EQ(mesh.report.turned_components, std::popcount(windings ^ 2U)) << windings;
            EXPECT_NEAR(mesh.report.volume, volume(1.0) - volume(0.6) + volume(0.3), 0.03) << windings;
        }
}

TEST(MakeMesh, OpenPartsInsideOthersAreNoSolids) {
    const Triangles from =
        icosphere(4).with(icosphere(4).moved(0.5, 0, 0, 0).where([](double, double, double z) { return z < 0.0; }));
    EXPECT_EQ(made(runtime(), from, Parts::all).report.left_out_components, 0);
    const Mesh solids = made(runtime(), from, Parts::solids);
    EXPECT_EQ(solids.report.left_out_components, 1);
    EXPECT_EQ(solids.report.cavities, 0);
    EXPECT_TRUE(solids.report.closed);
}

// A ball of radius 1. Its faces are stored column by column, each column from the upper pole down.
Triangles ball_of_columns(int columns, int rows) {
    Triangles ball;
    const std::int32_t top = ball.add(0, 0, 1), bottom = ball.add(0, 0, -1);
    std::vector<std::vector<std::int32_t>> column(static_cast<std::size_t>(columns));
    for (int i = 0; i < columns; ++i)
        for (int j = 1; j < rows; ++j) {
            const double along = pi * j / rows, around = 2.0 * pi * i / columns;
            column[static_cast<std::size_t>(i)].push_back(
                ball.add(std::sin(along) * std::cos(around), std::sin(along) * std::sin(around), std::cos(along)));
        }
    for (std::size_t i = 0; i < column.size(); ++i) {
        const auto& here = column[i];
        const auto& next = column[(i + 1) % column.size()];
        ball.face(top, here.front(), next.front());
        for (std::size_t j = 0; j + 1 < here.size(); ++j) {
            ball.face(here[j], here[j + 1], next[j + 1]);
            ball.face(here[j], next[j + 1], next[j]);
        }
        ball.face(here.back(), bottom, next.back());
    }
    return ball;
}

// If every n-th face is tested, these may all be at the same place of their column.
TEST(MakeMesh, KeepsOverlappingBalls) {
    const Triangles ball = ball_of_columns(48, 24);
    const Mesh man = made(runtime(), ball.with(ball.moved(0.7, 0, 0, 1.4)).with(ball.moved(0.5, 0, 0, 2.3)));
    EXPECT_EQ(man.report.components, 3);
    EXPECT_EQ(man.report.nested_components, 0);
    EXPECT_EQ(man.faces(), 3 * 2208);
}

// The centres of all faces of the turned square are inside or on the other square. Its corners are not.
TEST(MakeMesh, KeepsPartsWhoseCornersStandOut) {
    const Triangles square = box(2.0, 2.0, 1.0, 1).moved(1.0, -1.0, -1.0, 0.0);
    for (const double low : {0.0, 0.1}) {
        Triangles turned = square.moved(std::sqrt(0.5), 0.0, 0.0, low);
        for (std::size_t i = 0; i < turned.vertices.size(); i += 3) {
            const double x = turned.vertices[i];
            turned.vertices[i] = x - turned.vertices[i + 1];
            turned.vertices[i + 1] += x;
        }
        const Mesh star = made(runtime(), square.with(turned));
        EXPECT_EQ(star.report.nested_components, 0) << low;
        EXPECT_EQ(star.faces(), 24) << low;
    }
}

TEST(MakeMesh, KeepsCavitiesWithAllParts) {
    const Triangles shell = icosphere(3).with(icosphere(3).turned().moved(0.8, 0, 0, 0));
    const Mesh all = made(runtime(), shell, Parts::all);
    EXPECT_EQ(all.report.turned_components, 0);
    EXPECT_NEAR(all.report.volume, 4.0 / 3.0 * pi * (1.0 - 0.512), 0.05);
    // An open mesh has no inside.
    const auto half = [](double, double, double z) { return z > 0.0; };
    EXPECT_EQ(
        made(runtime(), icosphere(3).where(half).with(icosphere(2).moved(0.2, 0, 0, 0.5))).report.nested_components, 0);
}

TEST(MakeMesh, CountsEdgesOfThreeFaces) {
    Triangles fin = box(1, 1, 1, 1);
    const std::int32_t tip = fin.add(0.5, 0.5, 2.0);
    const std::int32_t a = fin.add(0, 0, 1), b = fin.add(1, 1, 1);
    fin.face(a, b, tip); // on the diagonal of the lid
    const Mesh kept = made(runtime(), fin);
    EXPECT_EQ(kept.report.nonmanifold_edges, 1);
    EXPECT_EQ(kept.report.boundary_edges, 2);
    EXPECT_FALSE(kept.report.closed);
}

TEST(MakeMesh, ReportsThatAMoebiusStripCannotBeOriented) {
    Triangles strip;
    constexpr int count = 20;
    for (int i = 0; i < count; ++i)
        for (const double w : {-0.2, 0.2}) {
            const double t = 2.0 * pi * i / count;
            const double r = 1.0 + w * std::cos(0.5 * t);
            static_cast<void>(strip.add(r * std::cos(t), r * std::sin(t), w * std::sin(0.5 * t)));
        }
    for (int i = 0; i < count; ++i) {
        const bool last = i + 1 == count;
        const int a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
        strip.face(a, c, d);
        strip.face(a, d, b);
    }
    const Mesh kept = made(runtime(), strip);
    EXPECT_GT(kept.report.contrary_edges, 0);
    EXPECT_EQ(kept.report.boundary_loops, 1);
}

TEST(MakeMesh, HasNormalsThatKeepCreases) {
    const Mesh cube = made(runtime(), box(1, 1, 1, 4));
    for (std::int64_t corner = 0; corner < 3 * cube.faces(); ++corner)
        EXPECT_NEAR(
            glm::distance(cube.corner_normal[corner], glm::normalize(mesh::doubled_area(cube.corners(corner / 3)))),
            0.0, 1e-12);
    const Triangles from = box(1, 1, 1, 4);
    mesh::MeshInput smooth = input(from);
    smooth.crease_angle = 180.0;
    const Mesh rounded = mesh::make_mesh(runtime(), smooth);
    double most = 0.0;
    for (std::int64_t corner = 0; corner < 3 * rounded.faces(); ++corner)
        most = std::max(most, glm::distance(rounded.corner_normal[corner],
                                            glm::normalize(mesh::doubled_area(rounded.corners(corner / 3)))));
    EXPECT_GT(most, 0.5);
    const Mesh sphere = made(runtime(), icosphere(4));
    for (std::int64_t corner = 0; corner < 3 * sphere.faces(); ++corner)
        EXPECT_LT(glm::distance(sphere.corner_normal[corner],
                                sphere.vertex[sphere.triangle[corner / 3][static_cast<std::size_t>(corner % 3)]]),
                  0.01);
}

TEST(MakeMesh, KnowsPointsOnItsBorder) {
    Triangles sheet;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) static_cast<void>(sheet.add(i, j, 0));
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            const int a = 3 * i + j;
            sheet.face(a, a + 3, a + 4);
            sheet.face(a, a + 4, a + 1);
        }
    const Mesh made = mesh_test::made(runtime(), sheet);
    for (std::int64_t face = 0; face < made.faces(); ++face)
        for (int i = 0; i <= 4; ++i)
            for (int j = 0; i + j <= 4; ++j) {
                const auto p = made.corners(face);
                const glm::dvec3 place = p[0] + 0.25 * i * (p[1] - p[0]) + 0.25 * j * (p[2] - p[0]);
                const double in = std::min({place.x, 2.0 - place.x, place.y, 2.0 - place.y});
                EXPECT_EQ(mesh::on_border(made, face, place), in < 1e-12) << place.x << " " << place.y;
            }
}

std::string message_of(const mesh::MeshInput& desc) {
    try {
        static_cast<void>(mesh::make_mesh(runtime(), desc));
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), hrbfnpr::Status::invalid_argument);
        return error.what();
    }
    return "no error";
}

TEST(MakeMesh, NamesTheFaceAndTheIndexThatIsOutOfRange) {
    Triangles from = icosphere(1);
    from.triangles[3 * 7 + 1] = 42;
    EXPECT_NE(message_of(input(from)).find("triangles[7] has the index 42; there are 42 vertices"), std::string::npos);
    from.triangles[3 * 7 + 1] = -1;
    EXPECT_NE(message_of(input(from)).find("triangles[7] has the index -1"), std::string::npos);
    from = icosphere(1);
    std::vector<std::int64_t> wide(from.triangles.begin(), from.triangles.end());
    wide[5] = std::int64_t{1} << 53U | 1;
    mesh::MeshInput desc = input(from);
    desc.triangles.data = reinterpret_cast<const std::byte*>(wide.data());
    desc.triangles.stride = 24;
    desc.triangles.scalar = hrbfnpr::base::Scalar::int64;
    EXPECT_NE(message_of(desc).find("triangles[1] has the index 9007199254740993"), std::string::npos);
    from.vertices[4] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(message_of(input(from)).find("vertices[1], a corner of triangles["), std::string::npos);
    Triangles flat;
    flat.face(flat.add(0, 0, 0), flat.add(1, 0, 0), flat.add(2, 0, 0));
    EXPECT_NE(message_of(input(flat)).find("1 faces, but none has an area"), std::string::npos);
}

TEST(MakeMesh, IgnoresUnusedVertices) {
    Triangles from = icosphere(2);
    static_cast<void>(from.add(std::numeric_limits<double>::infinity(), 0, 0));
    EXPECT_EQ(made(runtime(), from).vertex.size(), 162);
}

} // namespace

} // namespace mesh_test
