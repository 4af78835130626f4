// SPDX-License-Identifier: MIT
// Tests files of models that are made of sheets.
#include "samples.h"

#include "base/instruction_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace hrbfnpr::io::pieces_file_test {
namespace {

using namespace samples;
using implicit::SheetTreeData;

// Three sheets in eight cells, two of them plain.
SheetTreeData pieces(base::Memory& memory) {
    SheetTreeData data(memory);
    for (std::int64_t sheet = 0; sheet < 3; ++sheet) data.sheet.add(model(memory, 2 + sheet));
    data.bounds = data.sheet[0].bounds;
    data.spacing = 0.5;
    data.side = 1.02 * SheetTreeData::reach * data.bounds.diagonal();
    data.corner = data.bounds.centre() - 0.5 * data.side;
    data.child.push_back(1);
    for (std::int32_t leaf = 0; leaf < 8; ++leaf) {
        data.child.push_back(-1 - leaf);
        data.program_begin.push_back(static_cast<std::int32_t>(data.program.size()));
        for (int k = 0; k < 4; ++k) data.plain.push_back(number(10 * leaf + k));
        if (leaf > 5) continue;
        for (const std::int32_t code : {leaf % 3, (leaf + 1) % 3, leaf % 2 == 0 ? -1 : -2})
            data.program.push_back(code);
    }
    data.program_begin.push_back(static_cast<std::int32_t>(data.program.size()));
    for (const double x : {1.0, 2.0, 3.0}) data.sample_position.push_back(x);
    for (const double x : {0.0, 1.0, 0.0}) data.sample_normal.push_back(x);
    return data;
}

Bytes bytes_of(const SheetTreeData& data, const TrimFile* trim = nullptr) {
    BytesWriter writer;
    save_model({nullptr, &data, report()}, trim, writer);
    return writer.bytes;
}

TEST(PiecesFile, KeepsEveryBit) {
    base::Memory memory;
    TrimFile trim(memory);
    fill(trim);
    const Bytes first = bytes_of(pieces(memory), &trim);
    EXPECT_EQ(fetch<std::uint32_t>(&first[12]), 2U);
    MemoryReader reader = reader_of(first);
    const ModelFile loaded = load_model(memory, reader);
    ASSERT_TRUE(loaded.pieces.has_value());
    EXPECT_EQ(bytes_of(*loaded.pieces, &loaded.trim), first);
    EXPECT_EQ(loaded.pieces->sheet.size(), 3);
    EXPECT_EQ(loaded.pieces->sheet[2].count(), 4);
    EXPECT_EQ(loaded.pieces->program[2], -1);
    EXPECT_EQ(loaded.report.size(), static_cast<std::int64_t>(report().size()));
    EXPECT_EQ(loaded.trim.limit, 1.5);
}

TEST(PiecesFile, DamagedFilesAreRefused) {
    base::Memory memory;
    Bytes bytes = bytes_of(pieces(memory));
    for (std::size_t length = 0; length < bytes.size(); ++length)
        ASSERT_EQ(load(memory, Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)), true).status,
                  Status::corrupt_data)
            << length;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        bytes[at] ^= 0x10U;
        ASSERT_EQ(load(memory, bytes, true).status, Status::corrupt_data) << at;
        bytes[at] ^= 0x10U;
    }
    EXPECT_EQ(load(memory, bytes, true).message, "");
}

std::string message_of(const std::function<void(SheetTreeData&)>& change) {
    base::Memory memory;
    SheetTreeData data = pieces(memory);
    change(data);
    return load(memory, bytes_of(data), true).message;
}

TEST(PiecesFile, ContentIsChecked) {
    const auto expect = [](const char* part, const std::function<void(SheetTreeData&)>& change) {
        EXPECT_NE(message_of(change).find(part), std::string::npos) << message_of(change);
    };
    EXPECT_EQ(message_of([](SheetTreeData&) {}), "");
    expect("no sheets", [](SheetTreeData& d) { d.sheet.clear(); });
    expect("alpha[1] is not finite", [](SheetTreeData& d) { d.sheet[1].alpha[1] = NAN; });
    expect("programs are invalid", [](SheetTreeData& d) { d.program[0] = 3; });
    expect("programs are invalid", [](SheetTreeData& d) { d.program_begin[4] = 100; });
    expect("programs are invalid", [](SheetTreeData& d) { d.child[0] = -1; });
    expect("programs are invalid", [](SheetTreeData& d) { d.plain.push_back(0.0); });
    expect("plain[5] is not finite", [](SheetTreeData& d) { d.plain[5] = INFINITY; });
    expect("not a box", [](SheetTreeData& d) { d.bounds.max.x = -100.0; });
    expect("do not cover", [](SheetTreeData& d) {
        d.corner += 0.1 * d.side;
        d.side *= 0.8;
    });
    expect("not lie around its bounds", [](SheetTreeData& d) { d.corner.y += 0.2; });
    expect("spacing is negative", [](SheetTreeData& d) { d.spacing = -1.0; });
    expect("number of samples is wrong", [](SheetTreeData& d) {
        d.sample_position.push_back(0.0);
        d.sample_normal.push_back(0.0);
    });
    expect("sample_normal[0]", [](SheetTreeData& d) { d.sample_normal[1] = 2.0; });
    expect("sample_position[0] is outside its bounds", [](SheetTreeData& d) { d.sample_position[1] = 1e60; });
}

// Bytes are changed and the checksums corrected. Every file that still loads can be evaluated.
TEST(PiecesFile, EveryFileThatLoadsCanBeEvaluated) {
    base::Memory memory;
    const Bytes good = bytes_of(pieces(memory));
    std::int64_t loaded = 0;
    for (std::uint64_t i = 0; i < 4000; ++i) {
        Bytes bytes = good;
        const auto random = base::uniform4(3, i, base::Purpose::probe);
        const std::size_t room = bytes.size() - header_size - 4;
        bytes[header_size + static_cast<std::size_t>(random[0] * static_cast<double>(room))] ^=
            static_cast<std::uint8_t>(1U << static_cast<unsigned>(8.0 * random[1]));
        sign(bytes);
        MemoryReader reader = reader_of(bytes);
        try {
            ModelFile file = load_model(memory, reader);
            ++loaded;
            const implicit::SheetTree f(base::InstructionSet::baseline, std::move(*file.pieces));
            const glm::dvec3 p = 8.0 * (glm::dvec3(random[1], random[2], random[3]) - 0.5);
            double value = 0.0;
            std::int32_t sheet = -1;
            f.evaluate({&p.x, &p.y, &p.z, 1}, {&value, {}, {}});
            f.active({&p.x, &p.y, &p.z, 1}, &sheet);
            EXPECT_TRUE(sheet >= 0 && sheet < f.count());
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::corrupt_data);
        }
    }
    EXPECT_GT(loaded, 100);
}

} // namespace
} // namespace hrbfnpr::io::pieces_file_test
