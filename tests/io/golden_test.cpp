// SPDX-License-Identifier: MIT
// Files of every past format version load for ever, from the first release on. These were written by version 0.1.0: the
// fit of the six axis points of the unit sphere, and one step of the published refinement on it.
#include "samples.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace hrbfnpr::io::golden_test {
namespace {

using namespace samples;

Bytes golden(const char* name) {
    const auto path = std::filesystem::path(HRBFNPR_GOLDEN_FILES) / name;
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream) << path;
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(Golden, AModelOfVersion1Loads) {
    base::Memory memory;
    const Bytes bytes = golden("sphere_6.model.v1");
    MemoryReader reader = reader_of(bytes);
    ModelFile file = load_model(memory, reader);
    EXPECT_EQ(file.report.size(), 16);
    EXPECT_EQ(file.report[0], 6.0);
    EXPECT_EQ(file.data.kernel, kernel::Kind::triharmonic);
    EXPECT_EQ(file.data.polynomial_degree, 1);
    BytesWriter writer;
    save_model({&file.data, nullptr, file.report.span()}, nullptr, writer);
    EXPECT_EQ(writer.bytes, bytes); // fits are still written in this version

    const implicit::Hrbf hrbf(hrbfnpr::base::choose_instruction_set(hrbfnpr::base::InstructionSet::automatic),
                              std::move(file.data));
    const std::array<double, 3> x{0.3, 1.5, -0.4};
    const std::array<double, 3> y{-0.2, 1.5, 0.1};
    const std::array<double, 3> z{0.9, 1.5, 0.2};
    std::array<double, 3> value{};
    implicit::FieldBatch fields;
    fields.value = value.data();
    hrbf.evaluate({x.data(), y.data(), z.data(), 3}, fields);
    EXPECT_NEAR(value[0], -0.034330597354739902, 1e-13);
    EXPECT_NEAR(value[1], 1.7082068528948635, 1e-13);
    EXPECT_NEAR(value[2], -0.41510708690424475, 1e-13);
}

TEST(Golden, ATreeOfVersion2Loads) {
    base::Memory memory;
    const Bytes bytes = golden("sphere_6_cut.model.v2");
    MemoryReader reader = reader_of(bytes);
    const ModelFile file = load_model(memory, reader);
    ASSERT_EQ(file.tree.size(), 3);
    EXPECT_EQ(file.tree[0].kind, implicit::CsgKind::subtract);
    EXPECT_EQ(file.tree[0].blend, 0.2);
    EXPECT_EQ(file.tree[1].kind, implicit::CsgKind::model);
    EXPECT_EQ(file.tree[2].kind, implicit::CsgKind::cylinder);
    EXPECT_EQ(file.tree[2].radius, 0.4);
    EXPECT_EQ(file.bounds.max.x, 1.0);
    ASSERT_EQ(file.leaves.size(), 1);
    EXPECT_EQ(file.leaves[0].data.count(), 6);
    const FitToSave leaf{&file.leaves[0].data, nullptr, file.leaves[0].report.span()};
    BytesWriter writer;
    save_csg(file.tree, file.bounds, {&leaf, 1}, nullptr, writer);
    EXPECT_EQ(writer.bytes, bytes); // until there is a version 3
}

// Three sheets in eight cells, two of them plain (pieces_file_test.cpp).
TEST(Golden, SheetsOfVersion2Load) {
    base::Memory memory;
    const Bytes bytes = golden("three_sheets.model.v2");
    MemoryReader reader = reader_of(bytes);
    ModelFile file = load_model(memory, reader);
    ASSERT_TRUE(file.pieces.has_value());
    BytesWriter writer;
    save_model({nullptr, &*file.pieces, file.report.span()}, nullptr, writer);
    EXPECT_EQ(writer.bytes, bytes); // until there is a version 3
    const implicit::SheetTree f(hrbfnpr::base::choose_instruction_set(hrbfnpr::base::InstructionSet::automatic),
                                std::move(*file.pieces));
    const std::array<double, 3> x{0.9, 1.2, -3.0};
    const std::array<double, 3> y{-2.1, -1.5, 4.0};
    const std::array<double, 3> z{2.8, 3.5, 9.0};
    std::array<double, 3> value{};
    std::array<std::int32_t, 3> sheet{};
    f.evaluate({x.data(), y.data(), z.data(), 3}, {value.data(), {}, {}});
    f.active({x.data(), y.data(), z.data(), 3}, sheet.data());
    EXPECT_NEAR(value[0], -2.1096395518698814, 1e-12);
    EXPECT_NEAR(value[1], -1.6994268213157082, 1e-12);
    EXPECT_NEAR(value[2], 6.3808172147978377, 1e-12);
    EXPECT_EQ(sheet, (std::array<std::int32_t, 3>{0, 3, 3}));
}

// Stipples, hatching by curvature and hatching by combing, with the article's strokes in both directions of each.
TEST(Golden, APointSetOfVersion3Loads) {
    base::Memory memory;
    const Bytes bytes = golden("sphere_6.points.v3");
    MemoryReader reader = reader_of(bytes);
    const marks::PointSet set = load_point_set(memory, reader);
    EXPECT_EQ(set.distribution, marks::Distribution::published);
    EXPECT_EQ(set.seed_source, marks::SeedSource::samples);
    ASSERT_EQ(set.layers.size(), 3);
    EXPECT_EQ(set.layers[0].kind, marks::Kind::stipples);
    EXPECT_EQ(set.layers[1].kind, marks::Kind::hatch);
    EXPECT_EQ(set.layers[2].kind, marks::Kind::hatch);
    EXPECT_STREQ(set.layers[1].name.data(), "curvature");
    EXPECT_STREQ(set.layers[2].name.data(), "combing");
    EXPECT_EQ(set.layers[0].count(), 30);
    EXPECT_EQ(set.layers[1].count(), 36);
    EXPECT_EQ(set.layers[2].count(), 36);
    EXPECT_EQ(set.layers[0].rank[0], 0.538630426F);
    EXPECT_EQ(set.layers[0].position[87], 0.609430969F);
    EXPECT_EQ(set.layers[1].curvature.size(), 108);
    EXPECT_TRUE(set.layers[2].curvature.empty());
    EXPECT_EQ(set.layers[0].strokes(), 0);
    EXPECT_EQ(set.layers[1].strokes(), 12) << "two of each of six seeds";
    EXPECT_EQ(set.layers[2].strokes(), 12);
    EXPECT_EQ(set.layers[1].stroke_first[5], 15U);
    EXPECT_EQ(set.layers[1].mark_of(1), 0) << "the seed in the middle of its stroke";
    EXPECT_EQ(set.layers[1].stroke_of(0), 0);
    EXPECT_FALSE(set.layers[0].progressive);
    EXPECT_EQ(bytes_of(set), bytes); // sets without fields are still written in this version
}

// The same set with a scalar field, a field of colours with weights, and a field of directions.
TEST(Golden, APointSetOfVersion4Loads) {
    base::Memory memory;
    const Bytes bytes = golden("sphere_6.points.v4");
    MemoryReader reader = reader_of(bytes);
    const marks::PointSet set = load_point_set(memory, reader);
    ASSERT_EQ(set.layers.size(), 3);
    for (const marks::Layer& layer : set.layers) {
        ASSERT_EQ(layer.fields.size(), 3);
        const marks::MarkField* const height = layer.field_of("height");
        const marks::MarkField* const colour = layer.field_of("colour");
        const marks::MarkField* const way = layer.field_of("way");
        ASSERT_TRUE(height != nullptr && colour != nullptr && way != nullptr);
        EXPECT_EQ(height->kind, marks::FieldKind::scalar);
        EXPECT_EQ(colour->kind, marks::FieldKind::colour);
        EXPECT_EQ(way->kind, marks::FieldKind::direction);
        EXPECT_TRUE(height->weight.empty());
        for (std::int64_t i = 0; i < layer.count(); ++i) {
            EXPECT_EQ(height->value[i], layer.position[3 * i + 2]);
            EXPECT_EQ(colour->weight[i], i % 2 == 0 ? 1.0F : 0.5F);
            EXPECT_EQ(colour->value[3 * i + 1], 0.25F);
            EXPECT_NEAR(way->value[3 * i], layer.normal[3 * i + 1], 1e-6F);
        }
    }
    EXPECT_EQ(bytes_of(set), bytes); // until there is a version 5
}

// Versions before the first release cannot be read.
TEST(Golden, PointSetsOfOlderVersionsAreRefused) {
    base::Memory memory;
    for (const std::uint32_t version : {1U, 2U}) {
        Bytes bytes = golden("sphere_6.points.v3");
        store(&bytes[12], version);
        sign(bytes);
        const Outcome outcome = load(memory, bytes, false);
        EXPECT_EQ(outcome.status, Status::version_mismatch);
        EXPECT_EQ(outcome.message, "this point set file has format version " + std::to_string(version) +
                                       ", from before the first release, but this library reads versions from 3 on; "
                                       "save it again");
    }
}

} // namespace
} // namespace hrbfnpr::io::golden_test
