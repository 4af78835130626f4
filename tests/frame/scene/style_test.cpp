// SPDX-License-Identifier: MIT
// The named styles.
#include "frame/scene/style.h"

#include <gtest/gtest.h>

namespace hrbfnpr::frame::style_test {
namespace {

using marks::Kind;

constexpr Kind kinds[] = {Kind::stipples, Kind::principal, Kind::combing, Kind::field, Kind::own};

// What a preset says of the layers of a kind.
const LayerStyle& of(const Preset& preset, Kind kind) {
    static base::Memory memory;
    return preset.style.of(marks::Layer(memory, kind));
}

TEST(Presets, HaveTheirNames) {
    const char* const names[] = {
        "stipple", "hatch",     "cross-hatch",   "combing", "silhouette", "contour-and-stipple",
        "xray",    "full",      "engraving",     "etching", "woodcut",    "scientific-stipple",
        "sketch",  "blueprint", "archaeological"};
    for (std::uint32_t i = 0; i < preset_count; ++i) {
        EXPECT_STREQ(preset_name(i), names[i]);
        EXPECT_STREQ(preset(i).name, names[i]);
    }
    EXPECT_EQ(preset_name(preset_count), nullptr);
    EXPECT_EQ(preset_name(0xFFFFFFFFU), nullptr);
}

TEST(Presets, AreValidStyles) {
    for (std::uint32_t i = 0; i < preset_count; ++i) {
        const Preset p = preset(i);
        const Style& s = p.style;
        EXPECT_GT(s.silhouette_threshold, 0.0);
        EXPECT_LT(s.silhouette_threshold, 1.0);
        EXPECT_GE(s.attenuation_front, 0.0);
        EXPECT_GE(s.attenuation_back, 0.0);
        EXPECT_GT(s.tone_exponent, 0.0);
        EXPECT_GT(s.silhouette_radius, 0.0F);
        const bool has_paper_of_its_own = i == 12 || i == 13; // sketch and blueprint
        EXPECT_EQ(s.paper == glm::vec4(1.0F), !has_paper_of_its_own) << "styles of one frame need the same paper";
        EXPECT_EQ(s.paper.a, 1.0F);
        for (const Kind kind : kinds) {
            EXPECT_GT(of(p, kind).radius, 0.0F);
            EXPECT_GE(of(p, kind).share, 0.0F);
            EXPECT_LE(of(p, kind).share, 1.0F);
            EXPECT_EQ(of(p, kind).name, nullptr) << p.name;
        }
    }
}

TEST(Presets, AreWhatTheirNamesSay) {
    const auto shown = [](std::uint32_t i) {
        unsigned bits = 0;
        for (std::size_t g = 0; g < 3; ++g) bits |= of(preset(i), kinds[g]).shown ? 1U << g : 0U;
        return bits;
    };
    const auto contours = [](std::uint32_t i) {
        unsigned bits = 0;
        for (std::size_t g = 0; g < 3; ++g) bits |= of(preset(i), kinds[g]).contours ? 1U << g : 0U;
        return bits;
    };
    EXPECT_EQ(shown(0), 1U);
    EXPECT_EQ(contours(0), 0U);
    EXPECT_EQ(shown(1), 2U);
    EXPECT_EQ(of(preset(1), Kind::principal).directions, 2U);
    EXPECT_EQ(shown(2), 2U);
    EXPECT_EQ(of(preset(2), Kind::principal).directions, 3U);
    EXPECT_EQ(shown(3), 4U);
    EXPECT_EQ(shown(4), 0U);
    EXPECT_EQ(shown(5), 1U);
    EXPECT_EQ(shown(6), 0U);
    EXPECT_EQ(preset(6).style.hidden_lines, HiddenLines::show);
    EXPECT_EQ(shown(7), 3U);
    EXPECT_EQ(shown(11), 1U);
    EXPECT_EQ(shown(13), 0U);
    // Hatching alone, which widens with the tone; stipples tell where the surface is.
    for (const std::uint32_t i : {8U, 9U, 10U, 12U, 14U}) {
        EXPECT_EQ(shown(i), 0U);
        EXPECT_EQ(preset(i).style.hidden_lines, HiddenLines::hide);
    }
    constexpr std::size_t sets_of[preset_count] = {0, 1, 4, 3, 0, 0, 0, 3, 1, 3, 1, 0, 3, 0, 1};
    for (std::uint32_t i = 0; i < preset_count; ++i) {
        const Preset p = preset(i);
        std::size_t sets = 0;
        for (const LayerStyle& layer : p.style.layers) {
            if (layer.kind != Kind::hatch) continue;
            ++sets;
            EXPECT_EQ(layer.shape, Shape::hatch);
            EXPECT_TRUE(layer.shown);
            EXPECT_LT(layer.hatch_tone_begin, layer.hatch_tone_end);
            EXPECT_LT(layer.hatch_coverage_begin, layer.hatch_coverage_end);
        }
        EXPECT_EQ(sets, sets_of[i]) << p.name;
    }
    for (std::uint32_t i = 1; i < preset_count; ++i) EXPECT_NE(contours(i), 0U);
}

} // namespace
} // namespace hrbfnpr::frame::style_test
