// SPDX-License-Identifier: MIT
#include "same_strokes.h"
#include "stroke_ends.h"
#include "stroke_gaps.h"
#include "tone_windows.h"
#include "width_changes.h"

#include <gtest/gtest.h>

namespace bench::strokes_test {
namespace {

// A stroke along x. Its marks are numbered from `id` on.
DrawnStroke line(float y, float from, float to, float radius = 0.5F, std::uint32_t id = 1) {
    DrawnStroke stroke;
    for (float x = from; x <= to; x += 2.0F) stroke.push_back({x, y, 0.0F, radius, id++});
    return stroke;
}

TEST(StrokeMeasures, EndsAtTheBorderDoNotCount) {
    StrokeEnds ends;
    add_ends(ends, line(50.0F, 0.0F, 100.0F), 100.0, 100.0);
    EXPECT_EQ(ends.ends, 0.0);
    add_ends(ends, line(60.0F, 20.0F, 70.0F), 100.0, 100.0);
    EXPECT_EQ(ends.ends, 2.0);
    EXPECT_EQ(ends.shorts, 0.0);
    EXPECT_NEAR(ends.length, 150.0, 1e-6);
    add_ends(ends, line(70.0F, 20.0F, 26.0F), 100.0, 100.0);
    EXPECT_EQ(ends.shorts, 1.0);
    DrawnStroke closed = line(80.0F, 20.0F, 70.0F);
    closed.push_back(closed.front());
    add_ends(ends, closed, 100.0, 100.0);
    EXPECT_EQ(ends.ends, 4.0);
}

TEST(StrokeMeasures, GapsAreMeasuredAcrossLines) {
    std::vector<DrawnStroke> strokes{line(10.0F, 0.0F, 100.0F), line(13.0F, 0.0F, 100.0F), line(18.0F, 0.0F, 100.0F)};
    strokes.push_back({{50.0F, 0.0F, 0.0F, 0.5F, 9}, {50.0F, 40.0F, 0.0F, 0.5F, 9}}); // crosses the other lines
    std::vector<double> gaps;
    int alone = 0;
    for_each_gap(strokes, {}, [&](const StrokePoint&, const std::optional<Gap>& gap) {
        if (gap)
            gaps.push_back(gap->size);
        else
            ++alone;
    });
    EXPECT_GT(alone, 0);
    ASSERT_EQ(gaps.size(), 80U);
    for (const double gap : gaps) EXPECT_TRUE(std::abs(gap - 3.0) < 1e-5 || std::abs(gap - 5.0) < 1e-5) << gap;
    EXPECT_NEAR(spread_of(gaps).mean, 4.0, 1e-5);
    EXPECT_NEAR(spread_of(gaps).variation, 0.25, 1e-5);
}

TEST(StrokeMeasures, LengthIsSharedOnlyWithTheSameLine) {
    const std::vector<DrawnStroke> one{line(10.0F, 0.0F, 100.0F)};
    const auto by_hundred = [](std::uint32_t id) { return id / 100; };
    const std::vector<DrawnStroke> half{line(20.6F, 0.0F, 100.0F)}; // twice as large
    EXPECT_NEAR(shared_length(one, half, 0.5, 0.5, by_hundred).share(), 0.5, 0.02);
    EXPECT_EQ(shared_length(one, half, 0.5, 0.2, by_hundred).share(), 0.0);
    EXPECT_EQ(shared_length(one, {line(10.0F, 0.0F, 100.0F, 0.5F, 100)}, 1.0, 0.5, by_hundred).share(), 0.0);
}

TEST(StrokeMeasures, SuddenInkIsAPop) {
    const auto frames_of = [](const std::vector<float>& widths) {
        std::vector<std::vector<MarkInk>> frames;
        for (const float width : widths) frames.push_back({{width, true}});
        return frames;
    };
    EXPECT_EQ(width_changes(frames_of({0.0F, 0.4F, 0.8F, 1.0F})).pops, 0.0);
    EXPECT_EQ(width_changes(frames_of({0.0F, 0.6F, 1.0F})).pops, 1.0);
    EXPECT_EQ(width_changes(frames_of({0.0F, 0.6F, 1.0F})).removals, 0.0);
    EXPECT_EQ(width_changes(frames_of({1.0F, 0.4F, 0.0F})).removals, 1.0);
    auto hidden = frames_of({0.0F, 1.0F});
    hidden[1][0].counts = false;
    EXPECT_EQ(width_changes(hidden).shown, 0.0);
}

TEST(StrokeMeasures, AVanishingHairlineIsNoPop) {
    const std::vector<std::vector<MarkInk>> frames{{{0.1F, true}}, {{0.0F, true}}};
    EXPECT_EQ(width_changes(frames).pops, 1.0);
    EXPECT_EQ(width_changes(frames, 0.4F).pops, 0.0);
}

// The marks are 2 pixels apart.
TEST(StrokeMeasures, AStrokePutsInkOnAllMarksThatItPasses) {
    std::vector<MarkPlace> places(10, MarkPlace{1, 0, 10, false});
    std::vector<glm::vec2> images;
    for (int i = 0; i < 10; ++i) images.emplace_back(2.0F * static_cast<float>(i), 0.5F);
    std::vector<MarkInk> inks(10);
    const DrawnStroke stroke{{3.4F, 0.0F, 0.0F, 0.5F, 3}, {11.4F, 0.0F, 0.0F, 1.5F, 7}};
    add_widths(stroke, places, images, inks);
    EXPECT_EQ(inks[1].width, 0.0F) << "more than a pixel before the beginning";
    EXPECT_NEAR(inks[2].width, 1.15F, 1e-5F);
    EXPECT_NEAR(inks[5].width, 2.65F, 1e-5F);
    EXPECT_EQ(inks[6].width, 3.0F);
    EXPECT_EQ(inks[7].width, 0.0F) << "more than a pixel beyond the end";
    // An open line does not continue from its end to its beginning, even if two of its points have distant marks.
    inks.assign(10, {});
    const DrawnStroke whole{{0.0F, 0.0F, 0.0F, 1.0F, 1}, {18.0F, 0.0F, 0.0F, 1.0F, 10}};
    add_widths(whole, places, images, inks);
    for (const MarkInk& ink : inks) EXPECT_EQ(ink.width, 2.0F);
    for (MarkPlace& place : places) place.closed = true;
    inks.assign(10, {});
    add_widths(whole, places, images, inks);
    EXPECT_EQ(inks[5].width, 0.0F);
    EXPECT_EQ(inks[0].width, 2.0F);
    EXPECT_EQ(inks[9].width, 2.0F);
}

// The points of a tip have the id of the first mark, and are nearer to it than to the mark of the line's next point.
TEST(StrokeMeasures, MarksAtATipHaveTheWidthOfTheTip) {
    std::vector<MarkPlace> places(10, MarkPlace{1, 0, 10, false});
    std::vector<glm::vec2> images;
    for (int i = 0; i < 10; ++i) images.emplace_back(0.4F * static_cast<float>(i), 0.0F);
    std::vector<MarkInk> inks(10);
    const DrawnStroke tip{{0.0F, 0.0F, 0.0F, 0.0F, 1}, {1.25F, 0.0F, 0.0F, 0.5F, 1}, {2.8F, 0.0F, 0.0F, 0.5F, 8}};
    add_widths(tip, places, images, inks);
    EXPECT_NEAR(inks[2].width, 0.64F, 1e-5F);
    EXPECT_NEAR(inks[3].width, 0.96F, 1e-5F);
    EXPECT_EQ(inks[5].width, 1.0F);
}

TEST(StrokeMeasures, ToneIsComparedInWindows) {
    constexpr int size = 80;
    ToneImage asked{size, size, std::vector<float>(size * size, 0.5F), std::vector<bool>(size * size, true)};
    ToneImage drawn = asked;
    for (int i = 0; i < size * size; ++i) drawn.share[static_cast<std::size_t>(i)] = i / size % 4 < 2 ? 1.0F : 0.0F;
    const ToneSums lines = compare_tones(drawn, asked, 4.0);
    EXPECT_GT(lines.psnr(), 50.0); // separate lines add no error
    EXPECT_NEAR(lines.bias(), 0.0, 1e-3);
    for (float& share : drawn.share) share *= 0.9F;
    EXPECT_NEAR(compare_tones(drawn, asked, 4.0).bias(), -0.05, 1e-3);
    EXPECT_NEAR(compare_tones(drawn, asked, 4.0).psnr(), 26.0, 0.2);
    asked.counts[size * size / 2 + size / 2] = false;
    EXPECT_EQ(compare_tones(drawn, asked, 14.0).number, 0.0);
}

} // namespace
} // namespace bench::strokes_test
