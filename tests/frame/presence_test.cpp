// SPDX-License-Identifier: MIT
// Tests which parts of a line are held together: the measure that closes short gaps and leaves out short parts.
#include "frame/hatch/presence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hrbfnpr::testing::presence_test {
namespace {

using frame::held_length;
using frame::HeldLength;
using frame::SampledLine;

// The samples are one unit apart.
struct Line {
    explicit Line(std::vector<float> given, bool ring = false) : presence(std::move(given)), closed(ring) {
        for (std::size_t i = 0; i < presence.size(); ++i) length.push_back(static_cast<float>(i));
    }
    [[nodiscard]] HeldLength held(std::int64_t i, int way, float most = 100.0F, float beyond = 0.0F) const {
        return held_length(
            SampledLine{length, closed}, i, way, most, beyond,
            [&](std::int64_t k) { return presence[static_cast<std::size_t>(k)]; }, [](std::int64_t) { return 1.0F; },
            [](std::int64_t, std::int64_t) { return 0.25F; });
    }
    std::vector<float> presence, length;
    bool closed;
};

TEST(HeldLength, EndsWhereThePresenceEnds) {
    const Line line({0, 1, 1, 1, 0, 1});
    EXPECT_FLOAT_EQ(line.held(1, 1).length, 2.25F) << "two steps, and a quarter of the third";
    EXPECT_EQ(line.held(1, 1).stopped_at, 4);
    EXPECT_FLOAT_EQ(line.held(1, -1).length, 0.25F);
    EXPECT_FLOAT_EQ(line.held(3, -1).length, 2.25F);
    EXPECT_FLOAT_EQ(line.held(0, 1).length, 0.0F) << "nothing is there";
}

TEST(HeldLength, StopsAtItsMaximumOrTheLinesEnd) {
    const Line line({1, 1, 1, 1, 1});
    EXPECT_FLOAT_EQ(line.held(0, 1, 2.5F).length, 2.5F);
    EXPECT_FLOAT_EQ(line.held(0, 1).length, 4.0F);
    EXPECT_FLOAT_EQ(line.held(0, 1, 100.0F, 10.0F).length, 14.0F) << "what lies beyond the end counts ten";
    EXPECT_EQ(line.held(0, 1).stopped_at, -1);
}

// A part with the presence 0.5 counts half for a full part, but the full part counts fully for it: a soft end belongs
// to its part.
TEST(HeldLength, WeightsStretchesByTheirPresenceUpToOne) {
    const Line line({0.5F, 0.5F, 1, 1, 1});
    EXPECT_FLOAT_EQ(line.held(4, -1).length, 2.0F + 0.75F + 0.5F);
    EXPECT_FLOAT_EQ(line.held(0, 1).length, 4.0F);
}

TEST(HeldLength, GoesAroundARingOnce) {
    const Line ring({1, 1, 1, 1, 1}, true);
    EXPECT_FLOAT_EQ(ring.held(2, 1).length, 5.0F) << "as many steps as samples: the first stands twice";
    const Line gap({1, 1, 0, 1, 1}, true);
    EXPECT_FLOAT_EQ(gap.held(3, 1).length, 2.25F) << "over the seam";
    EXPECT_FLOAT_EQ(gap.held(1, -1).length, 2.25F);
}

// The presence in the middle of a line goes from 1 to 0, and the held length never jumps.
TEST(HeldLength, ChangesSmoothlyWithThePresence) {
    float before = -1.0F;
    for (int k = 0; k <= 1000; ++k) {
        const float low = 1.0F - static_cast<float>(k) / 1000.0F;
        const Line line({1, 1, 1, low, 1, 1, 1});
        const float now = line.held(1, 1).length;
        if (before >= 0.0F && low > 0.0F) {
            EXPECT_NEAR(now, before, 0.01F) << low;
        }
        before = now;
    }
    EXPECT_NEAR(before, 1.25F, 0.5F);
}

TEST(Risen, RisesFromZeroToOne) {
    EXPECT_EQ(frame::ramp_between(1.0F, 1.0F, 3.0F), 0.0F);
    EXPECT_EQ(frame::ramp_between(2.0F, 1.0F, 3.0F), 0.5F);
    EXPECT_EQ(frame::ramp_between(5.0F, 1.0F, 3.0F), 1.0F);
    EXPECT_EQ(frame::ramp_between(1.0F, 1.0F, 1.0F), 0.0F) << "a step";
    EXPECT_EQ(frame::ramp_between(1.1F, 1.0F, 1.0F), 1.0F);
}

} // namespace
} // namespace hrbfnpr::testing::presence_test
