// SPDX-License-Identifier: MIT
// Tests every named style on a sphere and a torus.
#include "raster/picture.h"
#include "support/named_style.h"

#include <gtest/gtest.h>

namespace hrbfnpr::testing::presets_test {
namespace {

class Presets : public ::testing::TestWithParam<std::uint32_t> {
protected:
    base::Runtime runtime;
};

TEST_P(Presets, DrawATorus) {
    marks::PointSet set = torus(runtime.memory, 120);
    add_torus_strokes(set, marks::Kind::hatch, 1500, 27, 0.3);
    const NamedStyle preset(GetParam());
    const frame::Camera camera = frame::fit_bounds(set.bounds, {0.2, 0.75, -0.6}, {0.0, 0.0, 1.0}, 0.6, 900, 700, 0.05,
                                                   drawing::DepthConvention::negative_one_to_one);
    const std::array items{item_of(set, preset.style)};
    drawing::Counts info;
    const Picture picture = picture_of(runtime, items, camera, 900, 700, &info);
    picture.keep(std::string("torus-") + preset.name);
    EXPECT_GT(info.shown, 1000);
}

TEST_P(Presets, DrawASphere) {
    const marks::PointSet set = sphere(runtime.memory, 30000);
    NamedStyle preset(GetParam());
    preset.style.paper = glm::vec4(1.0F);
    preset.style.silhouette_ink = {0.0F, 0.0F, 0.0F, 1.0F};
    const std::array items{item_of(set, preset.style)};
    const Picture picture = picture_of(runtime, items, front_camera(600, 600), 600, 600);
    picture.keep(std::string("sphere-") + preset.name);
    // The sphere's radius is 240 pixels. The light comes from the upper left.
    const double light = picture.darkness(150, 150, 300, 300);
    const double dark = picture.darkness(300, 300, 450, 450);
    const frame::LayerStyle& stipples = preset.style.of(set.layers[0]);
    if (stipples.shown) {
        EXPECT_GT(dark, 3.0 * light);
        EXPECT_GT(light, 0.0);
    } else {
        EXPECT_EQ(dark + light, 0.0);
    }
    double rim = 0.0;
    for (int i = 0; i < 360; ++i) {
        const double angle = pi * i / 180.0;
        const int x = static_cast<int>(300.0 + 238.0 * std::cos(angle));
        const int y = static_cast<int>(300.0 + 238.0 * std::sin(angle));
        rim += (1.0 - picture.at(x, y, 0) / 255.0) / 360.0;
    }
    if (stipples.contours)
        EXPECT_GT(rim, stipples.radius < 1.0F ? 0.85 : 0.97); // lower for finer pens
    else
        EXPECT_LT(rim, 0.85); // without a contour, the tone law leaves 1 - 0.72/pi = 0.77 of the rim dark
}

INSTANTIATE_TEST_SUITE_P(All, Presets, ::testing::Range(0U, preset_count),
                         [](const auto& one) { return "number_" + std::to_string(one.param); });

} // namespace
} // namespace hrbfnpr::testing::presets_test
