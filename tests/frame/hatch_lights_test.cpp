// SPDX-License-Identifier: MIT
// Tests hatching in the lights: lines become fewer, end one after the other, and break before they end.
#include "frame/hatch/hand.h"
#include "frame/hatching.h"

#include <numeric>

namespace hrbfnpr::testing::hatch_lights_test {
namespace {

constexpr double pixels = 200.0; // per unit

class BrokenHatch : public Hatch {
protected:
    BrokenHatch() {
        set = nested_plane(runtime.memory);
        cluster();
        // At hatch_tone_begin there is space for the finest lines, which are two pixels apart.
        layer.hatch_spacing = 0.5F;
        layer.hatch_pen = 0.2F;
        layer.hatch_white = 0.0F;
        layer.hatch_tone_begin = 0.4F;
        layer.hatch_fade = 0.4F;
    }
    void draw_plane() { draw(front_camera(size, size, 1.25)); }
    // Sets a darkness that falls from left to right, by 0.4 per unit. It is 0.2 at x = `middle`.
    void set_ramp(double middle = 0.0) {
        darkness = [=](const glm::dvec3& p) { return std::max(0.2 + 0.4 * (middle - p.x), 0.0); };
    }
    // The right ends of the lines of a level in the picture, without further parts of broken lines.
    [[nodiscard]] std::vector<double> ends(int level) const {
        std::vector<double> found;
        for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s) {
            const auto points = points_of(s);
            const auto line =
                static_cast<int>(std::lround((250.0 - static_cast<double>(points.front().y)) / (pixels * step)));
            if (points.front().x < 52.0F && level_of(line) == level)
                found.push_back(static_cast<double>(points.back().x));
        }
        return found;
    }
    // The widths at places that are a pixel apart along all lines.
    [[nodiscard]] std::vector<float> widths() const {
        std::vector<float> found(201 * std::size_t{size}, 0.0F);
        for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s) {
            const auto points = points_of(s);
            const auto line = 100 + std::lround((250.0 - static_cast<double>(points.front().y)) / (pixels * step));
            for (int x = 0; x < size; ++x) {
                float& width = found[static_cast<std::size_t>(line) * std::size_t{size} + static_cast<std::size_t>(x)];
                width = std::max(width, static_cast<float>(2.0 * radius_at(points, x)));
            }
        }
        return found;
    }
};

struct Spread {
    double mean, deviation;
};
Spread spread_of(const std::vector<double>& values) {
    const double count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / count)};
}

// Without tapers and least lengths, which take ink from short parts.
TEST_F(BrokenHatch, CoverageFallsEvenlyToZero) {
    layer.hatch_shortest = 0.0F;
    layer.hatch_taper = 1.0F;
    for (const double dark : {0.39, 0.3, 0.2, 0.12, 0.06}) {
        darkness = [=](const glm::dvec3&) { return dark; };
        draw_plane();
        EXPECT_NEAR(coverage(layer, dark), 0.25 * dark, 1e-6);
        EXPECT_NEAR(plane_ink(1.25), 0.25 * dark, 0.06 * 0.1) << dark;
    }
}

TEST_F(BrokenHatch, LinesOfALevelEndAtDifferentTones) {
    set_ramp();
    draw_plane();
    double before = 0.0;
    for (int level = finest; level >= 1; --level) {
        const std::vector<double> found = ends(level);
        ASSERT_GE(found.size(), 25U) << level;
        const Spread spread = spread_of(found);
        EXPECT_GT(spread.deviation, 8.0) << level;
        EXPECT_GT(spread.mean, before + 20.0) << "coarser lines end in lighter tones";
        before = spread.mean;
    }
    layer.hatch_fade = 0.0F;
    draw_plane();
    for (int level = finest; level >= 1; --level) EXPECT_LT(spread_of(ends(level)).deviation, 0.1) << level;
}

TEST_F(BrokenHatch, LinesBreakInAnEvenTone) {
    darkness = [](const glm::dvec3&) { return 0.15; };
    draw_plane();
    EXPECT_GT(frame.drawing().strokes.size(), 150);
    layer.hatch_tone_begin = 0.15F;
    layer.hatch_coverage_begin = static_cast<float>(0.25 * 0.15);
    layer.hatch_fade = 0.0F;
    draw_plane();
    EXPECT_LT(frame.drawing().strokes.size(), 105) << "the same coverage in whole lines";
}

TEST_F(BrokenHatch, WidthsChangeLittleWithTheTone) {
    set_ramp();
    draw_plane();
    std::vector<float> before = widths();
    for (double middle = 0.002; middle < 0.05; middle += 0.002) { // the darkness changes by 0.0008
        set_ramp(middle);
        draw_plane();
        const std::vector<float> now = widths();
        for (std::size_t i = 0; i < now.size(); ++i)
            ASSERT_NEAR(now[i], before[i], 0.6F * layer.hatch_pen) << middle << ' ' << i;
        before = now;
    }
}

// Where a line is drawn in a picture, it is drawn in one from nearer, too.
TEST_F(BrokenHatch, NoLineVanishesAsTheEyeComesNearer) {
    darkness = [](const glm::dvec3& p) { return 0.2 + 0.15 * p.x; };
    const auto drawn = [&](double half) {
        draw(front_camera(size, size, half));
        std::vector<bool> found(201 * 201, false);
        const double scale = 0.5 * size / half;
        for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s) {
            const auto points = points_of(s);
            const auto line = 100 + std::lround((250.0 - static_cast<double>(points.front().y)) / (scale * step));
            if (line < 0 || line > 200) continue;
            for (int i = 0; i <= 200; ++i)
                if (radius_at(points, 250.0 + scale * step * (i - 100)) > 0.02)
                    found[static_cast<std::size_t>(201 * line + i)] = true;
        }
        return found;
    };
    std::vector<bool> before = drawn(2.5);
    for (double half = 2.4; half > 1.2; half -= 0.1) {
        const std::vector<bool> now = drawn(half);
        int lost = 0;
        for (std::size_t i = 0; i < now.size(); ++i) lost += before[i] && !now[i] ? 1 : 0;
        EXPECT_LE(lost, 2) << half;
        before = now;
    }
}

TEST_F(BrokenHatch, WhiteStaysEmpty) {
    darkness = [](const glm::dvec3& p) { return p.x < 0.0 ? 0.3 : 0.0; };
    draw_plane();
    EXPECT_GT(frame.drawing().strokes.size(), 50);
    for (const StrokePoint& p : frame.drawing().points) EXPECT_LT(p.x, 253.0F);
}

TEST_F(BrokenHatch, ALargerFadeCountsUpToTheFirstTone) {
    set_ramp();
    draw_plane();
    const std::vector<float> whole = widths();
    layer.hatch_fade = 1.0F;
    draw_plane();
    EXPECT_EQ(widths(), whole);
}

TEST_F(BrokenHatch, EachSeedBreaksLinesElsewhere) {
    set_ramp();
    draw_plane();
    const std::vector<float> first = widths();
    draw_plane();
    EXPECT_EQ(widths(), first);
    layer.hatch_seed = 1;
    draw_plane();
    EXPECT_NE(widths(), first);
}

// Lines of unknown distance are as wide as the law says, and end where they would be thinner than half of that.
TEST_F(BrokenHatch, LinesOfUnknownDistanceEndAtDifferentTones) {
    set = marks::PointSet(runtime.memory);
    for (int i = 0; i < 15; ++i) add_line(set, {0.1 * (i - 7), -1.0, 1.0, 0}, 0.01);
    set.spacing = step;
    cluster();
    set_ramp();
    draw_plane();
    std::vector<double> found;
    for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s)
        if (points_of(s).front().x < 52.0F) found.push_back(static_cast<double>(points_of(s).back().x));
    ASSERT_EQ(found.size(), 15U);
    // The coverage is 1 at x = 150 and one half at x = 250.
    EXPECT_GT(spread_of(found).mean, 170.0);
    EXPECT_LT(spread_of(found).mean, 250.0);
    EXPECT_GT(spread_of(found).deviation, 10.0);
}

// The coverage changes only where it is below twice that at hatch_tone_begin.
TEST(HatchNoise, KeepsTheMeanCoverage) {
    LayerStyle style;
    style.hatch_tone_begin = 0.3F;
    style.hatch_tone_end = 0.9F;
    style.hatch_coverage_end = 0.6F;
    style.hatch_fade = 0.2F;
    const frame::HatchLights lights(style);
    for (const float dark : {0.05F, 0.15F, 0.25F, 0.3F, 0.35F, 0.45F}) {
        const float wanted = law::hatch_coverage(style, dark);
        double sum = 0.0;
        float most = 0.0F;
        constexpr int strokes = 1000;
        for (int s = 0; s < strokes; ++s) {
            frame::StrokeNoise noise(0, s, 0);
            std::array<float, 64> level{};
            std::array<float, 64> darkness{};
            darkness.fill(dark);
            frame::vary_lights(lights, noise, 0, 3, level, darkness);
            for (const float value : darkness) {
                const float drawn = law::hatch_coverage(style, value);
                sum += static_cast<double>(drawn) / (64.0 * strokes);
                most = std::max(most, std::abs(drawn - wanted));
                EXPECT_LE(value, lights.darkest(dark) + 1e-6F);
            }
        }
        // Above hatch_tone_begin the law is slightly bent.
        EXPECT_NEAR(sum, static_cast<double>(wanted), dark < 0.25F ? 0.001 : 0.002) << dark;
        const bool varies = dark > 0.1F && dark < 0.44F;
        EXPECT_EQ(most > 0.0F, varies) << dark;
        EXPECT_TRUE(!varies || most > 0.01F) << dark;
    }
}

} // namespace
} // namespace hrbfnpr::testing::hatch_lights_test
