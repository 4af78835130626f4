// SPDX-License-Identifier: MIT
#include "picture/mesh_facts.h"

#include "mesh_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace picture_tests::mesh_facts_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

class MeshFactsTest : public testing::Test {
protected:
    MeshFacts facts_of(const test::Triangles& mesh) { return mesh_facts_of(shape_of(mesh, pool), pool); }

    base::Memory memory;
    Pool pool{memory};
};

TEST_F(MeshFactsTest, A_closed_mesh_has_its_area_and_volume) {
    // Vertices on the edges of a box are repeated for each side: 8 corners three times, 12 * 3 others twice.
    const MeshFacts box = facts_of(test::box(1.0, 2.0, 3.0, 4).moved(1.0, 50.0, -20.0, 7.0));
    EXPECT_TRUE(box.closed);
    EXPECT_FALSE(box.inside_out);
    EXPECT_EQ(box.components, 1);
    EXPECT_EQ(box.joined_vertices, 8 * 2 + 12 * 3);
    EXPECT_NEAR(box.area, 22.0, 1e-12);
    EXPECT_NEAR(box.volume, 6.0, 1e-12);
    EXPECT_EQ(box.boundary_edges + box.boundary_loops + box.nonmanifold_edges + box.contrary_edges, 0);
    EXPECT_EQ(box.degenerate_faces + box.repeated_faces + box.unused_vertices + box.faces_not_finite, 0);

    constexpr double pi = std::numbers::pi;
    const MeshFacts torus = facts_of(test::torus(240, 120, 0.25));
    EXPECT_NEAR(torus.area, 4.0 * pi * pi * 0.25, 2e-3);
    EXPECT_NEAR(torus.volume, 2.0 * pi * pi * 0.0625, 2e-3);
}

TEST_F(MeshFactsTest, A_turned_mesh_is_inside_out) {
    const test::Triangles box = test::box(1.0, 1.0, 1.0, 2);
    const MeshFacts turned = facts_of(box.turned());
    EXPECT_TRUE(turned.closed && turned.inside_out);
    EXPECT_EQ(turned.components_inside_out, 1);
    EXPECT_NEAR(turned.volume, -1.0, 1e-12);

    const MeshFacts cavity = facts_of(box.moved(3.0, -1.0, -1.0, -1.0).with(box.turned()));
    EXPECT_TRUE(cavity.closed);
    EXPECT_FALSE(cavity.inside_out);
    EXPECT_EQ(cavity.components, 2);
    EXPECT_EQ(cavity.components_inside_out, 1);
    EXPECT_NEAR(cavity.volume, 26.0, 1e-12);
}

TEST_F(MeshFactsTest, Borders_are_counted_by_loops) {
    const MeshFacts open = facts_of(pipe());
    EXPECT_FALSE(open.closed);
    EXPECT_EQ(open.boundary_edges, 48);
    EXPECT_EQ(open.boundary_loops, 2);
    EXPECT_EQ(open.volume, 0.0);
    // A part with a border encloses nothing, so it cannot be inside out.
    EXPECT_EQ(facts_of(pipe().turned()).components_inside_out, 0);
}

TEST_F(MeshFactsTest, Contrary_and_nonmanifold_edges_are_counted) {
    test::Triangles one_turned = test::tetrahedron();
    std::swap(one_turned.triangles[0], one_turned.triangles[1]);
    const MeshFacts contrary = facts_of(one_turned);
    EXPECT_EQ(contrary.contrary_edges, 3);
    EXPECT_FALSE(contrary.closed);
    EXPECT_EQ(contrary.boundary_edges, 0);

    const test::Triangles box = test::box(1.0, 1.0, 1.0, 1);
    EXPECT_EQ(facts_of(box.with(box.moved(1.0, 1.0, 1.0, 0.0))).nonmanifold_edges, 1);
}

TEST_F(MeshFactsTest, Unusable_faces_and_vertices_are_counted) {
    test::Triangles mesh = test::tetrahedron();
    mesh.face(0, 0, 1);                         // This face has no area.
    mesh.face(3, 1, 0);                         // This repeats the first face.
    static_cast<void>(mesh.add(9.0, 9.0, 9.0)); // No face uses this vertex.
    const std::int32_t lost = mesh.add(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
    mesh.face(0, 1, lost);
    const MeshFacts facts = facts_of(mesh);
    EXPECT_EQ(facts.degenerate_faces, 1);
    EXPECT_EQ(facts.repeated_faces, 1);
    EXPECT_EQ(facts.unused_vertices, 1);
    EXPECT_EQ(facts.faces_not_finite, 1);
    EXPECT_EQ(facts.joined_vertices, 0);
    EXPECT_EQ(facts.nonmanifold_edges, 3); // The edges of the repeated face are non-manifold.
    EXPECT_EQ(facts.components, 1);
}

TEST_F(MeshFactsTest, A_mesh_may_have_no_usable_face) {
    test::Triangles mesh;
    const std::int32_t first = mesh.add(0.0, 0.0, std::numeric_limits<double>::infinity());
    mesh.face(first, mesh.add(1.0, 0.0, 0.0), mesh.add(0.0, 1.0, 0.0));
    const MeshFacts facts = facts_of(mesh);
    EXPECT_EQ(facts.faces_not_finite, 1);
    EXPECT_EQ(facts.components + facts.boundary_edges + facts.boundary_loops, 0);
    EXPECT_FALSE(facts.closed);
    EXPECT_EQ(facts.area, 0.0);
}

} // namespace
} // namespace picture_tests::mesh_facts_test
