// SPDX-License-Identifier: MIT
// The named styles.
#include "support/named_style.h"

#include <gtest/gtest.h>

namespace hrbfnpr::frame::style_test {
namespace {

using marks::Kind;
using testing::NamedStyle;
using testing::preset_count;

constexpr Kind kinds[] = {Kind::stipples, Kind::hatch, Kind::own};

// How a style draws the layers of a kind that have no name.
LayerStyle of(const NamedStyle& named, Kind kind) {
    base::Memory memory;
    return named.style.of(marks::Layer(memory, kind));
}

// Kinds of layers for which a flag is set, among those that presets generate: bit 0 is stipples, bit 1 hatching.
unsigned kinds_with(bool LayerStyle::*flag, std::uint32_t preset) {
    const NamedStyle named(preset);
    unsigned bits = 0;
    for (unsigned bit = 0; bit < 2; ++bit) bits |= of(named, kinds[bit]).*flag ? 1U << bit : 0U;
    return bits;
}

TEST(Presets, HaveTheirNames) {
    for (std::uint32_t i = 0; i < preset_count; ++i) {
        EXPECT_EQ(testing::preset_names[i].preset, i);
        EXPECT_STREQ(hrbfnpr_preset_name(i), testing::preset_names[i].name);
    }
    EXPECT_EQ(hrbfnpr_preset_name(preset_count), nullptr);
    EXPECT_EQ(hrbfnpr_preset_name(0xFFFFFFFFU), nullptr);
}

TEST(Presets, AreValidStyles) {
    for (std::uint32_t i = 0; i < preset_count; ++i) {
        const NamedStyle named(i);
        const Style& s = named.style;
        EXPECT_GT(s.silhouette_threshold, 0.0);
        EXPECT_LT(s.silhouette_threshold, 1.0);
        EXPECT_GE(s.attenuation_front, 0.0);
        EXPECT_GE(s.attenuation_back, 0.0);
        EXPECT_GT(s.tone_exponent, 0.0);
        EXPECT_GT(s.silhouette_radius, 0.0F);
        EXPECT_EQ(s.paper.a, 1.0F);
        for (const Kind kind : kinds) {
            EXPECT_GT(of(named, kind).radius, 0.0F);
            EXPECT_GE(of(named, kind).share, 0.0F);
            EXPECT_LE(of(named, kind).share, 1.0F);
            EXPECT_EQ(of(named, kind).name, nullptr) << named.name;
            EXPECT_EQ(of(named, kind).directions, 3U) << named.name;
        }
    }
}

TEST(Presets, AreWhatTheirNamesSay) {
    const auto shown = [](std::uint32_t preset) { return kinds_with(&LayerStyle::shown, preset); };
    const auto contours = [](std::uint32_t preset) { return kinds_with(&LayerStyle::contours, preset); };
    EXPECT_EQ(shown(HRBFNPR_PRESET_STIPPLE), 3U); // layers of other kinds are drawn as they come
    EXPECT_EQ(contours(HRBFNPR_PRESET_STIPPLE), 0U);
    EXPECT_EQ(shown(HRBFNPR_PRESET_HATCH), 2U);
    EXPECT_EQ(shown(HRBFNPR_PRESET_CROSS_HATCH), 2U);
    EXPECT_EQ(shown(HRBFNPR_PRESET_COMBING), 2U);
    EXPECT_EQ(shown(HRBFNPR_PRESET_SILHOUETTE), 0U);
    EXPECT_NE(contours(HRBFNPR_PRESET_SILHOUETTE), 0U);
    EXPECT_EQ(shown(HRBFNPR_PRESET_CONTOUR_AND_STIPPLE), 1U);
    EXPECT_NE(contours(HRBFNPR_PRESET_CONTOUR_AND_STIPPLE), 0U);
    EXPECT_EQ(shown(HRBFNPR_PRESET_XRAY), 0U);
    EXPECT_EQ(NamedStyle(HRBFNPR_PRESET_XRAY).style.hidden_lines, HiddenLines::show);
    EXPECT_EQ(shown(HRBFNPR_PRESET_FULL), 3U);
    EXPECT_EQ(shown(HRBFNPR_PRESET_SCIENTIFIC_STIPPLE), 1U);
    EXPECT_EQ(shown(HRBFNPR_PRESET_BLUEPRINT), 0U);
    // Hatching alone, which widens with the tone; stipples tell where the surface is.
    for (const std::uint32_t preset : {HRBFNPR_PRESET_ENGRAVING, HRBFNPR_PRESET_ETCHING, HRBFNPR_PRESET_WOODCUT,
                                       HRBFNPR_PRESET_SKETCH, HRBFNPR_PRESET_ARCHAEOLOGICAL}) {
        EXPECT_EQ(shown(preset) & 1U, 0U);
        EXPECT_NE(contours(preset), 0U);
        EXPECT_EQ(NamedStyle(preset).style.hidden_lines, HiddenLines::hide);
    }
    EXPECT_EQ(NamedStyle(HRBFNPR_PRESET_STIPPLE).style.paper, glm::vec4(1.0F));
    EXPECT_NE(NamedStyle(HRBFNPR_PRESET_SKETCH).style.paper, glm::vec4(1.0F));
    EXPECT_NE(NamedStyle(HRBFNPR_PRESET_BLUEPRINT).style.paper, glm::vec4(1.0F));
}

// Every layer of hatching that a style asks for is drawn as lines, by the element that has its name.
TEST(Presets, DrawTheirHatching) {
    std::size_t sets = 0;
    for (std::uint32_t i = 0; i < preset_count; ++i) {
        const NamedStyle named(i);
        std::int64_t count = 0;
        const hrbfnpr_layer_desc* const layers = hrbfnpr_preset_layers(i, &count);
        for (const hrbfnpr_layer_desc& layer : std::span(layers, static_cast<std::size_t>(count))) {
            if (layer.kind != HRBFNPR_LAYER_KIND_HATCH) continue;
            ++sets;
            base::Memory memory;
            marks::Layer made(memory, Kind::hatch);
            if (layer.name != nullptr) std::strncpy(made.name.data(), layer.name, made.name.size() - 1);
            const LayerStyle& style = named.style.of(made);
            EXPECT_TRUE(style.shown) << named.name;
            EXPECT_EQ(style.shape, Shape::hatch) << named.name;
            EXPECT_EQ(style.name == nullptr, layer.name == nullptr) << named.name;
            EXPECT_LT(style.hatch_tone_begin, style.hatch_tone_end);
            EXPECT_LT(style.hatch_coverage_begin, style.hatch_coverage_end);
        }
    }
    EXPECT_GE(sets, 16U);
}

} // namespace
} // namespace hrbfnpr::frame::style_test
