// SPDX-License-Identifier: MIT
// Layers drawn as hatching: their fields, and what a drawing tells of their marks.
#include "drawing_fixture.h"

#include <limits>

namespace api_test::hatching_test {
namespace {

using HatchingTest = DrawingTest;

TEST_F(HatchingTest, FieldsAreChecked) {
    using Layer = hrbfnpr_layer_style;
    constexpr float nanf = std::numeric_limits<float>::quiet_NaN();
    struct Row {
        void (*change)(Layer& l);
        const char* message;
    };
    const std::vector<Row> rows = {
        {[](Layer& l) { l.hatch_tone_begin = -0.1F; }, "items[0].style.layers[0].hatch_tone_begin is -0.1"},
        {[](Layer& l) { l.hatch_tone_end = 1.5F; }, "items[0].style.layers[0].hatch_tone_end is 1.5"},
        {[](Layer& l) { l.hatch_tone_begin = 0.95F; },
         "items[0].style.layers[0].hatch_tone_begin is 0.95 and hatch_tone_end is 0.95"},
        {[](Layer& l) { l.hatch_coverage_begin = 0; }, "items[0].style.layers[0].hatch_coverage_begin is 0"},
        {[](Layer& l) { l.hatch_coverage_end = 1.1F; }, "items[0].style.layers[0].hatch_coverage_end is 1.1"},
        {[](Layer& l) { l.hatch_spacing = 0; }, "items[0].style.layers[0].hatch_spacing is 0"},
        {[](Layer& l) { l.hatch_pen = nanf; }, "items[0].style.layers[0].hatch_pen is nan"},
        {[](Layer& l) { l.hatch_white = -1; }, "items[0].style.layers[0].hatch_white is -1"},
        {[](Layer& l) { l.hatch_taper = 1e9F; }, "items[0].style.layers[0].hatch_taper is 1e+09"},
        {[](Layer& l) { l.hatch_shortest = -1; }, "items[0].style.layers[0].hatch_shortest is -1"},
        {[](Layer& l) { l.reserved2 = 7; }, "items[0].style.layers[0].reserved2 is 7"},
        {[](Layer& l) { l.hatch_wobble = 17; }, "items[0].style.layers[0].hatch_wobble is 17"},
        {[](Layer& l) { l.hatch_overshoot = -1; }, "items[0].style.layers[0].hatch_overshoot is -1"},
        {[](Layer& l) { l.reserved3 = 7; }, "items[0].style.layers[0].reserved3 is 7"}};
    const Layer good = layers[0];
    const hrbfnpr_item item = item_of(set, &style);
    const hrbfnpr_camera camera = front_camera(side);
    const auto draw = [&] {
        hrbfnpr_drawing* drawing = nullptr;
        const hrbfnpr_status status = hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &camera, &drawing, error);
        hrbfnpr_drawing_release(drawing);
        return status;
    };
    for (const std::uint32_t shape : {HRBFNPR_SHAPE_DOTS, HRBFNPR_SHAPE_HATCH}) {
        for (const Row& row : rows) {
            layers[0] = good;
            layers[0].shape = shape;
            row.change(layers[0]);
            EXPECT_FAILS(draw(), HRBFNPR_STATUS_INVALID_ARGUMENT, row.message);
        }
    }
    layers[0] = good;
    layers[0].shape = HRBFNPR_SHAPE_HATCH;
    layers[0].hatch_tone_begin = layers[0].hatch_white = layers[0].hatch_taper = layers[0].hatch_shortest = 0.0F;
    layers[0].hatch_tone_end = layers[0].hatch_coverage_begin = layers[0].hatch_coverage_end = 1.0F;
    EXPECT_OK(draw());
}

TEST_F(HatchingTest, TheFillLightIsChecked) {
    const hrbfnpr_style good = style;
    const hrbfnpr_item item = item_of(set, &style);
    const hrbfnpr_camera camera = front_camera(side);
    const auto expect = [&](float fill, std::uint32_t reserved, const char* message) {
        style = good;
        style.fill_light = fill;
        style.reserved2 = reserved;
        hrbfnpr_drawing* drawing = nullptr;
        EXPECT_FAILS(hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &camera, &drawing, error),
                     HRBFNPR_STATUS_INVALID_ARGUMENT, message);
    };
    expect(1.5F, 0, "items[0].style.fill_light is 1.5; it must be from 0 to 1");
    expect(std::numeric_limits<float>::quiet_NaN(), 0, "items[0].style.fill_light is nan");
    expect(0.25F, 1, "items[0].style.reserved2 is 1");
}

// Points between marks have the id of the nearest.
TEST_F(HatchingTest, MarkResultsAreThoseOfItsLines) {
    style.tone = HRBFNPR_TONE_NONE;
    layers[0].shape = layers[1].shape = HRBFNPR_SHAPE_HATCH;
    const Drawing drawing = drawn();
    std::map<std::uint32_t, float> radius; // of each id that is a point's
    for (const Vertex& v : vertices_of(drawing, HRBFNPR_PRIMITIVE_POINTS).vertex) radius[v.id] = v.radius;
    for (const Vertex& v : vertices_of(drawing, HRBFNPR_PRIMITIVE_LINE_STRIPS).vertex)
        radius[v.id] = std::max(radius[v.id], v.radius);
    std::uint32_t next_id = 1;
    bool any = false;
    for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer) {
        auto described = made(hrbfnpr_drawing_layer_info_init);
        EXPECT_OK(hrbfnpr_drawing_get_layer_info(drawing.get(), layer, &described, error));
        any = any || (described.shape == HRBFNPR_SHAPE_HATCH && described.strokes > 0);
        const Results results = results_of(drawing, set, layer);
        std::int64_t shown = 0;
        for (std::size_t i = 0; i < results.shown.size(); ++i) {
            const auto found = radius.find(next_id + static_cast<std::uint32_t>(i));
            EXPECT_EQ(results.shown[i] != HRBFNPR_CLASS_NONE, found != radius.end()) << i;
            if (found == radius.end()) continue;
            EXPECT_LE(results.radius[i], found->second);
            shown += results.shown[i] == HRBFNPR_CLASS_FRONT ? 1 : 0;
        }
        const auto points = indices_of(drawing, layer, HRBFNPR_CLASS_FRONT, HRBFNPR_PRIMITIVE_POINTS);
        EXPECT_EQ(static_cast<std::int64_t>(points.size()), shown) << "each mark once";
        next_id += static_cast<std::uint32_t>(results.shown.size());
    }
    EXPECT_TRUE(any);
}

} // namespace
} // namespace api_test::hatching_test
