// SPDX-License-Identifier: MIT
#include "samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace hrbfnpr::io::round_trip_test {
namespace {

using namespace samples;

TEST(Crc32, GivesTheWellKnownCheckValue) {
    const std::string text = "123456789";
    EXPECT_EQ(crc_of(Bytes(text.begin(), text.end())), 0xCBF43926U);
    EXPECT_EQ(crc_of({}), 0U);
}

TEST(Format, StoresLittleEndian) {
    std::uint8_t bytes[8];
    store(bytes, std::uint32_t{0x01020304});
    EXPECT_EQ(std::vector<int>(bytes, bytes + 4), (std::vector<int>{4, 3, 2, 1}));
    store(bytes, -2.0);
    EXPECT_EQ(bytes[7], 0xC0);
    EXPECT_EQ(fetch<double>(bytes), -2.0);
    EXPECT_EQ(tag("MODL"), 0x4C444F4DU);
}

TEST(ModelFile, KeepsEveryBit) {
    base::Memory memory;
    for (const auto kind : {kernel::Kind::triharmonic, kernel::Kind::gaussian, kernel::Kind::wendland_c2})
        for (const std::int32_t degree : {-1, 0, 1, 2, 3}) {
            const Bytes first = bytes_of(model(memory, 5, kind, degree));
            MemoryReader reader = reader_of(first);
            const ModelFile loaded = load_model(memory, reader);
            BytesWriter second;
            save_model({&loaded.data, nullptr, loaded.report.span()}, &loaded.trim, second);
            EXPECT_EQ(first, second.bytes);
            EXPECT_EQ(loaded.data.kernel, kind);
            EXPECT_EQ(loaded.data.polynomial_degree, degree);
            EXPECT_EQ(loaded.data.count(), 5);
        }
}

TEST(ModelFile, StoresTheEndOfATrimmedModel) {
    base::Memory memory;
    ModelFile file(memory);
    file.data = model(memory, 3);
    fill(file.trim);
    const auto bytes_with = [&](const TrimFile& trim) {
        BytesWriter writer;
        save_model({&file.data, nullptr, report()}, &trim, writer);
        return writer.bytes;
    };
    const Bytes bytes = bytes_with(file.trim);
    MemoryReader reader = reader_of(bytes);
    const ModelFile loaded = load_model(memory, reader);
    EXPECT_EQ(bytes_with(loaded.trim), bytes);
    EXPECT_EQ(loaded.trim.limit, 1.5);
    EXPECT_EQ(loaded.trim.closest, 0.25);
    EXPECT_EQ(loaded.trim.grid.origin, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(loaded.trim.grid.side, 0.5);
    EXPECT_EQ(loaded.trim.end_cells.size(), 2);
    EXPECT_EQ(loaded.trim.kept_cells.size(), 1);

    const auto is_refused = [&](double& number, double wrong) {
        const double right = std::exchange(number, wrong);
        const Bytes damaged = bytes_with(file.trim);
        number = right;
        MemoryReader other = reader_of(damaged);
        EXPECT_THROW((void)load_model(memory, other), Error) << wrong;
    };
    is_refused(file.trim.limit, 0.0);
    is_refused(file.trim.closest, -1.0);
    is_refused(file.trim.grid.side, 0.0);
    is_refused(file.trim.grid.origin.x, std::numeric_limits<double>::quiet_NaN());
    is_refused(file.trim.position[0], 1e101);
    is_refused(file.trim.normal[0], 2.0);
}

TEST(ModelFile, StoresATreeWithItsLeaves) {
    base::Memory memory;
    const Bytes bytes = csg_model_bytes(3);
    MemoryReader reader = reader_of(bytes);
    const ModelFile loaded = load_model(memory, reader);
    ASSERT_EQ(loaded.tree.size(), 3);
    ASSERT_EQ(loaded.leaves.size(), 1);
    EXPECT_EQ(loaded.leaves[0].data.count(), 3);
    EXPECT_EQ(loaded.bounds.max, glm::dvec3(3.0));
    EXPECT_EQ(loaded.tree[0].blend, 0.125);
    EXPECT_EQ(loaded.tree[1].model, 0);
    EXPECT_EQ(loaded.tree[2].linear[1], glm::dvec3(0.0, 2.0, 0.5));
    EXPECT_EQ(loaded.tree[2].translation, glm::dvec3(1.0, 2.0, 3.0));
    const FitToSave leaf{&loaded.leaves[0].data, nullptr, loaded.leaves[0].report.span()};
    EXPECT_EQ(bytes_of(loaded.tree, loaded.bounds, {&leaf, 1}), bytes);
    // The file with a trim is tested, too.
    TrimFile trim(memory);
    const Bytes trimmed = bytes_of(loaded.tree, loaded.bounds, {&leaf, 1}, &fill(trim));
    MemoryReader other = reader_of(trimmed);
    EXPECT_EQ(load_model(memory, other).trim.limit, 1.5);
}

TEST(ModelFile, InvalidTreesAreRefused) {
    base::Memory memory;
    const implicit::HrbfData data = model(memory, 2);
    const FitToSave leaf{&data, nullptr, {}};
    const auto message = [&](const std::function<void(implicit::CsgTree&, geometry::Bounds&)>& change,
                             bool leaves = true) {
        implicit::CsgTree tree = csg_tree(memory);
        geometry::Bounds bounds{glm::dvec3(-2.0), glm::dvec3(3.0)};
        change(tree, bounds);
        const Outcome outcome =
            load(memory, bytes_of(tree, bounds, {&leaf, leaves ? std::size_t{1} : std::size_t{0}}), true);
        EXPECT_EQ(outcome.status, Status::corrupt_data);
        return outcome.message;
    };
    using implicit::CsgKind;
    EXPECT_NE(message([](auto& tree, auto&) { tree[2].kind = static_cast<CsgKind>(13); }).find("kind of node 2"),
              std::string::npos);
    EXPECT_NE(message([](auto& tree, auto&) { tree[2].model = 0; }).find("node 2 has a leaf"), std::string::npos);
    EXPECT_NE(message([](auto& tree, auto&) { tree[1].model = 1; }).find("node 1 has a leaf"), std::string::npos);
    EXPECT_NE(message([](auto&, auto&) {}, false).find("node 1 has a leaf"), std::string::npos);
    EXPECT_NE(message([](auto& tree, auto&) {
                  tree[1].exponent = std::nan("");
              }).find("node 1 has a number that is not finite"),
              std::string::npos);
    EXPECT_NE(message([](auto&, auto& bounds) { bounds.min.x = 4.0; }).find("not a box"), std::string::npos);
    EXPECT_NE(message([](auto& tree, auto&) { tree.clear(); }).find("has no node"), std::string::npos);
}

TEST(ModelFile, GivesBackEveryField) {
    base::Memory memory;
    implicit::HrbfData data = model(memory, 3);
    data.alpha[1] = -0.0;
    data.beta.y[2] = std::numeric_limits<double>::denorm_min();
    const Bytes bytes = bytes_of(data);
    MemoryReader reader = reader_of(bytes);
    const ModelFile file = load_model(memory, reader);
    EXPECT_EQ(file.data.scale, data.scale);
    EXPECT_EQ(file.data.centre, data.centre);
    EXPECT_EQ(file.data.spacing, data.spacing);
    EXPECT_EQ(file.data.bounds.min, data.bounds.min);
    EXPECT_EQ(file.data.bounds.max, data.bounds.max);
    EXPECT_TRUE(std::signbit(file.data.alpha[1]));
    EXPECT_EQ(file.data.beta.y[2], data.beta.y[2]);
    EXPECT_EQ(file.data.centre_position[1], data.centre_position[1]);
    EXPECT_EQ(file.data.polynomial[3], data.polynomial[3]);
    EXPECT_EQ(file.data.sample_position[8], data.sample_position[8]);
    EXPECT_EQ(std::vector<double>(file.report.begin(), file.report.end()), report());
}

TEST(PointSetFile, KeepsEveryBit) {
    base::Memory memory;
    for (const std::int64_t count : {0, 1, 5, 3000, 20000}) {
        const Bytes first = bytes_of(point_set(memory, count));
        MemoryReader reader = reader_of(first);
        EXPECT_EQ(first, bytes_of(load_point_set(memory, reader)));
        marks::PointSet tapered = point_set(memory, count);
        for (std::int64_t i = 0; i < count; ++i)
            tapered.layers[1].width.push_back(0.25F + 0.01F * static_cast<float>(i % 70));
        const Bytes with = bytes_of(tapered);
        EXPECT_EQ(with.size(), count == 0 ? first.size() : first.size() + 4 * static_cast<std::size_t>(count));
        MemoryReader again = reader_of(with);
        EXPECT_EQ(with, bytes_of(load_point_set(memory, again)));
    }
}

// Sets without tone normals have the same files as before tone normals existed.
TEST(PointSetFile, KeepsNormalsForTone) {
    base::Memory memory;
    marks::PointSet set = point_set(memory, 5);
    const Bytes without = bytes_of(set);
    for (const float x : set.layers[1].normal.span()) set.layers[1].tone_normal.push_back(-x);
    const Bytes with = bytes_of(set);
    EXPECT_EQ(with.size(), without.size() + 3 * section_header_size + 15 * sizeof(float));
    MemoryReader reader = reader_of(with);
    const marks::PointSet loaded = load_point_set(memory, reader);
    EXPECT_EQ(with, bytes_of(loaded));
    EXPECT_TRUE(loaded.layers[0].tone_normal.empty());
    EXPECT_EQ(loaded.layers[1].tone_normal[0], -1.0F);
}

TEST(PointSetFile, KeepsFields) {
    base::Memory memory;
    for (const std::int64_t count : {0, 1, 3000}) {
        const marks::PointSet set = with_fields(point_set(memory, count));
        const Bytes bytes = bytes_of(set);
        EXPECT_EQ(bytes[12], point_set_version);
        MemoryReader reader = reader_of(bytes);
        const marks::PointSet loaded = load_point_set(memory, reader);
        EXPECT_EQ(bytes, bytes_of(loaded));
        const marks::MarkField* const heat = loaded.layers[1].field_of("heat");
        ASSERT_NE(heat, nullptr);
        EXPECT_EQ(heat->kind, marks::FieldKind::scalar);
        ASSERT_EQ(heat->value.size(), count);
        EXPECT_TRUE(std::equal(heat->value.begin(), heat->value.end(), set.layers[1].fields[1].value.begin()));
        EXPECT_EQ(loaded.layers[0].field_of("heat"), nullptr);
        EXPECT_EQ(loaded.layers[0].field_of("colour")->kind, marks::FieldKind::colour);
    }
}

TEST(PointSetFile, GivesBackEveryField) {
    base::Memory memory;
    const marks::PointSet set = point_set(memory, 4);
    const Bytes bytes = bytes_of(set);
    MemoryReader reader = reader_of(bytes);
    const marks::PointSet loaded = load_point_set(memory, reader);
    EXPECT_EQ(loaded.distribution, set.distribution);
    EXPECT_EQ(loaded.seed_source, set.seed_source);
    EXPECT_EQ(loaded.origin, set.origin);
    EXPECT_EQ(loaded.spacing, set.spacing);
    EXPECT_EQ(loaded.seeds.attempted, 100);
    EXPECT_EQ(loaded.seeds.dropped_budget, 1);
    EXPECT_EQ(loaded.seconds_total, 0.75);
    ASSERT_EQ(loaded.layers.size(), 3);
    EXPECT_EQ(loaded.layers[1].kind, marks::Kind::hatch);
    EXPECT_STREQ(loaded.layers[1].name.data(), "hatch");
    EXPECT_TRUE(loaded.layers[0].progressive);
    EXPECT_FALSE(loaded.layers[1].progressive);
    EXPECT_FALSE(loaded.layers[0].has_strokes());
    ASSERT_EQ(loaded.layers[1].strokes(), 2);
    EXPECT_EQ(loaded.layers[1].stroke_first[1], 2U);
    EXPECT_EQ(loaded.layers[1].mark_of(1), 2);
    EXPECT_EQ(loaded.layers[1].mark_of(2), 1);
    EXPECT_EQ(loaded.layers[1].stroke_of(2), 0);
    EXPECT_EQ(loaded.layers[1].stroke_of(3), 1);
    EXPECT_EQ(loaded.layers[1].report.full_count, 7);
    EXPECT_EQ(loaded.layers[1].report.level[12].dropped_strayed, 4);
    EXPECT_EQ(loaded.layers[1].curvature[5], set.layers[1].curvature[5]);
    EXPECT_TRUE(loaded.layers[0].curvature.empty());
    EXPECT_EQ(loaded.layers[0].stroke[3], set.layers[0].stroke[3]);
    EXPECT_EQ(loaded.layers[2].count(), 0);
}

TEST(PointSetFile, ASetWithoutMarksHasNoBox) {
    base::Memory memory;
    const marks::PointSet empty(memory);
    EXPECT_EQ(load(memory, bytes_of(empty), false).status, Status::ok);
}

TEST(Files, CanBeReadInSmallPieces) {
    base::Memory memory;
    const Bytes bytes = point_set_bytes(100);
    for (const std::uint64_t step : {1U, 7U, 4096U}) {
        TrickleReader reader(bytes, step);
        EXPECT_EQ(bytes_of(load_point_set(memory, reader)), bytes);
    }
}

TEST(Files, AreNotReadPastTheirEnd) {
    base::Memory memory;
    Bytes two = model_bytes();
    const Bytes set = point_set_bytes();
    two.insert(two.end(), set.begin(), set.end());
    MemoryReader reader = reader_of(two);
    EXPECT_EQ(load_model(memory, reader).data.count(), 2);
    EXPECT_EQ(bytes_of(load_point_set(memory, reader)), set);
    EXPECT_EQ(reader.remaining(), 0U);
}

TEST(Files, FailedWritesAreReported) {
    class Full final : public Writer {
        void write(const void* /*data*/, std::uint64_t size) override {
            room_ -= static_cast<std::int64_t>(size);
            if (room_ < 0) fail(Status::io, "full");
        }
        std::int64_t room_ = 300;
    } writer;
    base::Memory memory;
    EXPECT_THROW(save_point_set(point_set(memory, 10), writer), Error);
}

TEST(MemoryWriter, CountsBytesThatDoNotFit) {
    std::byte room[4] = {};
    MemoryWriter writer(room);
    writer.write("abc", 3);
    writer.write("de", 2);
    EXPECT_EQ(writer.needed(), 5U);
    EXPECT_EQ(static_cast<char>(room[2]), 'c');
    EXPECT_EQ(room[3], std::byte{0});
}

} // namespace
} // namespace hrbfnpr::io::round_trip_test
