// SPDX-License-Identifier: MIT
#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace hrbfnpr::base::random_test {
namespace {

// The known-answer vectors that come with Random123 (kat_vectors, philox4x32 10).
TEST(Random, PhiloxGivesTheKnownAnswers) {
    EXPECT_EQ(philox(0, {0, 0, 0, 0}), (Philox{0x6627E8D5U, 0xE169C58DU, 0xBC57AC4CU, 0x9B00DBD8U}));
    EXPECT_EQ(philox(~std::uint64_t{0}, {~0U, ~0U, ~0U, ~0U}),
              (Philox{0x408F276DU, 0x41C83B0EU, 0xA20BC7C6U, 0x6D5451FDU}));
    // Digits of pi; the key's first word is the low half of the seed.
    EXPECT_EQ(philox(0x299F31D0A4093822U, {0x243F6A88U, 0x85A308D3U, 0x13198A2EU, 0x03707344U}),
              (Philox{0xD16CFE09U, 0x94FDCCEBU, 0x5001E420U, 0x24126EA1U}));
}

TEST(Random, UniformNumbersAreUniform) {
    constexpr int count = 20000;
    for (unsigned lane = 0; lane < 4; ++lane) {
        double sum = 0.0;
        double square = 0.0;
        for (std::uint64_t i = 0; i < count; ++i) {
            const double u = uniform4(1, i, Purpose::rank)[lane];
            ASSERT_GE(u, 0.0);
            ASSERT_LT(u, 1.0);
            sum += u;
            square += u * u;
        }
        // Five standard deviations.
        EXPECT_NEAR(sum / count, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / count));
        EXPECT_NEAR(square / count, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / count));
    }
}

TEST(Random, EveryKeyGivesDifferentNumbers) {
    std::set<double> seen;
    std::size_t asked = 0;
    for (const std::uint64_t seed : {1ULL, 2ULL, 1ULL << 40U})
        for (const std::uint64_t index : {0ULL, 1ULL, 1ULL << 33U})
            for (const Purpose purpose : {Purpose::rank, Purpose::box_jitter})
                for (const std::uint32_t lane : {0U, 1U})
                    for (const double u : uniform4(seed, index, purpose, lane)) {
                        seen.insert(u);
                        ++asked;
                    }
    EXPECT_EQ(seen.size(), asked);
}

} // namespace
} // namespace hrbfnpr::base::random_test
