// SPDX-License-Identifier: MIT
// Tests ranks in a part of the range of tones.
#include "marks/point_set.h"

#include <gtest/gtest.h>

namespace hrbfnpr::marks::tone_part_test {
namespace {

TEST(TonePart, KeepsTheOrderInsideItsPart) {
    constexpr TonePart whole;
    EXPECT_EQ(whole.rank(0.3F), 0.3F);
    constexpr TonePart half{0.5, 1.0};
    EXPECT_FLOAT_EQ(half.rank(1.0F), 0.5F);
    EXPECT_FLOAT_EQ(half.rank(0.0F), 0.0F);
    constexpr TonePart first{0.0, 0.25};
    EXPECT_LT(first.rank(1.0F), 1.0F);
    EXPECT_FLOAT_EQ(first.rank(0.0F), 0.75F);
}

} // namespace
} // namespace hrbfnpr::marks::tone_part_test
