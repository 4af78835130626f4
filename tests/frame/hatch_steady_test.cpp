// SPDX-License-Identifier: MIT
// Tests that a drawn line of hatching changes little when its margins change little: no width pops.
#include "frame/hatching.h"

namespace hrbfnpr::testing::hatch_steady_test {
namespace {

// Checks the levels that fade in, up to where they are full.
TEST(HatchLaw, ALevelFadesInWithoutAJump) {
    LayerStyle style;
    for (const float gap : {0.5F, 0.7F, 1.0F, 1.5F}) {
        for (const float coverage : {0.1F, 0.2F, 0.5F}) {
            const float wanted = std::max(style.hatch_spacing, style.hatch_pen / coverage);
            law::HatchWidths before = law::hatch_widths(style, coverage, 1.001F * wanted, 4, gap);
            for (float spacing = 1.001F; spacing < 8.0F; spacing *= 1.001F) {
                const law::HatchWidths now = law::hatch_widths(style, coverage, spacing * wanted, 4, gap);
                for (int level = 0; level < 4; ++level) {
                    ASSERT_NEAR(std::min(law::level_margin(now, level), 1.0F),
                                std::min(law::level_margin(before, level), 1.0F), 0.02F)
                        << gap << ' ' << coverage << ' ' << spacing;
                    ASSERT_NEAR(law::hatch_width(now, level), law::hatch_width(before, level),
                                0.02F * std::max(before.width, now.width))
                        << gap << ' ' << coverage << ' ' << spacing;
                }
                before = now;
            }
        }
    }
}

class SteadyHatch : public Hatch {
protected:
    // The largest half width of a line between two x in the picture, in pixels.
    [[nodiscard]] double widest(double from, double to) const {
        double most = 0.0;
        for (const StrokePoint& p : frame.drawing().points)
            if (p.x > static_cast<float>(from) && p.x < static_cast<float>(to))
                most = std::max(most, static_cast<double>(p.radius));
        return most;
    }
    // Adds a line along x of the second of two levels, at 200 pixels per unit, with a style for which darkness_of()
    // gives the darkness at a margin of the level.
    void add_fading_line() {
        add_line(set, {0.0, -1.0, 1.0, 1}, 0.0025);
        set_nesting(set, separation, 1);
        cluster();
        layer.hatch_spacing = 0.5F;
        layer.hatch_white = 0.0F;
        layer.hatch_tone_begin = 0.0F;
    }
    [[nodiscard]] double darkness_of(float margin) const {
        double low = 0.0;
        double high = 1.0;
        while (high - low > 1e-6) {
            const double middle = 0.5 * (low + high);
            const float cover = law::hatch_coverage(layer, static_cast<float>(middle));
            const law::HatchWidths widths =
                law::hatch_widths(layer, cover, static_cast<float>(2.0 * separation * 200.0), 1);
            (law::level_margin(widths, 1) < margin ? low : high) = middle;
        }
        return low;
    }
    static constexpr double separation = 0.02;
};

// The core is as long as the shortest parts. Beside it the line is just drawn, or just not drawn.
TEST_F(SteadyHatch, AnAdjacentHairlineHardlyChangesAShortPart) {
    add_fading_line();
    std::vector<double> found;
    for (const float beside : {-0.02F, 0.02F}) {
        const double hair = darkness_of(beside);
        const double core = darkness_of(0.9F);
        darkness = [=](const glm::dvec3& p) {
            return std::abs(p.x) < 0.027 ? core : p.x > 0.0 && p.x < 0.3 ? hair : 0.0;
        };
        draw(front_camera(size, size, 1.25));
        found.push_back(widest(240.0, 260.0));
    }
    EXPECT_NEAR(found[0], found[1], 0.15 * static_cast<double>(layer.hatch_pen));
    EXPECT_GT(found[1], 0.0);
}

// A line that is thin all along is drawn as soon as there is room for it.
TEST_F(SteadyHatch, ALongHairlineIsDrawn) {
    add_fading_line();
    for (const float margin : {0.01F, 0.05F, 0.2F}) {
        const double hair = darkness_of(margin);
        darkness = [=](const glm::dvec3& p) { return std::abs(p.x) < 0.3 ? hair : 0.0; };
        draw(front_camera(size, size, 1.25));
        EXPECT_EQ(frame.drawing().strokes.size(), 1) << margin;
    }
}

// Two parts become one: between them the line becomes thinner little by little, wherever its points are. The tone falls
// by 0.2 per pixel, so a gap puts points where the line is thinnest, between two samples. This causes most of a step.
TEST_F(SteadyHatch, AGapOpensGradually) {
    add_line(set, {0.0, -1.0, 1.0, 0}, 0.001); // a fifth of a pixel
    set_nesting(set, 0.02, 0);
    cluster();
    for (const double middle : {0.0, 0.0033, 0.0066}) {
        double before = -1.0;
        for (double gap = -0.2; gap < 4.0; gap += 0.02) { // pixels
            darkness = [=](const glm::dvec3& p) { return 0.15 + 40.0 * (std::abs(p.x - middle) - 0.5 * gap / 200.0); };
            draw(front_camera(size, size, 1.25));
            double now = 0.0;
            for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s)
                now = std::max(now, radius_at(points_of(s), 250.0 + 200.0 * middle));
            if (before >= 0.0) {
                EXPECT_NEAR(now, before, 0.25) << middle << ' ' << gap;
            }
            before = now;
        }
        EXPECT_EQ(before, 0.0);
    }
}

// A small gap at the first mark of a closed line opens like any other gap.
TEST_F(SteadyHatch, AClosedLineBeginsInItsWidestGap) {
    add_circle(set, 0.8, 0.0, {0, 0, 1}, 400);
    set_nesting(set, 0.03, 0);
    cluster();
    darkness = [](const glm::dvec3& p) {
        if (p.x < 0.0) return 0.0;
        return std::abs(p.y) < 0.001 ? 0.1499 : 0.7;
    };
    draw(front_camera(size, size, 1.25));
    ASSERT_EQ(frame.drawing().strokes.size(), 1);
    EXPECT_NEAR(points_of(0).back().length, 160.0 * pi, 15.0);
}

// Lines of all widths have the same width at the same small distance from their ends.
TEST_F(SteadyHatch, TipsHaveTheSameWidthForAllLines) {
    add_line(set, {0.0, -1.0, 1.0, 0}, 0.02);
    set_nesting(set, 0.02, 0);
    cluster();
    for (const float cover : {0.3F, 0.6F, 0.9F}) {
        layer.hatch_coverage_begin = layer.hatch_coverage_end = cover;
        draw(front_camera(size, size, 1.25));
        ASSERT_EQ(frame.drawing().strokes.size(), 1);
        for (const double place : {50.3, 449.7})
            EXPECT_NEAR(radius_at(points_of(0), place), 0.05 * static_cast<double>(layer.hatch_pen), 1e-4) << cover;
    }
}

} // namespace
} // namespace hrbfnpr::testing::hatch_steady_test
