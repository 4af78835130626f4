// SPDX-License-Identifier: MIT
// Tests that stipples are spread evenly in the picture: against a plain reference that visits all pairs of marks, and
// by the promises of the rule.
#include "frame/depth_layers/even.h"
#include "frame/depth_layers/tuning.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace hrbfnpr::testing::even_test {
namespace {

using frame::EvenMark;
using frame::layer_tuning;

constexpr float radius = 2.0F;

struct Marks {
    std::vector<EvenMark> marks;
    std::vector<glm::vec3> places; // x and y in pixels, and depth
};

// Marks at random places of a plane that is tilted around the y axis. Depths are in pixels.
Marks tilted(int count, float facing, float size, float zoom, float wanted, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
    Marks made;
    const float slope = std::sqrt(1.0F - facing * facing) / facing;
    const float spacing = zoom * size / std::sqrt(static_cast<float>(count)) / std::sqrt(facing);
    for (int i = 0; i < count; ++i) {
        const float x = zoom * size * (uniform(random) - 0.5F);
        const float y = zoom * size * (uniform(random) - 0.5F);
        const float place = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        const float shown = facing * spacing * spacing / (wanted * wanted);
        made.places.push_back({x + 320.0F, y + 240.0F, slope * x});
        made.marks.push_back({place,
                              spacing * frame::own_distance(facing) / std::sqrt(place),
                              wanted,
                              place * frame::flat_place(facing),
                              shown,
                              facing,
                              {-std::sqrt(1.0F - facing * facing), 0.0F},
                              {slope, 0.0F},
                              0.0F,
                              0.25F});
    }
    return made;
}

// Returns the part of its area that each mark keeps.
std::vector<float> kept(const base::Runtime& runtime, const Marks& given) {
    frame::Scene scene(runtime.memory);
    frame::Run run;
    run.even_in_picture = true;
    scene.runs.push_back(run);
    drawing::Drawing drawing(runtime.memory);
    drawing.pixels = {640, 480};
    for (std::size_t i = 0; i < given.marks.size(); ++i) {
        drawing::Dot dot{};
        dot.x = given.places[i].x;
        dot.y = given.places[i].y;
        dot.depth = given.places[i].z;
        dot.radius = radius;
        dot.pixels_per_unit = 1.0F;
        dot.id = static_cast<std::uint32_t>(i);
        drawing.dots.push_back(dot);
    }
    drawing.dot_ranges.push_back({0, drawing.dots.size()});
    frame::EvenOrder order(runtime.memory);
    order.run(runtime, scene, given.marks, drawing);
    std::vector<float> part(given.marks.size(), 0.0F);
    for (std::int64_t i = 0; i < drawing.dot_ranges[0].end; ++i)
        part[drawing.dots[i].id] = drawing.dots[i].radius * drawing.dots[i].radius / (radius * radius);
    EXPECT_EQ(drawing.dot_ranges[0].end + drawing.counts.dropped_tone + drawing.counts.outside, drawing.dots.size());
    return part;
}

// The rule as docs/how-marks-work.md describes it, for marks on one plane that stand in their order.
std::vector<float> reference(const Marks& given, float reach) {
    std::vector<float> part(given.marks.size());
    for (std::size_t i = 0; i < part.size(); ++i) {
        const EvenMark& mark = given.marks[i];
        float left = 1.0F;
        for (std::size_t j = 0; j < i; ++j) {
            const float pixels = glm::distance(glm::vec2(given.places[i]), glm::vec2(given.places[j]));
            const float near = std::clamp((1.0F - pixels / reach) / layer_tuning.even_soft, 0.0F, 1.0F);
            const float shown = std::clamp(
                (given.marks[j].own * reach / (mark.wanted * pixels) - 1.0F) / layer_tuning.even_shown, 0.0F, 1.0F);
            left *= 1.0F - near * near * (3.0F - 2.0F * near) * shown;
        }
        part[i] = std::clamp((mark.shown - mark.flat) / (mark.fade * mark.shown), 0.0F, 1.0F) *
                  std::max(0.0F, (left - layer_tuning.even_least) / (1.0F - layer_tuning.even_least));
    }
    return part;
}

TEST(Even, IsTheRuleOfAllPairs) {
    const base::Runtime runtime;
    const Marks given = tilted(4000, 0.5F, 300.0F, 1.0F, 6.0F);
    const std::vector<float> fast = kept(runtime, given);
    // The densest packing's distance times the measured reach at n . v = 0.5.
    const std::vector<float> plain = reference(given, 0.9041F * 1.0745699F * 6.0F);
    double sum = 0.0;
    int shown = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        ASSERT_NEAR(fast[i], plain[i], 2e-3F) << i;
        sum += static_cast<double>(plain[i]);
        shown += plain[i] > 0.0F && plain[i] < 1.0F;
    }
    EXPECT_GT(sum, 500.0);
    EXPECT_GT(shown, 300);
}

TEST(Even, ZoomingInMakesNoMarkSmaller) {
    const base::Runtime runtime;
    std::vector<float> before;
    for (int step = 0; step < 12; ++step) {
        const float zoom = std::pow(1.05F, static_cast<float>(step));
        const std::vector<float> now = kept(runtime, tilted(6000, 0.4F, 240.0F, zoom, 5.0F));
        for (std::size_t i = 0; i < before.size(); ++i) ASSERT_GE(now[i], before[i] - 1e-3F) << step << ", " << i;
        before = now;
    }
}

TEST(Even, MarksChangeSmoothlyAsTheSurfaceTurns) {
    const base::Runtime runtime;
    const auto turned = [](float facing) {
        Marks made = tilted(6000, facing, 300.0F, 1.0F, 5.0F);
        for (glm::vec3& place : made.places) place.x = 320.0F + (place.x - 320.0F) * facing;
        return made;
    };
    std::vector<float> before;
    for (int step = 0; step < 8; ++step) {
        const std::vector<float> now = kept(runtime, turned(0.6F + 0.002F * static_cast<float>(step)));
        for (std::size_t i = 0; i < before.size(); ++i) ASSERT_NEAR(now[i], before[i], 0.25F) << step << ", " << i;
        before = now;
    }
}

// A hidden sheet does not take marks from the sheet in front of it.
TEST(Even, SheetsDoNotSeeEachOther) {
    const base::Runtime runtime;
    const Marks front = tilted(3000, 0.5F, 300.0F, 1.0F, 6.0F);
    Marks both = front;
    const Marks behind = tilted(3000, 0.5F, 300.0F, 1.0F, 6.0F, 2);
    for (std::size_t i = 0; i < behind.marks.size(); ++i) {
        both.marks.push_back(behind.marks[i]);
        both.places.push_back(behind.places[i] + glm::vec3(0.0F, 0.0F, 40.0F));
    }
    const std::vector<float> alone = kept(runtime, front);
    const std::vector<float> together = kept(runtime, both);
    for (std::size_t i = 0; i < alone.size(); ++i) ASSERT_EQ(alone[i], together[i]) << i;
}

TEST(Even, IsTheSameForAnyNumberOfThreadsAndInstructionSet) {
    const Marks given = tilted(20000, 0.3F, 400.0F, 1.0F, 4.0F);
    const base::Runtime one;
    const std::vector<float> first = kept(one, given);
    base::Runtime other;
    other.parallel = base::Parallel(3, nullptr, nullptr);
    EXPECT_EQ(kept(other, given), first);
    for (const base::InstructionSet set : test::instruction_sets()) {
        other.instruction_set = set;
        EXPECT_EQ(kept(other, given), first);
    }
}

TEST(Even, MarksOutsideTheWindowAreRemoved) {
    const base::Runtime runtime;
    Marks given = tilted(100, 0.9F, 100.0F, 1.0F, 20.0F);
    for (EvenMark& mark : given.marks) mark.outside = 5.0F;
    for (const float part : kept(runtime, given)) EXPECT_EQ(part, 0.0F);
}

} // namespace
} // namespace hrbfnpr::testing::even_test
