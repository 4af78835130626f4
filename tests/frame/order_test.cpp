// SPDX-License-Identifier: MIT
// Tests the order of painting.
#include "frame/hand_made.h"

#include <gtest/gtest.h>

namespace hrbfnpr::testing::order_test {
namespace {

// The test checks the painting order by comparing eye depths, slowly and plainly.
TEST(PaintingOrder, IsFarToNearWithPaperBehindItsInk) {
    base::Runtime runtime;
    marks::PointSet set(runtime.memory);
    set.spacing = 0.04;
    // A mark every 0.01 of depth faces the eye; 100 pixels per unit.
    for (int i = 0; i < 100; ++i) add_stipple(set, {0.0, 0.0, 0.01 * i}, {0.0, 0.0, 1.0});
    Style style;
    style.tone = frame::Tone::none;
    style.splat_radius = 5.0F; // 0.05 units
    style.kind[0].radius = 2.0F;
    const std::array items{item_of(set, style)};
    DrawnFrame frame(runtime);
    frame.draw(items, front_camera(200, 200, 1.0));
    ASSERT_EQ(frame.discs().size(), 200U);
    double before = -100.0;
    for (const Disc& disc : frame.discs()) {
        const double mark = 0.01 * (disc.id - 1);
        const double place = disc.is_paper ? mark - 0.05 : mark + 0.02;
        EXPECT_GE(place, before - 1e-5);
        before = place;
    }
}

} // namespace
} // namespace hrbfnpr::testing::order_test
