// SPDX-License-Identifier: MIT
#include "mesh/pieces/fit_as_planned.h"

#include "mesh/meshes.h"
#include "support/runtime.h"
#include "support/sharp_meshes.h"
#include "support/verdict_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fit_as_planned_test {

namespace mesh = hrbfnpr::mesh;
namespace test = hrbfnpr::test;
namespace verdict = hrbfnpr::test::verdict;
using hrbfnpr::test::Triangles;

namespace {

struct Planned {
    explicit Planned(const Triangles& from)
        : runtime(test::with_threads(2)), shape(mesh_test::made(runtime, from, mesh::Parts::all)),
          tree(runtime, shape.vertex, shape.triangle),
          known(mesh::look_for_creases(runtime, shape, mesh::default_crease_angle)) {}

    [[nodiscard]] mesh::PlannedCreases creases(mesh::Edges edges, double angle = mesh::default_crease_angle) const {
        mesh::FitMeshSettings settings;
        settings.edges = edges;
        settings.crease_angle = angle;
        return mesh::find_planned_creases(runtime, shape, tree, known, settings);
    }

    // Distances are in units of the diagonal.
    [[nodiscard]] mesh::EndPlan end(bool reached, double mesh_p99, double surface_most, bool has_creases) const {
        const double diagonal = shape.bounds.diagonal();
        mesh::FitMeshReport report;
        report.reached = reached;
        report.mesh.p99 = report.surface.p99 = mesh_p99 * diagonal;
        report.surface.most = surface_most * diagonal;
        return mesh::plan_end(mesh::end_facts(shape, report, has_creases), true);
    }

    hrbfnpr::base::Runtime runtime;
    mesh::Mesh shape;
    mesh::FaceTree tree;
    mesh::CreaseEvidence known;
};

// A square with `cells` tiles along each side. Each tile has eight faces that are not quite in a plane, and bends at
// its sides by about 60 degrees.
Triangles folded(int cells) {
    const double period = 4.0 / cells;
    return test::height_field(2 * cells, [=](double x, double y) {
        const auto zigzag = [=](double t) { return std::abs(t / period - std::round(t / period)); };
        const double uneven = 0.02 * std::sin(300.0 * x) * std::sin(500.0 * y);
        return period * (0.7 * (zigzag(x) + zigzag(y)) + uneven);
    });
}

TEST(FitAsPlanned, FoldsAsNarrowAsFacesAreSmooth) {
    const Planned fine(folded(60));
    EXPECT_TRUE(fine.known.creases);
    const mesh::PlannedCreases plan = fine.creases(mesh::Edges::automatic);
    EXPECT_FALSE(plan.creases);
    EXPECT_GT(plan.doubtful, 10.0);
    const mesh::PlannedCreases asked = fine.creases(mesh::Edges::sharp);
    ASSERT_TRUE(asked.creases);
    EXPECT_EQ(asked.creases->patches, 60 * 60);
    const Planned coarse(folded(30));
    const mesh::PlannedCreases few = coarse.creases(mesh::Edges::automatic);
    ASSERT_TRUE(few.creases); // a fit of few sheets takes little time
    EXPECT_EQ(few.creases->patches, 30 * 30);
}

TEST(FitAsPlanned, ABallHasNoCreasesAndABoxHas) {
    const Planned ball(test::icosphere(3));
    EXPECT_FALSE(ball.creases(mesh::Edges::automatic).creases);
    EXPECT_EQ(ball.creases(mesh::Edges::automatic).doubtful, 0.0);
    const Planned box(test::box(1, 1, 1, 2));
    const mesh::PlannedCreases plan = box.creases(mesh::Edges::automatic);
    ASSERT_TRUE(plan.creases);
    EXPECT_EQ(plan.creases->patches, 6);
    EXPECT_FALSE(box.creases(mesh::Edges::smooth).creases);
    EXPECT_FALSE(ball.creases(mesh::Edges::sharp, 95.0).creases);   // no edge bends by more
    EXPECT_TRUE(box.creases(mesh::Edges::automatic, 40.0).creases); // another angle than that of the known evidence
}

TEST(FitAsPlanned, EdgesThatDoNotStandOutAreDoubtful) {
    const Planned coarse(test::icosphere(1));
    const mesh::PlannedCreases plan = coarse.creases(mesh::Edges::automatic, 16.0);
    EXPECT_FALSE(plan.creases);
    EXPECT_GT(plan.doubtful, 1.0);
    EXPECT_EQ(coarse.creases(mesh::Edges::sharp, 16.0).doubtful, 0.0);
}

// The walls of a star meet in fillets of three chords. These are round, and the outline is sharp.
TEST(FitAsPlanned, FilletsStaySmooth) {
    const std::vector<glm::dvec2> corners{{1.0, 0.0},  {0.3, 0.3},   {0.0, 1.0},  {-0.3, 0.3},
                                          {-1.0, 0.0}, {-0.3, -0.3}, {0.0, -1.0}, {0.3, -0.3}};
    const Planned star(verdict::prism(verdict::rounded(corners, 0.05, 3), 0.4, 3));
    const mesh::PlannedCreases plan = star.creases(mesh::Edges::automatic);
    ASSERT_TRUE(plan.creases);
    EXPECT_EQ(plan.creases->patches, 3);
    EXPECT_EQ(star.creases(mesh::Edges::sharp).creases->patches, 10);
}

TEST(FitAsPlanned, AStatueOnABlockIsSmooth) {
    const verdict::Quads statue =
        verdict::subdivided(verdict::cage(verdict::solid_of(verdict::person()), 14, 2, 0.05, 4), 1);
    const Triangles block = test::box(14.0, 10.0, 4.0, 1).moved(1.0, -7.0, -5.0, -15.0);
    const Planned both(block.with(verdict::cut(statue, verdict::Cut::first)));
    const mesh::PlannedCreases plan = both.creases(mesh::Edges::automatic);
    ASSERT_TRUE(plan.creases);
    EXPECT_EQ(plan.creases->patches, 6 + 1);
    EXPECT_GT(both.creases(mesh::Edges::sharp).creases->patches, 20);
}

TEST(FitAsPlanned, SolidsThatCrossAreFittedApart) {
    const Triangles ball = test::icosphere(3);
    const mesh::PlannedCreases crossing =
        Planned(ball.with(ball.moved(1.0, 1.0, 0.0, 0.0))).creases(mesh::Edges::automatic);
    ASSERT_TRUE(crossing.creases);
    EXPECT_EQ(crossing.creases->patches, 2);
    EXPECT_EQ(crossing.creases->length, 0.0);
    EXPECT_FALSE(Planned(ball.with(ball.moved(1.0, 3.0, 0.0, 0.0))).creases(mesh::Edges::automatic).creases);
    const auto lower = [](double, double, double z) { return z < 0.5; };
    const Triangles bowl = ball.where(lower); // open parts that cross are still one function
    EXPECT_FALSE(Planned(bowl.with(bowl.moved(1.0, 1.0, 0.0, 0.0))).creases(mesh::Edges::automatic).creases);
}

TEST(FitAsPlanned, AnOpenSurfaceEndsAtItsBorder) {
    const auto lower = [](double, double, double z) { return z < 0.5; };
    const Planned bowl(test::icosphere(3).where(lower));
    const mesh::EndPlan plan = bowl.end(true, 0.001, 0.0, false);
    EXPECT_EQ(plan.end, mesh::End::at_places);
    EXPECT_DOUBLE_EQ(plan.off, 0.005); // five times the distance between mesh and surface
    EXPECT_LT(bowl.end(true, 1e-5, 0.0, false).off, 0.005);
    const mesh::MeshSamples places = mesh::end_places(bowl.runtime, bowl.shape, bowl.tree, plan, 1);
    ASSERT_GT(places.position.size(), 10000);
    double highest = -1.0;
    for (std::int64_t i = 0; i < places.position.size(); ++i) highest = std::max(highest, places.position[i].z);
    EXPECT_GT(highest, 0.4);
    // A strip that is fitted exactly ends nearer, so that its corners are sharp.
    Triangles strip;
    for (const double x : {0.0, 1.0})
        for (const double y : {0.0, 0.02}) static_cast<void>(strip.add(x, y, 0.0));
    strip.face(0, 2, 3);
    strip.face(0, 3, 1);
    EXPECT_EQ(Planned(strip).end(true, 1e-6, 0.0, false).off, 0.001);
    EXPECT_DOUBLE_EQ(Planned(strip).end(true, 1e-3, 0.0, false).off, 0.005);
}

} // namespace
} // namespace fit_as_planned_test
