// SPDX-License-Identifier: MIT
// Tests layers that share the tones.
#include "support/point_sets.h"

#include <array>

namespace hrbfnpr::generate::layers_test {
namespace {

using namespace marks;
using namespace test;

TEST(Layers, AppearOneAfterAnother) {
    for (const Distribution distribution : {Distribution::blue_noise, Distribution::published}) {
        generate::Settings settings = blue({Kind::stipples, Kind::hatch}, 3000);
        settings.distribution = distribution;
        of(settings, Kind::stipples).part[0] = {0.0, 0.3};
        of(settings, Kind::hatch).part = {TonePart{0.3, 0.6}, TonePart{0.6, 1.0}};
        const PointSet set = make(Torus(), settings);
        const Layer& stipples = of(set, Kind::stipples);
        for (const float rank : stipples.rank) EXPECT_GE(rank, 0.7F - 1e-6F);
        const Layer& strokes = of(set, Kind::hatch);
        std::array<int, 2> seen{};
        for (std::int64_t i = 0; i < strokes.count(); ++i) {
            const std::uint32_t which = strokes.stroke[2 * i] & 1U;
            ++seen[which];
            EXPECT_GE(strokes.rank[i], which == 0 ? 0.4F - 1e-6F : 0.0F);
            EXPECT_LE(strokes.rank[i], which == 0 ? 0.7F + 1e-6F : 0.4F + 1e-6F);
        }
        EXPECT_GT(seen[0], 500);
        if (distribution == Distribution::published)
            EXPECT_GT(seen[1], 500);
        else
            EXPECT_EQ(seen[1], 0) << "lines of hatching have one direction";
    }
}

// The layers have 5 directions, and all directions get equally many tones.
TEST(Layers, ShareTheTonesAndTheBudget) {
    Settings settings;
    settings.distribution = Distribution::published;
    settings.layers.resize(3);
    settings.layers[1].kind = settings.layers[2].kind = Kind::hatch;
    settings.tone_ranges = ToneRanges::in_turn;
    settings.shared_budget = 5000;
    settings = completed(settings);
    EXPECT_NEAR(static_cast<double>(settings.layers[0].budget), 1000.0, 1.0);
    EXPECT_NEAR(static_cast<double>(settings.layers[1].budget), 2000.0, 1.0);
    EXPECT_NEAR(static_cast<double>(settings.layers[2].budget), 2000.0, 1.0);
    EXPECT_DOUBLE_EQ(settings.layers[0].part[0].end, 0.2);
    EXPECT_DOUBLE_EQ(settings.layers[1].part[0].begin, 0.2);
    EXPECT_DOUBLE_EQ(settings.layers[1].part[1].begin, 0.4);
    EXPECT_DOUBLE_EQ(settings.layers[2].part[1].end, 1.0);
    EXPECT_STREQ(settings.layers[2].name.data(), "hatch");
    // A layer that sets its part itself keeps it, and still takes its turn.
    Settings own;
    own.distribution = Distribution::published;
    for (const Kind kind : {Kind::stipples, Kind::hatch}) of(own, kind);
    own.tone_ranges = ToneRanges::in_turn;
    of(own, Kind::hatch).part[0] = {0.0, 0.5};
    own = completed(own);
    EXPECT_EQ(own.layers[1].part[0].end, 0.5);
    EXPECT_DOUBLE_EQ(own.layers[1].part[1].begin, 2.0 / 3.0);
    EXPECT_EQ(own.layers[1].budget, 40000);
}

// Lines of hatching run in one direction, and this direction gets all tones of the layer.
TEST(Layers, AHatchingLayerGetsOneToneRange) {
    Settings settings;
    settings.layers.resize(4);
    for (std::size_t i = 1; i < 4; ++i) settings.layers[i].kind = Kind::hatch;
    settings.tone_ranges = ToneRanges::in_turn;
    settings.shared_budget = 4000;
    settings = completed(settings);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(settings.layers[i].budget, 1000) << i;
        EXPECT_DOUBLE_EQ(settings.layers[i].part[0].begin, 0.25 * static_cast<double>(i));
        EXPECT_DOUBLE_EQ(settings.layers[i].part[0].end, 0.25 * static_cast<double>(i + 1));
    }
}

// The length over which normals are averaged for the tone depends on the kind of the layer.
TEST(Layers, TonesOfLinesAreSmoothedByDefault) {
    Settings settings = blue({Kind::stipples, Kind::hatch}, 100);
    EXPECT_EQ(completed(settings).layers[0].tone_smoothing, 0.0);
    EXPECT_EQ(completed(settings).layers[1].tone_smoothing, 0.006);
    for (LayerSettings& layer : settings.layers) layer.tone_smoothing = 0.01;
    for (const LayerSettings& layer : completed(settings).layers) EXPECT_EQ(layer.tone_smoothing, 0.01);
    for (const LayerSettings& layer : completed(recursion({Kind::stipples, Kind::hatch}, 1)).layers)
        EXPECT_EQ(layer.tone_smoothing, 0.0);
}

// Each layer is distributed by its own density, and independently of the other.
TEST(Layers, TwoOfOneKindHaveIndependentMarks) {
    const Sphere sphere;
    Settings settings = blue({Kind::stipples}, 3000);
    const PointSet one = make(sphere, settings);
    LayerSettings& north = settings.layers.emplace_back();
    north.budget = 2000;
    north.name = {'n', 'o', 'r', 't', 'h'};
    north.density.kind = stipples::Density::callback;
    north.density.function = [](void*, std::int64_t count, const double* p, const double*, double* density) {
        for (std::int64_t i = 0; i < count; ++i) density[i] = p[3 * i + 2] > 0.0 ? 1.0 : 0.0;
        return std::int32_t{0};
    };
    const PointSet two = make(sphere, settings);
    expect_sound(two, sphere);
    ASSERT_EQ(two.layers.size(), 2);
    EXPECT_TRUE(same_bits(one.layers[0].normal, two.layers[0].normal)) << "positions have another origin";
    EXPECT_TRUE(same_bits(one.layers[0].rank, two.layers[0].rank));
    EXPECT_STREQ(two.layers[1].name.data(), "north");
    ASSERT_EQ(two.layers[1].count(), 2000);
    for (std::int64_t i = 0; i < 2000; ++i) ASSERT_GT(position(two, two.layers[1], i).z, -1e-6);
    // With the same settings the marks still differ.
    settings.layers[1] = settings.layers[0];
    for (const Distribution distribution : {Distribution::blue_noise, Distribution::published}) {
        settings.distribution = distribution;
        const PointSet same = make(sphere, settings);
        ASSERT_GT(same.layers[1].count(), 1000);
        EXPECT_FALSE(same_bits(same.layers[0].normal, same.layers[1].normal));
        settings.layers.pop_back();
        EXPECT_TRUE(same_bits(make(sphere, settings).layers[0].normal, same.layers[0].normal));
        settings.layers.push_back(settings.layers[0]);
    }
}

// Each layer has the same lines as it has alone.
TEST(Layers, HatchingLayersMayDifferInAllSettings) {
    const Torus torus;
    Settings settings = blue({principal}, 6000);
    settings.layers.push_back(settings.layers[0]);
    LayerSettings& other = settings.layers[1];
    other.hatching.separation = 0.2;
    other.hatching.step = 0.03;
    other.hatching.angle = 0.5;
    other.hatching.field.guide = hatching::Guide::sections;
    other.hatching.field.smoothing = 0.1;
    const PointSet set = make(torus, settings);
    expect_sound(set, torus);
    EXPECT_NEAR(set.layers[1].report.step, 0.2, 1e-12);
    EXPECT_GT(set.layers[0].report.step, 0.0);
    const PointSet one = make(torus, blue({principal}, 6000));
    EXPECT_TRUE(same_bits(one.layers[0].normal, set.layers[0].normal)) << "positions have another origin";
    EXPECT_TRUE(same_bits(one.layers[0].rank, set.layers[0].rank));
}

} // namespace
} // namespace hrbfnpr::generate::layers_test
