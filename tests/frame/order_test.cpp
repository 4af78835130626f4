// SPDX-License-Identifier: MIT
// The order of painting, and what does not depend on threads or on memory.
#include "frame/hand_made.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace hrbfnpr::testing::order_test {
namespace {

using frame::HiddenLines;

// Slow and plain: the painting order by comparing eye depths.
TEST(PaintingOrder, IsFarToNearWithInkBeforeItsMarkAndPaperBehindIt) {
    base::Runtime runtime;
    marks::PointSet set(runtime.memory);
    set.spacing = 0.04;
    // A mark every 0.01 of depth, facing the eye; 100 pixels a unit.
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

class Kept : public ::testing::TestWithParam<HiddenLines> {
protected:
    static std::vector<std::byte> bytes_of(const DrawnFrame& frame) {
        std::vector<std::byte> bytes;
        for (const Disc& disc : frame.discs()) {
            const float numbers[] = {disc.x,
                                     disc.y,
                                     disc.radius,
                                     disc.depth,
                                     disc.color.x,
                                     disc.color.w,
                                     static_cast<float>(disc.is_paper),
                                     static_cast<float>(disc.mark_class)};
            const std::size_t at = bytes.size();
            bytes.resize(at + sizeof numbers + sizeof disc.id);
            std::memcpy(bytes.data() + at, numbers, sizeof numbers);
            std::memcpy(bytes.data() + at + sizeof numbers, &disc.id, sizeof disc.id);
        }
        return bytes;
    }
    static Style style() {
        Style style;
        style.hidden_lines = GetParam();
        style.zoom_reference = 200.0;
        style.depth_min = 9.5;
        style.depth_max = 12.0;
        return style;
    }
};

TEST_P(Kept, SameBitsForAnyThreadCount) {
    std::vector<std::byte> expected;
    for (const int threads : {1, 2, 3, 7}) {
        const base::Runtime runtime = test::with_threads(threads);
        const marks::PointSet set = sphere(runtime.memory, 30000);
        const std::array items{item_of(set, style())};
        DrawnFrame frame(runtime);
        frame.draw(items, front_camera(400, 400));
        const std::vector<std::byte> bytes = bytes_of(frame);
        EXPECT_FALSE(bytes.empty());
        if (expected.empty()) expected = bytes;
        EXPECT_EQ(bytes, expected) << threads;
    }
}

frame::Camera orbit(int step) {
    frame::Camera camera = front_camera(300, 300);
    const double angle = 0.5 * step;
    camera.view = frame::look_at({8.0 * std::sin(angle), 3.0, 8.0 * std::cos(angle)}, glm::dvec3(0.0), {0, 1, 0});
    camera.projection = frame::perspective(0.4, 300, 300, 1.0, 20.0, camera.depth);
    return camera;
}

std::int32_t half_tone(void*, std::int64_t count, const float*, const float*, float* tau) {
    std::fill(tau, tau + count, 0.5F);
    return 0;
}

TEST_P(Kept, AllocatesNothingOnceWarm) {
    test::Allocator counter;
    const base::Runtime runtime = test::with_allocator(counter);
    const marks::PointSet set = torus(runtime.memory, 100);
    std::array items{item_of(set, style()), item_of(set, style())};
    items[1].style.tone = frame::Tone::callback;
    items[1].style.tone_function = half_tone;
    DrawnFrame frame(runtime);
    frame.draw(items, orbit(0));
    const std::int64_t warm = counter.calls;
    frame.draw(items, orbit(0));
    EXPECT_EQ(counter.calls, warm) << "the same view again";
    for (int step = 0; step < 13; ++step) frame.draw(items, orbit(step));
    const std::int64_t once_round = counter.calls;
    for (int step = 0; step < 13; ++step) frame.draw(items, orbit(step));
    EXPECT_EQ(counter.calls, once_round) << "a second time round";
    EXPECT_GT(frame.info().scratch_bytes, 0);
    EXPECT_LE(frame.info().scratch_bytes, runtime.memory.bytes_now());
}

INSTANTIATE_TEST_SUITE_P(HiddenLines, Kept,
                         ::testing::Values(HiddenLines::attenuate, HiddenLines::hide, HiddenLines::show),
                         [](const auto& one) { return "mode_" + std::to_string(static_cast<int>(one.param)); });

} // namespace
} // namespace hrbfnpr::testing::order_test
