// SPDX-License-Identifier: MIT
#include "fixture.h"

#include <array>
#include <cmath>

namespace api_test::renderer_test {
namespace {

class RendererTest : public testing::Test {
protected:
    RendererTest()
        : model(custom_sphere(context, sphere)), set(generate(context, model, small_desc())),
          renderer(make_renderer(context)) {}

    hrbfnpr_status draw_it(const hrbfnpr_style* style = nullptr, hrbfnpr_drawing_info* info = nullptr) {
        const hrbfnpr_status status = try_to_draw(renderer, item_of(set, style), front_camera(), drawing, error);
        if (info != nullptr && status == HRBFNPR_STATUS_OK) *info = info_of(drawing);
        return status;
    }

    Error error;
    Context context = make_context();
    Sphere sphere;
    Model model;
    PointSet set;
    Renderer renderer;
    Drawing drawing;
};

TEST_F(RendererTest, CountsTheDrawnMarks) {
    auto style = made(hrbfnpr_style_init);
    for (const std::uint32_t visibility : {HRBFNPR_VISIBILITY_DEPTH_LAYERS, HRBFNPR_VISIBILITY_PUBLISHED}) {
        style.visibility = visibility;
        auto info = made(hrbfnpr_drawing_info_init);
        EXPECT_OK(draw_it(&style, &info));
        EXPECT_EQ(info.marks, info.outside + info.front + info.back + info.silhouette + info.culled);
        EXPECT_EQ(info.culled > 0, visibility == HRBFNPR_VISIBILITY_DEPTH_LAYERS);
        EXPECT_EQ(info.silhouette > 0, visibility == HRBFNPR_VISIBILITY_PUBLISHED);
        EXPECT_GT(info.front, 0);
        EXPECT_GT(info.back, 0);
        EXPECT_GT(info.shown, 0);
        EXPECT_GT(info.splats, 0);
        EXPECT_GT(info.scratch_bytes, 0);
        EXPECT_GT(info.bytes, 0);
        EXPECT_GT(info.nanoseconds_classify, 0);
        EXPECT_EQ(info.items, 1);
        EXPECT_EQ(info.dots, info.shown);
        EXPECT_EQ(info.strokes, 0);
        EXPECT_EQ(info.stroke_points, 0);
        std::int64_t vertices = 0;
        std::int64_t indices = 0;
        EXPECT_OK(hrbfnpr_drawing_vertex_bound(drawing.get(), HRBFNPR_PRIMITIVE_POINTS, &vertices, &indices, error));
        EXPECT_EQ(vertices, visibility == HRBFNPR_VISIBILITY_PUBLISHED ? info.shown + info.splats : info.shown);
        EXPECT_EQ(indices, vertices);
        std::int64_t dots = 0;
        for (std::int64_t number = 0; number < info.layers; ++number) {
            auto layer = made(hrbfnpr_drawing_layer_info_init);
            EXPECT_OK(hrbfnpr_drawing_get_layer_info(drawing.get(), number, &layer, error));
            EXPECT_EQ(layer.item, 0);
            EXPECT_STREQ(layer.name, layer_info(set, layer.layer).name);
            EXPECT_EQ(layer.kind, layer_info(set, layer.layer).kind);
            EXPECT_TRUE(layer.mark_class == HRBFNPR_CLASS_FRONT || layer.mark_class == HRBFNPR_CLASS_SILHOUETTE);
            EXPECT_EQ(layer.ink[3], 1.0F);
            dots += layer.dots;
        }
        EXPECT_EQ(dots, info.dots);
    }
}

// Two items go round, drawn as dots and as strokes, and are read as pixels and as vertices.
TEST_F(RendererTest, AllocatesNothingOnceItIsWarm) {
    Allocator allocator;
    const Context counted = make_context(allocator_desc(allocator));
    const PointSet marks = generate(counted, custom_sphere(counted, sphere), small_desc());
    auto layer = made(hrbfnpr_layer_style_init);
    auto style = made(hrbfnpr_style_init);
    style.layers = &layer;
    style.layer_count = 1;
    auto red = style;
    red.silhouette_ink[0] = 1.0F;
    std::array items{item_of(marks, &style), item_of(marks, &red)};
    std::vector<std::uint8_t> pixels;
    const hrbfnpr_image image = image_of(pixels, 64);
    std::vector<float> host(64 * 64, 0.6F), vertices(std::size_t{3} << 20);
    std::vector<std::uint32_t> indices(std::size_t{1} << 20);
    auto raster = made(hrbfnpr_raster_desc_init);
    raster.host_depth = in(host, 1);
    Layout layout(HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS);
    layout.add(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, 0);
    for (const std::uint32_t shape : {HRBFNPR_SHAPE_DOTS, HRBFNPR_SHAPE_STROKES})
        for (const std::uint32_t hidden :
             {HRBFNPR_HIDDEN_LINES_SHOW, HRBFNPR_HIDDEN_LINES_HIDE, HRBFNPR_HIDDEN_LINES_ATTENUATE}) {
            layer.shape = shape;
            style.hidden_lines = red.hidden_lines = hidden;
            const Renderer warm = make_renderer(counted);
            const auto round = [&] {
                for (int step = 0; step < 6; ++step) {
                    for (hrbfnpr_item& item : items) {
                        item.transform[0] = item.transform[10] = std::cos(step);
                        item.transform[8] = -(item.transform[2] = -std::sin(step));
                    }
                    items[1].transform[12] = 0.7 * std::cos(step);
                    const hrbfnpr_camera camera = front_camera();
                    hrbfnpr_drawing* drawn = nullptr;
                    ASSERT_OK(hrbfnpr_renderer_draw(warm.get(), items.data(), 2, 0, &camera, &drawn, error));
                    const Drawing owned(drawn);
                    EXPECT_OK(hrbfnpr_drawing_rasterize(drawn, &image, &raster, error));
                    EXPECT_OK(hrbfnpr_drawing_write_vertices(drawn, layout.get(), vertices.data(), 1 << 20, nullptr,
                                                             indices.data(), 1 << 20, nullptr, error));
                }
            };
            round();
            const std::int64_t before = allocator.calls;
            round();
            EXPECT_EQ(allocator.calls, before) << shape << " " << hidden;
        }
}

TEST_F(RendererTest, DrawsSeveralItems) {
    auto info = made(hrbfnpr_drawing_info_init);
    EXPECT_OK(draw_it(nullptr, &info));
    const std::int64_t marks = info.marks;
    // The items come from a newer caller, whose struct has a tail.
    struct Newer {
        hrbfnpr_item item;
        std::uint64_t tail[2];
    } items[2];
    for (Newer& newer : items) {
        EXPECT_OK(hrbfnpr_item_init(&newer.item, sizeof newer));
        newer.item.point_set = set.get();
    }
    items[1].item.transform[12] = 0.5;
    const hrbfnpr_camera camera = front_camera();
    const auto draw_all = [&](const hrbfnpr_item* first, std::int64_t count, std::int64_t stride) {
        hrbfnpr_drawing* made_drawing = nullptr;
        EXPECT_OK(hrbfnpr_renderer_draw(renderer.get(), first, count, stride, &camera, &made_drawing, error));
        drawing.reset(made_drawing);
        return info_of(drawing);
    };
    EXPECT_EQ(draw_all(&items[0].item, 2, 0).marks, 2 * marks);
    EXPECT_EQ(draw_all(&items[0].item, 2, sizeof(Newer)).marks, 2 * marks);
    EXPECT_EQ(draw_all(&items[0].item, 2, sizeof(Newer)).items, 2);
    EXPECT_EQ(draw_all(nullptr, 0, 0).marks, 0);
    std::vector<std::uint8_t> pixels;
    const hrbfnpr_image image = image_of(pixels, 8);
    EXPECT_OK(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, error));
    EXPECT_EQ(pixels, std::vector<std::uint8_t>(256, 255)); // blank paper
}

TEST_F(RendererTest, ADrawingKeepsItsPointSet) {
    EXPECT_OK(draw_it());
    const auto before = rasterize(drawing, 64);
    set.reset();
    renderer.reset();
    model.reset();
    std::vector<std::uint8_t> pixels;
    const hrbfnpr_image image = image_of(pixels, 64);
    EXPECT_OK(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, error));
    EXPECT_EQ(pixels, before);
}

TEST_F(RendererTest, CallsTheToneFunctionOnTheCallersThread) {
    struct Tone {
        std::int64_t marks = 0;
        std::int32_t result = 0;
        float tau = 0.0F;
        static std::int32_t call(void* user, std::int64_t count, const float* positions, const float* normals,
                                 float* tau) {
            auto& self = *static_cast<Tone*>(user);
            self.marks += count;
            for (std::int64_t i = 0; i < 3 * count; ++i) EXPECT_NEAR(positions[i], normals[i], 1e-3F);
            std::fill(tau, tau + count, self.tau);
            return self.result;
        }
    } tone;
    Generation desc = small_desc();
    for (hrbfnpr_layer_desc& layer : desc.layer) layer.tone_smoothing = 0.0; // the tone uses NORMAL
    set = generate(context, model, desc);
    auto style = made(hrbfnpr_style_init);
    style.tone = HRBFNPR_TONE_CALLBACK;
    style.tone_function = Tone::call;
    style.tone_user = &tone;
    auto info = made(hrbfnpr_drawing_info_init);
    style.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
    EXPECT_OK(draw_it(&style, &info));
    EXPECT_EQ(tone.marks, info.front);
    EXPECT_EQ(info.dropped_tone, 0); // all marks are dark
    tone.tau = 1.0F;
    EXPECT_OK(draw_it(&style, &info));
    EXPECT_EQ(info.dropped_tone, info.front);
    style.visibility = HRBFNPR_VISIBILITY_DEPTH_LAYERS;
    style.tone_curve = HRBFNPR_TONE_CURVE_LINEAR;
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    tone.marks = 0;
    tone.tau = 0.0F;
    EXPECT_OK(draw_it(&style, &info));
    EXPECT_EQ(tone.marks, info.front);
    EXPECT_EQ(info.silhouette, 0);
    EXPECT_EQ(info.dropped_tone, 0);
    EXPECT_EQ(info.dropped_hidden, 0);
    EXPECT_EQ(info.shown, info.front);
    tone.tau = 1.0F;
    EXPECT_OK(draw_it(&style, &info));
    EXPECT_EQ(info.dropped_tone, info.front);
    EXPECT_EQ(info.shown, 0);
    tone.result = 3;
    EXPECT_FAILS(draw_it(&style), HRBFNPR_STATUS_CALLBACK, "tone_function returned 3");
    tone.result = 0;
    tone.tau = NAN;
    EXPECT_FAILS(draw_it(&style), HRBFNPR_STATUS_CALLBACK, "tone_function");
}

} // namespace
} // namespace api_test::renderer_test
