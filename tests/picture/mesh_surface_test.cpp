// SPDX-License-Identifier: MIT
#include "picture/mesh_surface.h"

#include "mesh_shapes.h"
#include "planned_call.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace picture_tests::mesh_surface_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class MeshSurface : public testing::Test {
protected:
    PlannedCall planned;
    glm::dvec3 up{0.0};

    Vector<Surface> surfaces(const test::Triangles& from) { return surfaces(shape_of(from, planned.pool)); }
    Vector<Surface> surfaces(Shape&& shape) { return fit_mesh(planned.call(), std::move(shape), up); }

    // Returns the notes of the last surfaces().
    [[nodiscard]] std::vector<std::string> notes() const {
        std::vector<std::string> all;
        for (const Note& note : planned.report->notes) all.emplace_back(note.text);
        return all;
    }
    [[nodiscard]] std::vector<std::string> stages() const {
        std::vector<std::string> all;
        for (const FinishedStage& stage : planned.report->stages)
            all.push_back(std::to_string(stage.stage) + ": " + std::string(stage.says));
        return all;
    }
    // Returns the note with a code, or a note with code 0.
    [[nodiscard]] Note note(std::uint32_t code) const {
        for (const Note& one : planned.report->notes)
            if (one.code == code) return one;
        return {};
    }
    std::string refusal(const test::Triangles& from) {
        try {
            static_cast<void>(surfaces(from));
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
};

double greatest_radius(const Points& points) {
    double most = 0.0;
    for (const glm::dvec3& p : points) most = std::max(most, glm::length(p));
    return most;
}

TEST_F(MeshSurface, DividesACoarseBall) {
    planned.desc.tolerance = 0.02;
    const Vector<Surface> made = surfaces(test::icosphere(1));
    ASSERT_EQ(made.size(), 1U);
    ASSERT_TRUE(made[0].model && made[0].mesh && made[0].fit && made[0].shape);
    EXPECT_EQ(made[0].shape->triangles.size(), 320U);
    EXPECT_EQ(info_of(made[0].mesh).faces, 320);
    EXPECT_EQ(made[0].fit->reached, 1U);
    EXPECT_EQ(made[0].fit->tolerance, 0.02);
    EXPECT_NEAR(greatest_radius(made[0].shape->points), 1.0, 5e-3);
    ASSERT_EQ(notes().size(), 1U);
    EXPECT_EQ(notes()[0], "the faces are coarse: divided 1 time and rounded (--subdivide 0 leaves them)");
    const Note divided = note(HRBFNPR_NOTE_DIVIDED);
    ASSERT_EQ(divided.figure_count, 4U);
    EXPECT_EQ(divided.figures[0], 1.0);
    EXPECT_NEAR(divided.figures[3], 0.00832568926515175, 1e-9);
    // A closed mesh whose fit is near everywhere has no end to search for.
    ASSERT_EQ(stages().size(), 3U);
    EXPECT_EQ(stages()[0], "1: 1 part, closed");
    EXPECT_EQ(stages()[1], "2: 2000 samples, to check which way faces look");
    EXPECT_THAT(stages()[2], HasSubstr(" centres in "));
    EXPECT_THAT(stages()[2], HasSubstr("; 99% of surface and mesh are within "));
    EXPECT_EQ(up, glm::dvec3(0, 1, 0));
}

TEST_F(MeshSurface, DoesNotDivideSharpOrExcludedMeshes) {
    planned.desc.flags = HRBFNPR_PICTURE_CLOSE;
    planned.desc.tolerance = 0.1;
    planned.desc.subdivide = 0;
    EXPECT_EQ(surfaces(test::icosphere(1))[0].shape->triangles.size(), 80U);
    EXPECT_THAT(notes(), IsEmpty());
    planned.desc.subdivide = -1;
    planned.desc.edges = HRBFNPR_PICTURE_EDGES_SHARP;
    EXPECT_EQ(surfaces(test::icosphere(1))[0].shape->triangles.size(), 80U);
    planned.desc.edges = HRBFNPR_PICTURE_EDGES_AS_GIVEN;
    EXPECT_EQ(surfaces(test::box(1, 1, 1, 1))[0].fit->sheets, 6); // The edges of a box are sharp.
    EXPECT_THAT(notes(), IsEmpty());
}

TEST_F(MeshSurface, DividesTheGivenNumberOfTimes) {
    planned.desc.flags = HRBFNPR_PICTURE_CLOSE;
    planned.desc.tolerance = 0.1;
    planned.desc.subdivide = 1;
    EXPECT_EQ(surfaces(test::box(1, 1, 1, 1))[0].shape->triangles.size(), 48U);
    ASSERT_EQ(notes().size(), 1U);
    EXPECT_EQ(notes()[0], "the faces are divided 1 time");
    EXPECT_THAT(std::string(note(HRBFNPR_NOTE_DIVIDED).detail),
                testing::StartsWith("Vertices moved by up to 3.39% of the diagonal, "));
    EXPECT_EQ(note(HRBFNPR_NOTE_DIVIDED).figure_count, 3U);
    planned.desc.subdivide = 6;
    EXPECT_THAT(refusal(test::icosphere(3)), HasSubstr("and 4000000 are the most: use fewer rounds"));
}

TEST_F(MeshSurface, UsesTheSharpEdgesOfAFile) {
    planned.desc.flags = HRBFNPR_PICTURE_CLOSE;
    planned.desc.tolerance = 0.02;
    Shape ball = shape_of(test::icosphere(1), planned.pool);
    ball.has_sharp_edges = true;
    ball.sharp_edges = find_edges(ball.triangles, ball.points.size(), planned.pool).ends;
    const Vector<Surface> flat = surfaces(std::move(ball));
    EXPECT_THAT(notes(), ElementsAre("all faces are flat, by the normals in the file (--edges smooth rounds them)"));
    EXPECT_GT(flat[0].fit->sheets, 40);
}

TEST_F(MeshSurface, CrossingPartsBecomeSurfaces) {
    planned.desc.tolerance = 0.1;
    const test::Triangles walls =
        wall({0, 0, 0}, {1, 0, 0.6}, {0, 1, 0}, 6).with(wall({0, 0.1, 0.6}, {1, 0, -0.6}, {0, 1, 0}, 6));
    const Vector<Surface> two = surfaces(walls);
    ASSERT_EQ(two.size(), 2U);
    for (const Surface& one : two) EXPECT_EQ(one.shape->triangles.size(), info_of(one.mesh).faces);
    EXPECT_THAT(notes(), Contains("2 parts cross or nearly touch: drawn as 2 surfaces (--together joins them)"));
    const auto fits = [&] {
        int count = 0;
        for (const FinishedStage& stage : planned.report->stages) count += stage.stage == HRBFNPR_STAGE_FIT ? 1 : 0;
        return count;
    };
    EXPECT_EQ(fits(), 2);
    planned.desc.flags = HRBFNPR_PICTURE_TOGETHER | HRBFNPR_PICTURE_CLOSE;
    const Vector<Surface> one = surfaces(walls);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(fits(), 1);
    EXPECT_EQ(note(HRBFNPR_NOTE_GROUPS).code, 0U);
    // The library's own findings on a mesh become warnings.
    const Note thin = note(HRBFNPR_NOTE_PARTS_TOO_THIN);
    EXPECT_EQ(thin.severity, HRBFNPR_SEVERITY_WARNING);
    EXPECT_EQ(thin.figure_count, 5U);
    const std::string text(thin.text);
    EXPECT_EQ(text, "parts 0 and 1 cross or nearly touch, and may be joined: try a smaller --tolerance");
    EXPECT_THAT(std::string(thin.detail), testing::StartsWith("They come closer than the tolerance near "));
}

TEST_F(MeshSurface, TurnsAnInsideOutMesh) {
    planned.desc.flags = HRBFNPR_PICTURE_CLOSE;
    planned.desc.tolerance = 0.1;
    planned.desc.subdivide = 0;
    EXPECT_EQ(info_of(surfaces(test::icosphere(1).turned())[0].mesh).turned_components, 1);
    EXPECT_THAT(notes(), ElementsAre("the mesh was inside out: its faces are turned"));
}

TEST_F(MeshSurface, TurnsATerrainThatLooksDown) {
    planned.desc.tolerance = 0.1;
    planned.desc.flags = HRBFNPR_PICTURE_CLOSE;
    test::Triangles terrain = wall({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    for (std::size_t i = 0; i < terrain.vertices.size(); i += 3)
        terrain.vertices[i + 2] = 0.05 * std::sin(6.0 * terrain.vertices[i]) * std::cos(5.0 * terrain.vertices[i + 1]);
    const auto height_of_first_face = [&](const Surface& of) {
        const Triangle face = triangles_of(of.mesh, planned.pool).front();
        return doubled_area_of(vertices_of(of.mesh, planned.pool), face).z;
    };
    const Vector<Surface> turned = surfaces(terrain.turned());
    EXPECT_THAT(notes(), Contains("the terrain faced down along z: its normals are turned (--normals "
                                  "keep leaves them)"));
    EXPECT_EQ(note(HRBFNPR_NOTE_TERRAIN_TURNED).figures[0], 2.0);
    EXPECT_GT(height_of_first_face(turned[0]), 0.0);
    planned.desc.normals = HRBFNPR_NORMALS_GIVEN;
    const Vector<Surface> kept = surfaces(terrain.turned());
    EXPECT_THAT(notes(), Not(Contains(HasSubstr("looked down"))));
    EXPECT_LT(height_of_first_face(kept[0]), 0.0);
}

TEST_F(MeshSurface, LeavesOutTinyDistantParts) {
    planned.desc.flags = HRBFNPR_PICTURE_CLOSE;
    planned.desc.tolerance = 0.1;
    test::Triangles mesh = test::icosphere(3);
    const std::int32_t a = mesh.add(60, 0, 0), b = mesh.add(60, 0.05, 0), c = mesh.add(60, 0, 0.05);
    mesh.face(a, b, c);
    EXPECT_EQ(info_of(surfaces(mesh)[0].mesh).faces, 1280);
    EXPECT_THAT(notes(), ElementsAre("1 part (1 face) far from all others left out; --parts all keeps them"));
    EXPECT_THAT(stages()[0], HasSubstr("1 part, closed"));
}

// Returns whether places are inside the surface.
std::vector<bool> are_inside(const Surface& surface, std::initializer_list<glm::dvec3> places, Pool& pool) {
    const Points points(places, &pool);
    Vector<double> value(points.size(), 0.0, &pool);
    const hrbfnpr_array at = view_of(points);
    const hrbfnpr_array_out out{value.data(), at.count, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    picture::call([&](hrbfnpr_error* error) {
        return hrbfnpr_model_evaluate(surface.model.get(), &at, &out, nullptr, nullptr, nullptr, error);
    });
    std::vector<bool> inside;
    for (const double f : value) inside.push_back(f < 0.0);
    return inside;
}

// A box with two cavities, one of which is wound the wrong way and holds a solid, beside a box without cavities.
TEST_F(MeshSurface, KeepsCavitiesWhereHiddenLinesOrASectionShowThem) {
    const auto cube = [](double half, double x) {
        return test::box(2 * half, 2 * half, 2 * half, 1).moved(1.0, x - half, -half, -half);
    };
    const test::Triangles from = test::box(6, 2, 2, 1)
                                     .moved(1.0, -3, -1, -1)
                                     .with(cube(0.6, -1.5))
                                     .with(cube(0.25, -1.5).turned())
                                     .with(cube(0.6, 1.5).turned())
                                     .with(cube(1.0, 6.0));
    const std::initializer_list<glm::dvec3> places{{0, 0, 0}, {-1.9, 0, 0}, {-1.5, 0, 0}, {1.5, 0, 0}, {6, 0, 0}};
    const auto inside = [&] { return are_inside(surfaces(from)[0], places, planned.pool); };
    EXPECT_THAT(inside(), ElementsAre(true, true, true, true, true));
    EXPECT_THAT(notes(), Contains(HasSubstr("3 parts inside others left out (36 faces)")));
    planned.desc.preset = HRBFNPR_PRESET_BLUEPRINT;
    EXPECT_THAT(inside(), ElementsAre(true, false, true, false, true));
    EXPECT_THAT(notes(), Not(Contains(HasSubstr("left out"))));
    EXPECT_EQ(stages()[0], "1: 5 parts, 2 cavities, closed");
    planned.desc.parts = HRBFNPR_PARTS_OUTER;
    EXPECT_THAT(inside(), ElementsAre(true, true, true, true, true));
    planned.desc.parts = HRBFNPR_PARTS_AUTO;
    planned.desc.preset = HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    planned.desc.profile = HRBFNPR_PROFILE_YES;
    EXPECT_THAT(inside(), ElementsAre(true, false, true, false, true));
    planned.desc.profile = HRBFNPR_PROFILE_NO;
    planned.desc.parts = HRBFNPR_PARTS_SOLIDS;
    EXPECT_THAT(inside(), ElementsAre(true, false, true, false, true));
}

TEST_F(MeshSurface, UsesTheGivenNumberOfSamples) {
    planned.desc.samples = 200;
    const Vector<Surface> made = surfaces(test::icosphere(3));
    ASSERT_EQ(made.size(), 1U);
    EXPECT_FALSE(made[0].fit);
    EXPECT_EQ(stages()[1], "2: 200 samples");
    ASSERT_EQ(stages().size(), 5U);
    EXPECT_THAT(stages()[2], HasSubstr("200 centres"));
    EXPECT_EQ(stages()[3][0], '6'); // Stage 6 compares the surface with the mesh.
    planned.desc.samples = 1'000'000'000;
    EXPECT_EQ(refusal(test::icosphere(0)), "--samples 1000000000 is too many for a mesh: give 10000000 at most");
}

TEST_F(MeshSurface, FitsSamplesIfAnOptionNeedsIt) {
    const auto chooses = [&] { return surfaces(test::icosphere(1))[0].fit.has_value(); };
    planned.desc.subdivide = 0;
    planned.desc.tolerance = 0.1;
    planned.desc.flags = HRBFNPR_PICTURE_CLOSE;
    EXPECT_TRUE(chooses());
    planned.desc.flags |= HRBFNPR_PICTURE_FLIP;
    planned.desc.tolerance = 0.0;
    planned.desc.samples = 60;
    EXPECT_FALSE(chooses());
    planned.desc.flags = HRBFNPR_PICTURE_CLOSE;
    EXPECT_FALSE(chooses());
    planned.desc.samples = 0;
    planned.desc.maximum_centres = 100;
    planned.change("fit.outliers", "drop");
    EXPECT_FALSE(chooses());
    EXPECT_EQ(stages()[1], "2: 1000 samples");
}

TEST_F(MeshSurface, ReportsAToleranceThatIsNotReached) {
    planned.desc.flags = HRBFNPR_PICTURE_CLOSE;
    planned.desc.maximum_centres = 20;
    planned.desc.subdivide = 0;
    static_cast<void>(surfaces(test::torus(24, 12, 0.4)));
    const std::string text(note(HRBFNPR_NOTE_NOT_REACHED).text);
    EXPECT_EQ(text.find("the surface is over 0.20% of the diagonal off the mesh in places: "), 0U);
    EXPECT_THAT(text, HasSubstr(": --max-centres 40 helps"));
}

TEST_F(MeshSurface, RefusesAMeshWithoutArea) {
    test::Triangles flat;
    for (int i = 0; i < 3; ++i) static_cast<void>(flat.add(i, 0, 0));
    flat.face(0, 1, 2);
    EXPECT_THAT(refusal(flat), HasSubstr("area"));
}

TEST_F(MeshSurface, AcceptsASingleFlatFace) {
    const Vector<Surface> made = surfaces(wall({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1));
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(info_of(made[0].mesh).faces, 2);
    EXPECT_THAT(notes(), Contains("all points lie in a plane: the surface is flat and ends where they do"));
}

} // namespace
} // namespace picture_tests::mesh_surface_test
