// SPDX-License-Identifier: MIT
// Tests drawings as values: contents, memory, vertices.
#include "drawing_fixture.h"

namespace api_test::drawing_test {
namespace {

TEST_F(DrawingTest, OwnStrokesLieAtTheirGivenPlaces) {
    layers[1].shown = 0; // shows nothing else
    const Drawing drawing = drawn();
    const hrbfnpr_drawing_info info = info_of(drawing);
    EXPECT_EQ(info.strokes, 2);
    EXPECT_EQ(info.stroke_points, 2 * arc);
    const std::vector<std::uint8_t> pixels = rasterize(drawing, side);
    std::vector<bool> near(static_cast<std::size_t>(side * side));
    for (std::size_t i = 0; i < place.size(); i += 3) {
        const auto at = pixel(&place[i]);
        const std::size_t centre = static_cast<std::size_t>(at[1]) * side + static_cast<std::size_t>(at[0]);
        EXPECT_EQ(pixels[4 * centre], 255);
        EXPECT_LT(pixels[4 * centre + 1], 60) << "mark " << i / 3;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                if (std::hypot(x + 0.5 - at[0], y + 0.5 - at[1]) < 4.0)
                    near[static_cast<std::size_t>(side * y + x)] = true;
    }
    for (std::size_t i = 0; i < near.size(); ++i) ASSERT_TRUE(near[i] || pixels[4 * i + 1] == 255) << i;
}

TEST_F(DrawingTest, LayerInfosDescribeTheLayers) {
    const Drawing drawing = drawn();
    const hrbfnpr_drawing_info info = info_of(drawing);
    std::int64_t dots = 0;
    std::int64_t strokes = 0;
    bool arcs = false;
    for (std::int64_t number = 0; number < info.layers; ++number) {
        auto layer = made(hrbfnpr_drawing_layer_info_init);
        ASSERT_OK(hrbfnpr_drawing_get_layer_info(drawing.get(), number, &layer, error));
        dots += layer.dots;
        strokes += layer.strokes;
        EXPECT_EQ(layer.mark_class, static_cast<std::uint32_t>(HRBFNPR_CLASS_FRONT)) << "marks draw no contours";
        if (std::string(layer.name) != "arcs") continue;
        arcs = true;
        EXPECT_EQ(layer.layer, own);
        EXPECT_EQ(layer.kind, static_cast<std::uint32_t>(HRBFNPR_LAYER_KIND_OWN));
        EXPECT_EQ(layer.shape, static_cast<std::uint32_t>(HRBFNPR_SHAPE_STROKES));
        EXPECT_EQ(layer.strokes, 2);
        EXPECT_EQ(layer.ink[0], 1.0F);
    }
    EXPECT_TRUE(arcs);
    EXPECT_EQ(dots, info.dots);
    EXPECT_EQ(strokes, info.strokes);
}

// ---- memory --------------------------------------------------------------------------------

TEST(DrawingMemory, IsRecycledOnceTheDrawingIsReleased) {
    Allocator allocator;
    const Context context = make_context(allocator_desc(allocator));
    Sphere sphere;
    const PointSet set = generate(context, custom_sphere(context, sphere), small_desc());
    const Renderer renderer = make_renderer(context);
    const auto frame = [&] { return draw_item(renderer, item_of(set), front_camera(64)); };
    for (int warm = 0; warm < 4; ++warm) rasterize(frame(), 64);
    std::int64_t before = allocator.calls;
    for (int loop = 0; loop < 10; ++loop) rasterize(frame(), 64);
    EXPECT_EQ(allocator.calls, before) << "released before the next";
    // One drawing is shown while the next is made.
    Drawing shown = frame();
    for (int warm = 0; warm < 4; ++warm) shown = frame();
    before = allocator.calls;
    for (int loop = 0; loop < 10; ++loop) {
        Drawing next = frame();
        rasterize(shown, 64);
        shown = std::move(next);
    }
    EXPECT_EQ(allocator.calls, before) << "released before the next but one";
}

TEST(DrawingMemory, IsRecycledWithHatching) {
    Allocator allocator;
    const Context context = make_context(allocator_desc(allocator));
    Sphere sphere;
    hrbfnpr::test::Generation desc;
    std::int64_t count = 0;
    const hrbfnpr_layer_desc* const layers = hrbfnpr_preset_layers(HRBFNPR_PRESET_ETCHING, &count);
    for (std::int64_t i = 0; i < count; ++i) {
        desc.layer.push_back(layers[i]);
        desc.layer.back().budget = layers[i].kind == HRBFNPR_LAYER_KIND_HATCH ? 0 : 2000;
        if (layers[i].kind == HRBFNPR_LAYER_KIND_HATCH) desc.layer.back().separation = 0.1;
    }
    const PointSet set = generate(context, custom_sphere(context, sphere), desc);
    auto style = made(hrbfnpr_style_init);
    Error error;
    ASSERT_OK(hrbfnpr_style_init_preset(&style, sizeof style, HRBFNPR_PRESET_ETCHING, error));
    const Renderer renderer = make_renderer(context);
    auto item = item_of(set);
    item.style = &style;
    const auto orbit = [&] {
        std::int64_t strokes = 0;
        for (const double shift : {0.0, 0.1, 0.2, 0.3}) {
            item.transform[12] = shift;
            const Drawing drawing = draw_item(renderer, item, front_camera(128));
            rasterize(drawing, 128);
            strokes += info_of(drawing).strokes;
        }
        return strokes;
    };
    EXPECT_GT(orbit(), 100);
    orbit();
    const std::int64_t before = allocator.calls;
    for (int loop = 0; loop < 4; ++loop) orbit();
    EXPECT_EQ(allocator.calls, before);
}

TEST(DrawingMemory, IsNotReusedWhileADrawingIsHeld) {
    const Context context = make_context(1);
    Sphere sphere;
    const PointSet set = generate(context, custom_sphere(context, sphere), small_desc());
    const Renderer renderer = make_renderer(context);
    std::vector<Drawing> held;
    std::vector<std::vector<std::uint8_t>> pictures;
    for (int i = 0; i < 8; ++i) { // more than a renderer keeps
        auto item = item_of(set);
        item.transform[12] = 0.1 * i;
        held.push_back(draw_item(renderer, item, front_camera(64)));
        pictures.push_back(rasterize(held.back(), 64));
        for (int other = 0; other < i; ++other)
            EXPECT_NE(held.back().get(), held[static_cast<std::size_t>(other)].get());
    }
    for (std::size_t i = 0; i < held.size(); ++i) {
        EXPECT_EQ(rasterize(held[i], 64), pictures[i]);
        EXPECT_TRUE(i == 0 || pictures[i] != pictures[0]);
    }
}

// A renderer keeps several drawings to fill again, but these hold only the sets of the last drawing.
TEST(DrawingMemory, HoldsOnlyThePointSetsOfTheLastDrawing) {
    const Context context = make_context(1);
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const Renderer renderer = make_renderer(context);
    const auto draw_three = [&](const PointSet& set) { // held at the same time, so that the renderer keeps three
        std::vector<Drawing> held;
        for (int i = 0; i < 3; ++i) held.push_back(draw_item(renderer, item_of(set), front_camera(64)));
    };
    std::int64_t bytes = 0;
    {
        const PointSet set = generate(context, model, small_desc());
        draw_three(set);
        bytes = info_of(set).bytes;
    }
    const std::int64_t before = info_of(context).bytes_now;
    Error error;
    const hrbfnpr_camera camera = front_camera(64);
    hrbfnpr_drawing* nothing = nullptr;
    ASSERT_OK(hrbfnpr_renderer_draw(renderer.get(), nullptr, 0, 0, &camera, &nothing, error));
    const Drawing empty(nothing);
    EXPECT_LE(info_of(context).bytes_now, before - bytes);
}

// ---- vertices ------------------------------------------------------------------------------

} // namespace
} // namespace api_test::drawing_test
