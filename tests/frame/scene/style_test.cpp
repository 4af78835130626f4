// SPDX-License-Identifier: MIT
// Tests the named styles.
#include "support/named_style.h"

#include <gtest/gtest.h>

namespace hrbfnpr::frame::style_test {
namespace {

using marks::Kind;
using testing::NamedStyle;
using testing::preset_count;

constexpr Kind kinds[] = {Kind::stipples, Kind::hatch, Kind::own};

// The style of layers of a kind that have no name.
LayerStyle of(const NamedStyle& named, Kind kind) {
    base::Memory memory;
    return named.style.of(marks::Layer(memory, kind));
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

// Every layer of hatching that a style asks for is drawn as lines, by the layer style with its name.
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
