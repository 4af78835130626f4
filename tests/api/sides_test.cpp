// SPDX-License-Identifier: MIT
// Tests that surfaces that end are seen from both sides.
#include "drawing_fixture.h"
#include "trimmed.h"

namespace api_test::sides_test {
namespace {

class Sides : public testing::Test {
protected:
    // Half a sphere whose inside faces the camera.
    Model bowl_model() {
        scenes::Samples samples = zone(-2.0, 0.0);
        const hrbfnpr_fit_desc desc = fit_desc(samples);
        hrbfnpr_model* raw = nullptr;
        EXPECT_OK(hrbfnpr_model_fit(context.get(), &desc, nullptr, &raw, error));
        Model model(raw);
        EXPECT_EQ(info_of(model).is_trimmed, 1U);
        return model;
    }

    // Stipples and two layers of hatching on the bowl.
    PointSet bowl() { return generate(context, bowl_model(), small_desc()); }

    Drawing draw(const PointSet& set, std::uint32_t sides) {
        hrbfnpr_item item = item_of(set, &style);
        item.sides = sides;
        return draw_item(renderer, item, front_camera(side));
    }

    std::vector<std::uint8_t> picture(const Drawing& drawing) {
        std::vector<std::uint8_t> pixels;
        const hrbfnpr_image image = image_of(pixels, side);
        EXPECT_OK(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, error));
        return pixels;
    }

    Error error;
    Context context = make_context();
    Renderer renderer = make_renderer(context);
    hrbfnpr_style style = made(hrbfnpr_style_init);
};

TEST_F(Sides, BothSidesShowTheInsideOfABowl) {
    const PointSet set = bowl();
    style.tone = HRBFNPR_TONE_NONE;
    for (const std::uint32_t visibility : {HRBFNPR_VISIBILITY_DEPTH_LAYERS, HRBFNPR_VISIBILITY_PUBLISHED}) {
        SCOPED_TRACE(visibility);
        style.visibility = visibility;
        const hrbfnpr_drawing_info front = info_of(draw(set, HRBFNPR_SIDES_FRONT));
        const Drawing drawing = draw(set, HRBFNPR_SIDES_BOTH);
        const hrbfnpr_drawing_info both = info_of(drawing);
        EXPECT_EQ(both.items, 1);
        EXPECT_LT(front.front, 0.1 * static_cast<double>(front.marks));
        EXPECT_EQ(both.marks, 2 * front.marks);
        EXPECT_GT(both.front, 0.75 * static_cast<double>(front.marks));
        std::int64_t shown = 0;
        for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer)
            for (const std::uint8_t mark : results_of(drawing, set, layer).shown) shown += mark == HRBFNPR_CLASS_FRONT;
        EXPECT_GT(shown, 0.75 * static_cast<double>(front.marks));
        for (const Vertex& v : vertices_of(drawing, HRBFNPR_PRIMITIVE_POINTS).vertex) {
            if (v.is_paper != 0) continue;
            const hrbfnpr_mark_identity identity = identity_of(drawing, v.id);
            EXPECT_EQ(identity.item, 0);
            EXPECT_LT(v.position[2], 0.2F);
        }
    }
}

TEST_F(Sides, EachSideIsLitByItsOwnNormals) {
    const PointSet set = bowl();
    style.tone = HRBFNPR_TONE_LIGHT;
    style.light_space = HRBFNPR_LIGHT_WORLD;
    const double right[3] = {1.0, 0.0, 0.0};
    std::copy(right, right + 3, style.light);
    double left_ink = 0.0;
    double right_ink = 0.0;
    for (const Vertex& v : vertices_of(draw(set, HRBFNPR_SIDES_BOTH), HRBFNPR_PRIMITIVE_POINTS).vertex)
        if (v.mark_class == HRBFNPR_CLASS_FRONT)
            (v.position[0] < 0.0F ? left_ink : right_ink) += double{v.radius} * double{v.radius};
    // On the right the inside faces away from the light, so there is more ink.
    EXPECT_GT(right_ink, 1.4 * left_ink);
}

TEST_F(Sides, BothSidesOfASolidLookLikeItsFront) {
    Sphere sphere;
    const PointSet set = generate(context, custom_sphere(context, sphere), small_desc());
    auto strokes = made(hrbfnpr_layer_style_init);
    for (const std::uint32_t shape : {HRBFNPR_SHAPE_DOTS, HRBFNPR_SHAPE_STROKES}) {
        strokes.shape = shape;
        style.layers = &strokes;
        style.layer_count = 1;
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE;
        EXPECT_EQ(picture(draw(set, HRBFNPR_SIDES_BOTH)), picture(draw(set, HRBFNPR_SIDES_FRONT)));
    }
}

// The bottom of the box is seen at a low angle, where a layer that faces the eye would by itself let through half of
// the ink behind it.
TEST_F(Sides, BothSidesOfASolidHideItsInside) {
    auto desc = made(hrbfnpr_custom_desc_init);
    desc.function = [](void* /*user*/, std::int64_t count, const double* points, double* value, double*, double*) {
        for (std::int64_t i = 0; i < count; ++i) {
            value[i] = -1.0;
            for (int k = 0; k < 3; ++k) value[i] += std::pow(points[3 * i + k], 16.0);
        }
        return std::int32_t{0};
    };
    std::fill_n(desc.bounds_min, 3, -1.0);
    std::fill_n(desc.bounds_max, 3, 1.0);
    hrbfnpr_model* raw = nullptr;
    ASSERT_OK(hrbfnpr_model_create_custom(context.get(), &desc, &raw, error));
    // There are enough marks for a whole surface: with few, a layer has gaps beside the edges of the box.
    const PointSet set = generate(context, Model(raw), hrbfnpr::test::three_layers(900));
    ASSERT_EQ(style.hidden_lines, HRBFNPR_HIDDEN_LINES_ATTENUATE);
    style.tone = HRBFNPR_TONE_NONE;
    const auto ink = [&](std::uint32_t sides) {
        const std::vector<std::uint8_t> pixels = picture(draw(set, sides));
        double sum = 0.0;
        for (std::size_t i = 0; i < pixels.size(); i += 4) sum += 255.0 - pixels[i];
        return sum;
    };
    const double front = ink(HRBFNPR_SIDES_FRONT);
    EXPECT_GT(front, 0.0);
    EXPECT_LT(ink(HRBFNPR_SIDES_BOTH), 1.02 * front);
}

// The reference draws the same marks twice, once posed with opposite normals. A pose has no normals for tone, so the
// marks have none either.
TEST_F(Sides, TheBackLooksLikeAFrontWithOppositeNormals) {
    Generation desc = small_desc();
    for (hrbfnpr_layer_desc& layer : desc.layer) layer.tone_smoothing = 0.0;
    const PointSet set = generate(context, bowl_model(), desc);
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    const std::vector<std::uint8_t> both = picture(draw(set, HRBFNPR_SIDES_BOTH));
    const hrbfnpr_point_set_info info = info_of(set);
    std::vector<std::vector<double>> arrays;
    std::vector<hrbfnpr_layer_pose> poses;
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        const auto position = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION);
        const auto normal = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_NORMAL);
        arrays.emplace_back();
        for (std::size_t i = 0; i < position.size(); ++i)
            arrays.back().push_back(double{position[i]} + info.origin[i % 3]);
        arrays.emplace_back();
        for (const float n : normal) arrays.back().push_back(-n);
    }
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        auto pose = made(hrbfnpr_layer_pose_init);
        pose.layer = layer;
        pose.position = in(arrays[static_cast<std::size_t>(2 * layer)]);
        pose.normal = in(arrays[static_cast<std::size_t>(2 * layer + 1)]);
        poses.push_back(pose);
    }
    hrbfnpr_item items[2] = {item_of(set, &style), item_of(set, &style)};
    items[1].poses = poses.data();
    items[1].pose_count = info.layers;
    const hrbfnpr_camera camera = front_camera(side);
    hrbfnpr_drawing* raw = nullptr;
    ASSERT_OK(hrbfnpr_renderer_draw(renderer.get(), items, 2, 0, &camera, &raw, error));
    EXPECT_EQ(both, picture(Drawing(raw)));
}

// Rays go from the marks to the eye, and begin on the visible side.
TEST_F(Sides, BothSidesAreVisibleWithExactVisibility) {
    const Model model = bowl_model();
    const PointSet set = generate(context, model, small_desc());
    style.tone = HRBFNPR_TONE_NONE;
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE;
    hrbfnpr_item item = item_of(set, &style);
    item.model = model.get();
    item.sides = HRBFNPR_SIDES_BOTH;
    const hrbfnpr_drawing_info exact = info_of(draw_item(renderer, item, front_camera(side)));
    const hrbfnpr_drawing_info splats = info_of(draw(set, HRBFNPR_SIDES_BOTH));
    EXPECT_NEAR(static_cast<double>(exact.shown), static_cast<double>(splats.shown),
                0.1 * static_cast<double>(splats.shown));
}

} // namespace
} // namespace api_test::sides_test
