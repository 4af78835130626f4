// SPDX-License-Identifier: MIT
#include "mesh/fit/fit_mesh.h"

#include "base/status.h"
#include "mesh/fit/outer.h"
#include "mesh/meshes.h"
#include "mesh/sample.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fit_mesh_test {

namespace mesh = hrbfnpr::mesh;
using hrbfnpr::test::box;
using hrbfnpr::test::icosphere;
using hrbfnpr::test::same_bits;
using hrbfnpr::test::torus;
using hrbfnpr::test::with_threads;
using hrbfnpr::test::wound_ring;
using namespace mesh_test;

namespace {

struct Fitted {
    explicit Fitted(const Triangles& from, const mesh::FitMeshSettings& settings = {}, int threads = 2)
        : runtime(with_threads(threads)), shape(made(runtime, from)), tree(runtime, shape.vertex, shape.triangle),
          result(mesh::fit_mesh(runtime, shape, tree, settings, {})) {}

    [[nodiscard]] const mesh::FitMeshReport& report() const { return result.report; }
    [[nodiscard]] const hrbfnpr::implicit::HrbfData& data() const { return result.fit.data; }
    // Compares at other samples than those of the fit.
    [[nodiscard]] mesh::Comparison error(std::int64_t points = 10000) const {
        mesh::CompareSettings settings;
        settings.points = points;
        return mesh::compare(runtime, mesh::FitData(runtime.instruction_set, data()), shape, tree, nullptr, settings);
    }

    hrbfnpr::base::Runtime runtime;
    mesh::Mesh shape;
    mesh::FaceTree tree;
    mesh::MeshFit result;
};

void expect_asked(const Fitted& fitted, const mesh::Comparison& error) {
    EXPECT_TRUE(fitted.report().reached);
    EXPECT_GE(error.surface.share, 0.99);
    EXPECT_GE(error.mesh.share, 0.99);
    EXPECT_LE(error.surface.most, 0.01 * error.diagonal);
    EXPECT_LE(error.mesh.most, 0.01 * error.diagonal);
}

TEST(FitMesh, UsesFewSamplesOnSmoothMeshes) {
    const Fitted ring(torus(200, 80, 0.4));
    expect_asked(ring, ring.error());
    EXPECT_LE(ring.data().count(), 400);
    EXPECT_EQ(ring.report().off_surface, 0);
    EXPECT_EQ(ring.report().rounds, 1);
    EXPECT_EQ(ring.error().genus, 1);
}

TEST(FitMesh, UsesMoreSamplesOnMeshesWithEdges) {
    const Fitted cube(box(1.0, 0.8, 0.6, 8));
    const mesh::Comparison error = cube.error();
    expect_asked(cube, error);
    EXPECT_GT(cube.data().count(), 500);
    EXPECT_GT(cube.report().rounds, 1);
    EXPECT_EQ(error.genus, 0);
}

TEST(FitMesh, KeepsASheetThatIsThin) {
    const Fitted plate(box(1.0, 1.0, 0.02, 8));
    const mesh::Comparison error = plate.error();
    expect_asked(plate, error);
    EXPECT_LT(error.normal_mean, 15.0);
}

TEST(FitMesh, AddsCentresOffTheMeshToHoldTheSurface) {
    const Fitted ring(wound_ring(300, 40));
    expect_asked(ring, ring.error());
    ASSERT_GT(ring.report().off_surface, 0) << "it tells nothing";
    // The last centres are off the mesh, and f is the signed distance there.
    const hrbfnpr::implicit::HrbfData& data = ring.data();
    const mesh::FitData surface(ring.runtime.instruction_set, data);
    int inside = 0;
    for (std::int64_t i = data.count() - ring.report().off_surface; i < data.count(); ++i) {
        const double* const p = data.sample_position.data() + 3 * i;
        const glm::dvec3 place{p[0], p[1], p[2]};
        double value = 0.0;
        surface.evaluate({p, p + 1, p + 2, 1}, {&value, {}, {}});
        const double distance = ring.tree.distance(place);
        EXPECT_GT(distance, ring.report().tolerance);
        const bool is_inside = mesh::is_inside(ring.tree, place);
        inside += is_inside ? 1 : 0;
        EXPECT_NEAR(value, is_inside ? -distance : distance, 1e-5);
    }
    EXPECT_LT(inside, ring.report().off_surface);
}

TEST(FitMesh, HoldsTheSurfaceOfAMeshWithHoles) {
    const auto holed = [](double x, double y, double) { return x * x + (y - 1.0) * (y - 1.0) > 0.02; };
    const Fitted ring(wound_ring(300, 40).where(holed));
    EXPECT_TRUE(ring.report().supported);
    EXPECT_GT(ring.report().off_surface, 0);
    expect_asked(ring, ring.error());
}

TEST(FitMesh, KnowsTheSideOfAPoint) {
    const hrbfnpr::base::Runtime runtime = with_threads(2);
    const auto most = [](double, double, double z) { return z < 0.9; };
    const auto half = [](double, double, double z) { return z < 0.0; };
    const mesh::Mesh ball = made(runtime, icosphere(4).where(most)), bowl = made(runtime, icosphere(4).where(half));
    const mesh::FaceTree in_ball(runtime, ball.vertex, ball.triangle);
    const mesh::FaceTree in_bowl(runtime, bowl.vertex, bowl.triangle);
    EXPECT_EQ(mesh::side_of_mesh(in_ball, {0.1, 0.2, -0.3}), mesh::MeshSide::inside);
    EXPECT_EQ(mesh::side_of_mesh(in_ball, {1.5, 0.2, -0.3}), mesh::MeshSide::outside);
    EXPECT_EQ(mesh::side_of_mesh(in_bowl, {0.1, 0.2, -0.1}), mesh::MeshSide::unsure);
}

TEST(FitMesh, LeavesOutFacesThatLieInsideAnother) {
    const Fitted balls(icosphere(5).with(icosphere(5).moved(1.0, 1.2, 0.0, 0.0)));
    const mesh::Comparison error = balls.error();
    expect_asked(balls, error);
    EXPECT_EQ(error.components, 1);
    EXPECT_LT(balls.report().candidates, 2 * 2 * 20 * 1024);
    // Each ball has no centre inside the other one.
    for (std::int64_t i = 0; i < balls.data().count() - balls.report().off_surface; ++i) {
        const double* const p = balls.data().sample_position.data() + 3 * i;
        EXPECT_GT(glm::length(glm::dvec3(p[0], p[1], p[2])), 0.99);
        EXPECT_GT(glm::length(glm::dvec3(p[0] - 1.2, p[1], p[2])), 0.99);
    }
}

TEST(FitMesh, RefusesASolidWithoutAnInside) {
    Triangles flat = torus(24, 12, 0.4);
    for (std::size_t i = 2; i < flat.vertices.size(); i += 3) flat.vertices[i] = 0.0;
    try {
        const Fitted none(flat);
        FAIL() << none.data().count() << " centres";
    } catch (const hrbfnpr::Error& error) {
        EXPECT_EQ(error.status(), hrbfnpr::Status::invalid_argument);
        EXPECT_NE(std::string(error.what()).find("the mesh is flat"), std::string::npos) << error.what();
    }
    const Fitted sheet(box(1.0, 1.0, 1.0, 4).where([](double, double, double z) { return z > 0.4; }));
    EXPECT_TRUE(sheet.report().supported); // one side of a box
}

TEST(FitMesh, AcceptsAMeshWithABorder) {
    const auto half = [](double, double, double z) { return z > 0.0; };
    const Fitted bowl(icosphere(5).where(half));
    EXPECT_TRUE(bowl.report().supported);
    expect_asked(bowl, bowl.error());
    EXPECT_EQ(bowl.report().off_surface, 0);
}

TEST(FitMesh, ReachesATighterToleranceWithMore) {
    mesh::FitMeshSettings tight;
    tight.tolerance = 2e-3;
    tight.share = 0.95;
    const Fitted coarse(box(1.0, 0.8, 0.6, 8)), fine(box(1.0, 0.8, 0.6, 8), tight);
    EXPECT_TRUE(fine.report().reached);
    EXPECT_GT(fine.data().count(), coarse.data().count());
    EXPECT_EQ(fine.report().tolerance, 2e-3);
    EXPECT_EQ(fine.report().far, 0.01);
    EXPECT_LT(fine.error().mesh.mean, coarse.error().mesh.mean);
}

TEST(FitMesh, StopsAtTheMaximumNumberOfCentres) {
    mesh::FitMeshSettings few;
    few.maximum_centres = 60;
    const Fitted ring(wound_ring(100, 20), few);
    EXPECT_FALSE(ring.report().reached);
    EXPECT_LE(ring.data().count(), 60);
    EXPECT_LT(ring.report().mesh.share, 0.99);
}

TEST(FitMesh, GivesUpOnFacetsThatContradictTheirNormals) {
    mesh::FitMeshSettings tight;
    tight.tolerance = 5e-4; // the facets are 2e-3 off
    tight.maximum_centres = 2500;
    const Fitted facets(torus(60, 24, 0.4), tight);
    EXPECT_FALSE(facets.report().reached);
    EXPECT_LT(facets.report().rounds, 12);
}

TEST(FitMesh, ReportsResidualsOfItsConditions) {
    const Fitted ring(wound_ring(200, 30));
    EXPECT_LT(ring.result.fit.report.value_residual_max, 1e-5);
    EXPECT_LT(ring.result.fit.report.gradient_residual_max, 1e-4);
    EXPECT_EQ(ring.result.fit.report.samples, ring.report().candidates);
    EXPECT_EQ(ring.result.fit.report.choice_rounds, ring.report().rounds);
}

TEST(FitMesh, DependsOnTheSeed) {
    mesh::FitMeshSettings other;
    other.seed = 2;
    EXPECT_FALSE(same_bits(Fitted(wound_ring(100, 20)).data().sample_position,
                           Fitted(wound_ring(100, 20), other).data().sample_position));
}

} // namespace

} // namespace fit_mesh_test
