// SPDX-License-Identifier: MIT
// A small fuzzer that gives the same files on every run; tests/fuzz has the large one.
#include "samples.h"

#include <gtest/gtest.h>

namespace hrbfnpr::io::fuzz_test {
namespace {

using namespace samples;

constexpr std::uint64_t rounds = 4000;

std::uint32_t draw(std::uint64_t round, std::uint32_t lane) {
    return base::philox(11, {static_cast<std::uint32_t>(round), 0, 0, lane})[0];
}

// Interesting values for a length, an enumeration or the half of a double.
constexpr std::uint32_t special[] = {0,    1,          2,          3,          4,          0x7F,
                                     0xFF, 0x7FF00000, 0x7FF80000, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF};

void mutate(Bytes& bytes, std::uint64_t round) {
    const std::uint32_t edits = 1 + draw(round, 0) % 4;
    for (std::uint32_t edit = 0; edit < edits && !bytes.empty(); ++edit) {
        const std::size_t at = draw(round, 3 * edit + 1) % bytes.size();
        const std::uint32_t value = draw(round, 3 * edit + 2);
        switch (draw(round, 3 * edit + 3) % 4) {
        case 0: bytes[at] = static_cast<std::uint8_t>(value); break;
        case 1: bytes.resize(at); break;
        case 2: bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), static_cast<std::uint8_t>(value)); break;
        default:
            if (const std::size_t aligned = at & ~std::size_t{3}; aligned + 4 <= bytes.size())
                store(&bytes[aligned], special[value % std::size(special)]);
        }
    }
}

class Fuzz : public testing::TestWithParam<Sample> {};

TEST_P(Fuzz, EveryFileLoadsOrIsRefused) {
    const Bytes original = bytes_of(GetParam());
    int loaded = 0;
    int refused = 0;
    for (std::uint64_t round = 0; round < rounds; ++round) {
        Bytes bytes = original;
        mutate(bytes, round);
        // Half of the files get right checksums, or nothing behind them would ever be reached.
        if (round % 2 == 0 && bytes.size() >= header_size) sign(bytes);
        base::Memory memory;
        const Outcome outcome = load(memory, bytes, GetParam() != Sample::point_set);
        ASSERT_TRUE(outcome.status == Status::ok || outcome.status == Status::corrupt_data ||
                    outcome.status == Status::version_mismatch)
            << round << ": " << outcome.message;
        ASSERT_EQ(memory.bytes_now(), 0);
        ASSERT_LT(memory.bytes_peak(), 1 << 20) << round;
        ++(outcome.status == Status::ok ? loaded : refused);
    }
    EXPECT_GT(loaded, 0); // changes that only make another valid file
    EXPECT_GT(refused, static_cast<int>(rounds / 2));
}

INSTANTIATE_TEST_SUITE_P(Files, Fuzz, testing::ValuesIn(all_samples),
                         [](const auto& kind) { return name_of(kind.param); });

} // namespace
} // namespace hrbfnpr::io::fuzz_test
