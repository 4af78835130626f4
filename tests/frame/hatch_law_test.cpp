// SPDX-License-Identifier: MIT
// Tests the coverage of tones.
#include "frame/hatch_law_reference.h"

#include <gtest/gtest.h>

namespace hrbfnpr::testing::hatch_law_test {
namespace {

TEST(HatchLaw, LowersMiddleTonesByAPowerLaw) {
    constexpr int steps = 1000;
    EXPECT_EQ(law::hollowed(0.0F), 0.0F);
    EXPECT_NEAR(law::hollowed(1.0F), 1.0F, 1e-6F);
    for (int i = 1; i <= steps; ++i) {
        const float x = static_cast<float>(i) / static_cast<float>(steps);
        EXPECT_NEAR(law::hollowed(x), std::pow(x, 1.1F), 0.00015F) << x;
        EXPECT_GT(law::hollowed(x), law::hollowed(static_cast<float>(i - 1) / static_cast<float>(steps))) << x;
    }
}

} // namespace
} // namespace hrbfnpr::testing::hatch_law_test
