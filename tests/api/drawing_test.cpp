// SPDX-License-Identifier: MIT
// Drawings as values: what they hold, memory, vertices.
#include "drawing_fixture.h"

namespace api_test::drawing_test {
namespace {

TEST_F(DrawingTest, OwnStrokesAreWhereTheyShouldBe) {
    layers[1].shown = 0; // nothing else
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

TEST_F(DrawingTest, ItsLayersSayWhatTheyAre) {
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

TEST(DrawingMemory, IsRecycledWhenNobodyHoldsIt) {
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
    // One is shown while the next is made.
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

TEST(DrawingMemory, IsLeftAloneWhileItIsHeld) {
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

// However many drawings a renderer keeps to fill again, they keep the sets of the last one alone.
TEST(DrawingMemory, KeepsTheSetsOfTheLastDrawingAlone) {
    const Context context = make_context(1);
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const Renderer renderer = make_renderer(context);
    const auto draw_three = [&](const PointSet& set) { // at a time, so that the renderer keeps three
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

// "Source over" of round anti-aliased points, as a host does it.
std::vector<double> painted(const std::vector<Vertex>& points) {
    std::vector<double> value(static_cast<std::size_t>(side * side), 1.0);
    for (const Vertex& v : points)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double distance = std::hypot(x + 0.5 - double{v.window[0]}, y + 0.5 - double{v.window[1]});
                // Dots of less than half a pixel are not drawn smaller, but paler.
                const double radius = std::max(double{v.radius}, 0.5);
                const double coverage = std::clamp(radius + 0.5 - distance, 0.0, 1.0) *
                                        std::pow(std::min(double{v.radius} / radius, 1.0), 2.0);
                double& at = value[static_cast<std::size_t>(side * y + x)];
                at += coverage * double{v.color[3]} * (double{v.color[0]} - at);
            }
    return value;
}

TEST_F(DrawingTest, PointsPaintedFarToNearAreTheImage) {
    for (const std::uint32_t visibility : {HRBFNPR_VISIBILITY_DEPTH_LAYERS, HRBFNPR_VISIBILITY_PUBLISHED}) {
        SCOPED_TRACE(visibility);
        layers[0].shape = layers[1].shape = HRBFNPR_SHAPE_DOTS;
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_ATTENUATE;
        style.visibility = visibility;
        const Drawing drawing = drawn();
        const Vertices points = vertices_of(drawing, HRBFNPR_PRIMITIVE_POINTS);
        ASSERT_GT(points.vertex.size(), 100U);
        for (std::size_t i = 0; i < points.index.size(); ++i) ASSERT_EQ(points.index[i], i);
        float last = 1.0F;
        for (const Vertex& v : points.vertex)
            if (visibility == HRBFNPR_VISIBILITY_DEPTH_LAYERS) {
                ASSERT_EQ(v.mark_class, static_cast<std::uint32_t>(HRBFNPR_CLASS_FRONT)) << "no marks draw contours";
                ASSERT_GE(last + 1e-5F, v.window[2]);
                last = v.window[2];
            }
        const std::vector<double> mine = painted(points.vertex);
        const std::vector<std::uint8_t> theirs = rasterize(drawing, side);
        double worst = 0.0;
        double sum = 0.0;
        for (std::size_t i = 0; i < mine.size(); ++i) {
            const double difference = std::abs(255.0 * mine[i] - theirs[4 * i]);
            worst = std::max(worst, difference);
            sum += difference;
        }
        EXPECT_LT(worst, 3.0);
        EXPECT_LT(sum / static_cast<double>(mine.size()), 0.5);
    }
}

TEST_F(DrawingTest, LineStripsStayWithinTheirStroke) {
    const Drawing drawing = drawn();
    const hrbfnpr_drawing_info info = info_of(drawing);
    const Vertices lines = vertices_of(drawing, HRBFNPR_PRIMITIVE_LINE_STRIPS);
    EXPECT_EQ(static_cast<std::int64_t>(lines.vertex.size()), info.stroke_points);
    const auto strips = strips_of(lines.index);
    EXPECT_EQ(static_cast<std::int64_t>(strips.size()), info.strokes);
    ASSERT_GT(strips.size(), 4U);
    std::vector<bool> used(lines.vertex.size());
    for (const auto& strip : strips) {
        ASSERT_GE(strip.size(), 2U);
        const hrbfnpr_mark_identity begin = identity_of(drawing, lines.vertex[strip[0]].id);
        EXPECT_GE(begin.stroke, 0);
        EXPECT_EQ(lines.vertex[strip[0]].length, 0.0F);
        for (std::size_t i = 0; i < strip.size(); ++i) {
            const Vertex& v = lines.vertex[strip[i]];
            EXPECT_FALSE(used[strip[i]]);
            used[strip[i]] = true;
            const hrbfnpr_mark_identity identity = identity_of(drawing, v.id);
            EXPECT_EQ(identity.layer, begin.layer);
            EXPECT_EQ(identity.stroke, begin.stroke);
            EXPECT_EQ(identity.place, begin.place + static_cast<std::int64_t>(i));
            EXPECT_EQ(v.layer, lines.vertex[strip[0]].layer);
            EXPECT_EQ(v.is_paper, 0U);
            if (i == 0) continue;
            const Vertex& last = lines.vertex[strip[i - 1]];
            EXPECT_NEAR(v.length - last.length, std::hypot(v.window[0] - last.window[0], v.window[1] - last.window[1]),
                        1e-3);
        }
    }
    EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool one) { return one; }));
}

TEST_F(DrawingTest, TriangleStripsAreAsWideAsTheirStroke) {
    const Drawing drawing = drawn();
    const Vertices lines = vertices_of(drawing, HRBFNPR_PRIMITIVE_LINE_STRIPS);
    const Vertices triangles = vertices_of(drawing, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS);
    ASSERT_EQ(triangles.vertex.size(), 2 * lines.vertex.size());
    EXPECT_EQ(strips_of(triangles.index).size(), strips_of(lines.index).size());
    for (const auto& strip : strips_of(lines.index))
        for (std::size_t i = 0; i < strip.size(); ++i) {
            const Vertex& centre = lines.vertex[strip[i]];
            const Vertex& left = triangles.vertex[2 * strip[i]];
            const Vertex& right = triangles.vertex[2 * strip[i] + 1];
            EXPECT_EQ(left.id, centre.id);
            EXPECT_EQ(right.id, centre.id);
            for (int axis = 0; axis < 2; ++axis)
                EXPECT_NEAR(0.5F * (left.window[axis] + right.window[axis]), centre.window[axis], 1e-3F);
            const double width = std::hypot(left.window[0] - right.window[0], left.window[1] - right.window[1]);
            // At a corner wider, so that both sides of it keep their width.
            EXPECT_GE(width, 2.0 * double{centre.radius} - 1e-3);
            EXPECT_LE(width, 4.0 * double{centre.radius} + 1e-3);
            if (identity_of(drawing, centre.id).layer != own) continue;
            EXPECT_NEAR(width, 2.0 * double{centre.radius}, 0.02); // an arc without corners
            EXPECT_NEAR(centre.radius, 2.0F, 1e-3F);
        }
    // The first vertex is on the left, as one goes along the stroke and y grows downward.
    for (const auto& strip : strips_of(lines.index)) {
        const Vertex& from = lines.vertex[strip[0]];
        const Vertex& to = lines.vertex[strip[1]];
        const Vertex& left = triangles.vertex[2 * strip[0]];
        const float cross = (to.window[0] - from.window[0]) * (left.window[1] - from.window[1]) -
                            (to.window[1] - from.window[1]) * (left.window[0] - from.window[0]);
        EXPECT_LT(cross, 0.0F);
    }
}

TEST_F(DrawingTest, StrokesFilledAsTrianglesAreTheImage) {
    layers[1].shown = 0;
    const Drawing drawing = drawn();
    const std::vector<std::uint8_t> pixels = rasterize(drawing, side);
    const Vertices triangles = vertices_of(drawing, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS);
    double area = 0.0;
    for (const auto& strip : strips_of(triangles.index))
        for (std::size_t i = 2; i < strip.size(); ++i) {
            const float* a = triangles.vertex[strip[i - 2]].window;
            const float* b = triangles.vertex[strip[i - 1]].window;
            const float* c = triangles.vertex[strip[i]].window;
            area += 0.5 * std::abs(double{(b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])});
        }
    double ink = 0.0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) ink += 1.0 - pixels[i + 1] / 255.0;
    EXPECT_NEAR(ink / area, 1.0, 0.15); // round ends, and where the arcs cross
}

} // namespace
} // namespace api_test::drawing_test
