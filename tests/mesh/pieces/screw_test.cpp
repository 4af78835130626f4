// SPDX-License-Identifier: MIT
// Tests patches that wind around beside themselves, such as the threads of screws.
#include "base/random.h"
#include "mesh/fit/outer.h"
#include "mesh/meshes.h"
#include "mesh/pieces/fit_sheet_tree.h"
#include "support/runtime.h"
#include "support/screw.h"
#include "support/sharp_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace screw_test {

namespace implicit = hrbfnpr::implicit;
namespace mesh = hrbfnpr::mesh;
namespace test = hrbfnpr::test;
using test::Triangles;

namespace {

struct Cut {
    explicit Cut(const Triangles& from)
        : runtime(test::with_threads(2)), shape(mesh_test::made(runtime, from, mesh::Parts::all)),
          creases(mesh::find_creases(runtime, shape, {30.0, 0.008 * shape.bounds.diagonal()})) {}
    hrbfnpr::base::Runtime runtime;
    mesh::Mesh shape;
    mesh::Creases creases;
};

// Two flanks, crest and root have five turns each, so each is cut into ten halves or more.
TEST(WindingPatches, AreCutIntoPartsOfATurn) {
    for (const test::ThreadProfile& profile : {test::triangular, test::trapezoidal}) {
        const Cut cut(test::screw(5, profile, 48, 2));
        const int winding = profile.crest > 0.0 ? 4 : 2;
        EXPECT_GE(cut.creases.patches, 10 * winding);
        EXPECT_LE(cut.creases.patches, 16 * winding + 5);
        EXPECT_EQ(cut.creases.fading, 0.0);
        // Both sides of a cut share a band of each other's faces.
        EXPECT_GT(cut.creases.shared.size(), 0);
        EXPECT_LT(cut.creases.shared.size(), cut.shape.faces());
    }
}

// Rings meet themselves after one turn, and slivers make long paths of short steps. Neither is cut.
TEST(WindingPatches, ExcludeRingsAndSlivers) {
    EXPECT_EQ(Cut(test::gear(16, 3)).creases.patches, 67);
    EXPECT_EQ(Cut(test::gear(16, 12)).creases.patches, 67);
    EXPECT_EQ(Cut(test::stepped_shaft(96)).creases.patches, 11);
    EXPECT_EQ(Cut(test::socket(96)).creases.patches, 17);
    EXPECT_EQ(Cut(test::drilled_cube(0.5, 96)).creases.patches, 7);
}

void expect_close(const Triangles& from) {
    const Cut cut(from);
    const mesh::FaceTree tree(cut.runtime, cut.shape.vertex, cut.shape.triangle);
    mesh::SheetTreeFit fit = mesh::fit_sheet_tree(cut.runtime, cut.shape, tree, cut.creases, {}, {});
    EXPECT_TRUE(fit.mesh.reached);
    EXPECT_EQ(fit.pieces.poor_cells, 0);
    // Only the shaft may have more.
    EXPECT_LE(std::ranges::count_if(fit.data.sheet, [](const auto& sheet) { return sheet.count() > 250; }), 1);
    const double unit = 0.01 * cut.shape.bounds.diagonal();
    EXPECT_LE(fit.mesh.surface.most, 0.3 * unit);
    const implicit::SheetTree f(cut.runtime.instruction_set, std::move(fit.data));
    std::vector<double> off;
    int wrong = 0;
    for (std::uint64_t i = 0; i < 4000; ++i) {
        const auto u = hrbfnpr::base::uniform4(3, i, hrbfnpr::base::Purpose::probe);
        const auto face = static_cast<std::int64_t>(u[3] * static_cast<double>(cut.shape.faces()));
        const auto p = cut.shape.corners(face);
        const double s = std::sqrt(u[0]);
        const glm::dvec3 place = (1.0 - s) * p[0] + s * (1.0 - u[1]) * p[1] + s * u[1] * p[2];
        const glm::dvec3 normal = glm::normalize(mesh::doubled_area(p));
        double value = 0.0;
        for (const double side : {-0.2, 0.2}) {
            const glm::dvec3 beside = place + side * unit * normal;
            f.evaluate({&beside.x, &beside.y, &beside.z, 1}, {&value, {}, {}});
            const double distance = (mesh::is_inside(tree, beside) ? -1.0 : 1.0) * tree.distance(beside);
            wrong += std::abs(distance) > 0.1 * unit && (value > 0.0) != (distance > 0.0) ? 1 : 0;
        }
    }
    // Vertices are on the surface; faces are chords of it.
    for (const glm::dvec3& place : cut.shape.vertex) {
        double value = 0.0;
        glm::dvec3 g;
        f.evaluate({&place.x, &place.y, &place.z, 1}, {&value, {&g.x, &g.y, &g.z}, {}});
        off.push_back(std::abs(value) / glm::length(g));
    }
    std::sort(off.begin(), off.end());
    EXPECT_LE(off[off.size() * 95 / 100], 0.02 * unit);
    EXPECT_EQ(wrong, 0);
}

TEST(Screws, WithFiveTurnsAreFittedClosely) {
    expect_close(test::screw(5, test::triangular, 72, 3));
    expect_close(test::screw(5, test::trapezoidal, 72, 3));
}

TEST(Screws, WithTenTurnsAreFittedClosely) {
    expect_close(test::screw(10, test::triangular, 72, 3));
    expect_close(test::screw(10, test::trapezoidal, 72, 3));
}

} // namespace

} // namespace screw_test
