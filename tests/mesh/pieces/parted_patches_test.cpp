// SPDX-License-Identifier: MIT
// Tests patches that no smooth function fits. They are parted along edges that bend less.
#include "mesh/meshes.h"
#include "mesh/pieces/fit_sheet_tree.h"
#include "support/runtime.h"
#include "support/sharp_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace parted_patches_test {

namespace mesh = hrbfnpr::mesh;
namespace test = hrbfnpr::test;
using hrbfnpr::test::Triangles;

namespace {

constexpr int sides = 6;
constexpr double slope = 15.0; // degrees; the bevel meets the lid at this angle, and its faces meet at 14.9
constexpr double at_plates = 30.0;

// A low and narrow bevel around the lid. Its facets form one patch, but as a smooth surface they would be far off
// beside the corners.
Triangles plate() {
    constexpr double radius = 0.866; // inscribed
    constexpr double lid = 0.95;
    const double top = 0.5 + (1.0 - lid) * std::tan(slope * std::numbers::pi / 180.0);
    return test::ringed(
        {{0.0, 0.0}, {radius, 0.0, sides}, {radius, 0.5, sides}, {lid * radius, top, sides}, {0.0, top}}, sides, 10.0);
}

struct Plate {
    explicit Plate(int threads = 2)
        : runtime(test::with_threads(threads)), shape(mesh_test::made(runtime, plate(), mesh::Parts::all)),
          tree(runtime, shape.vertex, shape.triangle),
          creases(mesh::find_creases(runtime, shape, {at_plates, 0.012 * shape.bounds.diagonal()})) {}

    [[nodiscard]] mesh::SheetTreeFit fit(mesh::Edges edges = mesh::Edges::automatic) const {
        mesh::FitMeshSettings settings;
        settings.edges = edges;
        return mesh::fit_sheet_tree(runtime, shape, tree, creases, settings, {});
    }
    // Marks the patches of the bevel and the lid.
    [[nodiscard]] hrbfnpr::base::Array<std::uint8_t> on_top() const {
        hrbfnpr::base::Array<std::uint8_t> within(runtime.memory, creases.patches);
        for (std::int64_t face = 0; face < shape.faces(); ++face)
            if (mesh::doubled_area(shape.corners(face)).z > 0.0) within[creases.patch[face]] = 1;
        return within;
    }

    hrbfnpr::base::Runtime runtime;
    mesh::Mesh shape;
    mesh::FaceTree tree;
    mesh::Creases creases;
};

} // namespace

TEST(PartedPatches, IncludeOnlyTheNamedPatches) {
    const Plate plate;
    ASSERT_EQ(plate.creases.patches, sides + 2);
    const auto more = [&](const auto& within, double angle) {
        return mesh::find_more_creases(plate.runtime, plate.shape, plate.creases, within, angle);
    };
    const mesh::Creases parted = more(plate.on_top(), 10.0);
    EXPECT_EQ(parted.patches, 2 * sides + 2);
    EXPECT_EQ(parted.edge.size(), plate.creases.edge.size() + 2 * sides);
    EXPECT_EQ(more(plate.on_top(), 20.0).patches, sides + 2);
    const hrbfnpr::base::Array<std::uint8_t> none(plate.runtime.memory, plate.creases.patches);
    const mesh::Creases same = more(none, 10.0);
    EXPECT_TRUE(test::same_bits(same.patch, plate.creases.patch));
    EXPECT_EQ(same.edge.size(), plate.creases.edge.size());
    EXPECT_DOUBLE_EQ(same.length, plate.creases.length);
}

TEST(PartedPatches, BringAPoorFitWithinTheTolerance) {
    const Plate plate;
    const mesh::SheetTreeFit found = plate.fit();
    EXPECT_TRUE(found.mesh.reached);
    EXPECT_EQ(found.pieces.sheets, 2 * sides + 2);
    EXPECT_EQ(found.data.sheet.size(), 2 * sides + 2);
    EXPECT_LT(found.mesh.surface.most, 0.01 * found.mesh.tolerance);
    EXPECT_LT(found.mesh.mesh.most, 0.01 * found.mesh.tolerance);
    EXPECT_EQ(found.fit.samples, found.mesh.candidates);
    EXPECT_GE(found.mesh.seconds_total, found.mesh.seconds_fit);
}

TEST(PartedPatches, AreNotMadeIfTheCallerChoosesTheSharpEdges) {
    const Plate plate;
    const mesh::SheetTreeFit found = plate.fit(mesh::Edges::sharp);
    EXPECT_FALSE(found.mesh.reached);
    EXPECT_GT(found.mesh.surface.most, found.mesh.far);
    EXPECT_EQ(found.pieces.sheets, sides + 2);
}

} // namespace parted_patches_test
