// SPDX-License-Identifier: MIT
// Tests lines of hatching that look drawn by an unsteady hand.
#include "frame/hatching.h"

namespace hrbfnpr::testing::hatch_hand_test {
namespace {

constexpr double apart = 0.1; // 20 pixels

class HatchByHand : public Hatch {
protected:
    HatchByHand() {
        for (int i = 0; i < 9; ++i) add_line(set, {apart * (i - 4), -1.0, 1.0, 0}, 0.01);
        set_nesting(set, apart, 0);
        cluster();
    }
    // The right end of each line, where the left half is dark.
    std::vector<float> ends(double zoom = 1.25) {
        darkness = [](const glm::dvec3& p) { return 0.15 - p.x; };
        draw(front_camera(size, size, zoom));
        std::vector<float> found;
        for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s)
            found.push_back(std::max(points_of(s).front().x, points_of(s).back().x) - 250.0F);
        return found;
    }
};

TEST_F(HatchByHand, LinesStrayWithinTheirLimit) {
    layer.hatch_pen = 2.0F;
    layer.hatch_wobble = 1.5F;
    float most = 0.0F;
    for (const std::uint32_t seed : {0U, 1U, 2U, 3U}) {
        layer.hatch_seed = seed;
        draw(front_camera(size, size, 1.25));
        ASSERT_EQ(frame.drawing().strokes.size(), 9);
        for (std::int64_t s = 0; s < 9; ++s) {
            const float straight = 250.0F - 20.0F * std::round((250.0F - points_of(s).front().y) / 20.0F);
            StrokePoint before{};
            for (const StrokePoint& p : points_of(s)) {
                most = std::max(most, std::abs(p.y - straight));
                if (p.x > 53.0F) {
                    EXPECT_LE(std::abs(p.y - before.y), 0.16F * std::abs(p.x - before.x)) << "smooth";
                }
                before = p;
            }
        }
    }
    EXPECT_GT(most, 1.0F);
    EXPECT_LE(most, 3.0F);
}

TEST_F(HatchByHand, EachSeedGivesADifferentHand) {
    layer.hatch_wobble = 2.0F;
    const auto y = [&](std::uint32_t seed) {
        layer.hatch_seed = seed;
        draw(front_camera(size, size, 1.25));
        return points_of(4)[40].y;
    };
    const float first = y(7);
    EXPECT_EQ(first, y(7));
    EXPECT_NE(first, y(8));
}

TEST_F(HatchByHand, LinesOvershootTheirTone) {
    for (const float end : ends()) EXPECT_NEAR(end, 0.0F, 0.1F);
    layer.hatch_overshoot = 30.0F;
    const std::vector<float> longer = ends();
    const auto [least, most] = std::minmax_element(longer.begin(), longer.end());
    EXPECT_GE(*least, -0.1F);
    EXPECT_LE(*most, 30.1F);
    EXPECT_GT(*most - *least, 8.0F) << "each by another length";
    EXPECT_EQ(ends(), longer);
}

// From picture to picture the longer lines are the same ones, and no length jumps.
TEST_F(HatchByHand, LengthsChangeLittleFromFrameToFrame) {
    layer.hatch_overshoot = 30.0F;
    layer.hatch_wobble = 2.0F;
    std::vector<float> before = ends();
    for (double zoom = 1.25; zoom > 1.0; zoom -= 0.01) {
        const std::vector<float> now = ends(zoom);
        ASSERT_EQ(now.size(), before.size());
        for (std::size_t i = 0; i < now.size(); ++i) EXPECT_NEAR(now[i], before[i], 2.0F) << zoom;
        before = now;
    }
}

TEST_F(HatchByHand, NoLineRunsOutOfItsSurface) {
    layer.hatch_overshoot = 30.0F;
    darkness = [](const glm::dvec3& p) {
        return p.x < 0.97 ? 0.8 : 0.0;
    }; // up to 6 pixels before the end of the surface
    draw(front_camera(size, size, 1.25));
    ASSERT_EQ(frame.drawing().strokes.size(), 9);
    for (std::int64_t s = 0; s < 9; ++s)
        for (const StrokePoint& p : points_of(s)) EXPECT_LE(p.x, 450.01F);
}

TEST_F(HatchByHand, AClosedLineStaysClosed) {
    marks::PointSet circle(runtime.memory);
    add_circle(circle, 0.8, 0.0, {0, 0, 1}, 400, false);
    set_nesting(circle, 0.03, 0);
    set = clustered(runtime, std::move(circle));
    layer.hatch_pen = 2.0F;
    layer.hatch_wobble = 2.0F;
    draw(front_camera(size, size, 1.25));
    ASSERT_EQ(frame.drawing().strokes.size(), 1);
    EXPECT_TRUE(frame.drawing().strokes[0].closed);
    const auto points = points_of(0);
    EXPECT_NEAR(points.front().x, points.back().x, 1e-3F);
    EXPECT_NEAR(points.front().y, points.back().y, 1e-3F);
    float most = 0.0F;
    for (const StrokePoint& p : points)
        most = std::max(most, std::abs(std::hypot(p.x - 250.0F, p.y - 250.0F) - 160.0F));
    EXPECT_GT(most, 1.0F);
    EXPECT_LE(most, 4.05F);
}

} // namespace
} // namespace hrbfnpr::testing::hatch_hand_test
