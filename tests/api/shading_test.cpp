// SPDX-License-Identifier: MIT
// Occlusion and cast shadows, by the C interface.
#include "fixture.h"

namespace api_test::shading_test {
namespace {

// Two unit balls, one above the other by 3. Both have stipples and line sets.
class Shadings : public testing::Test {
protected:
    Shadings() : model(custom_sphere(context, sphere)), renderer(make_renderer(context)) {
        desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 20000);
        set = generate(context, model, desc);
        auto line_desc = made(hrbfnpr_line_set_desc_init);
        hrbfnpr_line_set* made_lines = nullptr;
        EXPECT_OK(hrbfnpr_line_set_create(context.get(), model.get(), &line_desc, nullptr, &made_lines, error));
        lines.reset(made_lines);
        style.fill_light = 0.0F;
        light.space = HRBFNPR_LIGHT_WORLD;
        light.shadow = 1.0F;
        light.place[0] = 0.0;
        light.place[1] = 1.0;
        light.place[2] = 0.0;
        style.lights = &light;
        style.light_count = 1;
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
        for (hrbfnpr_item& item : items) {
            EXPECT_OK(hrbfnpr_item_init(&item, sizeof item));
            item.point_set = set.get();
            item.line_set = lines.get();
            item.style = &style;
        }
        items[1].transform[13] = 3.0;
        hrbfnpr_occluders* made_occluders = nullptr;
        EXPECT_OK(hrbfnpr_occluders_create(context.get(), items.data(), 2, 0, nullptr, &made_occluders, error));
        occluders.reset(made_occluders);
    }
    hrbfnpr_status shade(const hrbfnpr_item& item, const hrbfnpr_shading_desc* shading_desc = nullptr,
                         const hrbfnpr_camera* seen_from = nullptr) {
        hrbfnpr_shading* made_shading = nullptr;
        const hrbfnpr_status status = hrbfnpr_shading_create(context.get(), occluders.get(), &item, seen_from,
                                                             shading_desc, nullptr, &made_shading, error);
        shading.reset(made_shading);
        return status;
    }
    // Returns the number of strokes of lines of a kind on an item.
    std::int64_t strokes_of(const hrbfnpr_item& item, std::uint32_t kind) {
        auto line = made(hrbfnpr_line_style_init);
        line.kind = kind;
        line.hidden = HRBFNPR_HIDDEN_PARTS_SHOWN;
        style.lines = &line;
        style.line_count = 1;
        const Drawing drawing = draw_item(renderer, item, camera);
        style.lines = nullptr;
        style.line_count = 0;
        std::int64_t strokes = 0;
        for (std::int64_t i = 0; i < info_of(drawing).layers; ++i) {
            auto layer = made(hrbfnpr_drawing_layer_info_init);
            EXPECT_OK(hrbfnpr_drawing_get_layer_info(drawing.get(), i, &layer, error));
            if (layer.layer == -1 && layer.kind == kind) strokes += layer.strokes;
        }
        return strokes;
    }
    // Returns the number of marks of an item that are shown.
    std::int64_t shown(hrbfnpr_item item) {
        item.line_set = nullptr;
        return info_of(draw_item(renderer, item, camera)).shown;
    }

    struct ReleaseOccluders {
        void operator()(hrbfnpr_occluders* handle) const { hrbfnpr_occluders_release(handle); }
    };
    struct ReleaseShading {
        void operator()(hrbfnpr_shading* handle) const { hrbfnpr_shading_release(handle); }
    };

    Error error;
    Context context = make_context();
    Sphere sphere;
    Model model;
    Renderer renderer;
    Generation desc;
    PointSet set;
    hrbfnpr::test::LineSet lines;
    hrbfnpr_style style = made(hrbfnpr_style_init);
    hrbfnpr_light light = made(hrbfnpr_light_init);
    std::array<hrbfnpr_item, 2> items{};
    std::unique_ptr<hrbfnpr_occluders, ReleaseOccluders> occluders;
    std::unique_ptr<hrbfnpr_shading, ReleaseShading> shading;
    hrbfnpr_camera camera = front_camera(400);
};

TEST_F(Shadings, TheUpperBallShadesTheLowerOne) {
    for (hrbfnpr_item& item : items) {
        const std::int64_t lit = shown(item);
        ASSERT_OK(shade(item));
        item.shading = shading.get();
        const std::int64_t shaded = shown(item);
        if (&item == &items[0])
            EXPECT_GT(shaded, lit + lit / 8);
        else
            EXPECT_EQ(shaded, lit) << "nothing is above it, and its own shadow lies where it faces away";
        item.shading = nullptr;
    }
}

TEST_F(Shadings, HalfAShadowTakesHalfOfTheLight) {
    const std::int64_t lit = shown(items[0]);
    ASSERT_OK(shade(items[0]));
    items[0].shading = shading.get();
    const std::int64_t full = shown(items[0]);
    light.shadow = 0.5F;
    const std::int64_t half = shown(items[0]);
    EXPECT_GT(half, lit);
    EXPECT_LT(half, full);
}

// The curvature of a ball is the same everywhere.
TEST_F(Shadings, ContrastOfCurvatureLeavesABallAsItIs) {
    style.curvature_contrast = 0.8F;
    light.shadow = 0.0F;
    const std::int64_t without = shown(items[0]);
    ASSERT_OK(shade(items[0]));
    items[0].shading = shading.get();
    const auto all = static_cast<double>(without);
    EXPECT_NEAR(static_cast<double>(shown(items[0])), all, 0.03 * all);
}

TEST_F(Shadings, CurvatureStaysWithThePreviousShading) {
    style.curvature_contrast = 0.8F;
    auto shading_desc = made(hrbfnpr_shading_desc_init);
    ASSERT_OK(shade(items[0], &shading_desc));
    items[0].shading = shading.get();
    const std::int64_t first = shown(items[0]);
    const std::unique_ptr<hrbfnpr_shading, ReleaseShading> previous(shading.release());
    shading_desc.previous = previous.get();
    shading_desc.curvature_scale = 0.0;
    ASSERT_OK(shade(items[0], &shading_desc));
    items[0].shading = shading.get();
    EXPECT_EQ(shown(items[0]), first);
}

TEST_F(Shadings, ContrastOfCurvatureNeedsALineSet) {
    style.curvature_contrast = 0.8F;
    hrbfnpr_item item = items[0];
    item.line_set = nullptr;
    EXPECT_FAILS(shade(item), HRBFNPR_STATUS_INVALID_ARGUMENT, "item.line_set is NULL; give a line set");
    auto shading_desc = made(hrbfnpr_shading_desc_init);
    shading_desc.curvature_scale = 0.0;
    EXPECT_OK(shade(item, &shading_desc));
    shading_desc.curvature_scale = 1.5;
    EXPECT_FAILS(shade(item, &shading_desc), HRBFNPR_STATUS_INVALID_ARGUMENT, "shading_desc.curvature_scale");
}

TEST_F(Shadings, OcclusionDarkensWhatIsBelow) {
    style.light_count = 0;
    style.light[0] = 0.0;
    style.light[1] = 0.0;
    style.light[2] = -1.0;
    style.light_space = HRBFNPR_LIGHT_WORLD;
    style.ambient_sky = style.ambient_ground = 0.8F;
    items[1].transform[13] = 2.05;
    hrbfnpr_occluders* closer = nullptr;
    ASSERT_OK(hrbfnpr_occluders_create(context.get(), items.data(), 2, 0, nullptr, &closer, error));
    occluders.reset(closer);
    const std::int64_t open = shown(items[0]);
    ASSERT_OK(shade(items[0]));
    items[0].shading = shading.get();
    const std::int64_t occluded = shown(items[0]);
    EXPECT_GT(occluded, open + open / 50);
    style.occlusion = 0.0F;
    EXPECT_EQ(shown(items[0]), open);
    style.occlusion = 1.0F;
    auto none = made(hrbfnpr_shading_desc_init);
    none.occlusion_reach = 0.0;
    ASSERT_OK(shade(items[0], &none));
    items[0].shading = shading.get();
    EXPECT_EQ(shown(items[0]), open);
}

TEST_F(Shadings, TakeOcclusionFromAnEarlierOne) {
    style.ambient_sky = 0.5F;
    ASSERT_OK(shade(items[0]));
    items[0].shading = shading.get();
    const std::int64_t from_above = shown(items[0]);
    const auto first = std::move(shading);
    auto again = made(hrbfnpr_shading_desc_init);
    again.previous = first.get();
    again.sky_rays = 1;
    ASSERT_OK(shade(items[0], &again));
    items[0].shading = shading.get();
    EXPECT_EQ(shown(items[0]), from_above);
}

TEST_F(Shadings, ShowWhatTheMarksSee) {
    ASSERT_OK(shade(items[0]));
    hrbfnpr_array position{}, open{}, lit{};
    ASSERT_OK(hrbfnpr_point_set_view(set.get(), 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &position, error));
    ASSERT_OK(hrbfnpr_shading_view(shading.get(), 0, -1, &open, error));
    ASSERT_OK(hrbfnpr_shading_view(shading.get(), 0, 0, &lit, error));
    ASSERT_EQ(open.count, position.count);
    ASSERT_EQ(lit.count, position.count);
    const auto* const at = static_cast<const float*>(position.data);
    for (std::int64_t i = 0; i < position.count; ++i) {
        // The light comes from above, where the other ball is as wide as this one.
        const float height = at[3 * i + 1], aside = std::hypot(at[3 * i], at[3 * i + 2]);
        if (height > 0.05F && aside < 0.95F) {
            EXPECT_EQ(static_cast<const float*>(lit.data)[i], 0.0F) << i;
        }
        if (height < -0.5F) {
            EXPECT_EQ(static_cast<const float*>(open.data)[i], 1.0F) << i;
        }
    }
    EXPECT_FAILS(hrbfnpr_shading_view(shading.get(), 1, 0, &open, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "layer is 1");
    EXPECT_FAILS(hrbfnpr_shading_view(shading.get(), 0, 1, &open, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "light is 1; this light casts no shadow");
    EXPECT_FAILS(hrbfnpr_shading_view(shading.get(), 0, 8, &open, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "light is 8; it must be from -1 to 7");
    auto none = made(hrbfnpr_shading_desc_init);
    none.occlusion_reach = 0.0;
    ASSERT_OK(shade(items[0], &none));
    EXPECT_FAILS(hrbfnpr_shading_view(shading.get(), 0, -1, &open, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "the shading has no occlusion");
}

TEST_F(Shadings, OfLightsInCameraSpaceNeedTheCamera) {
    light.space = HRBFNPR_LIGHT_CAMERA;
    EXPECT_FAILS(shade(items[0]), HRBFNPR_STATUS_INVALID_ARGUMENT, "camera is NULL");
    EXPECT_OK(shade(items[0], nullptr, &camera));
}

TEST_F(Shadings, HaveTheBordersOfShadowsAsLines) {
    auto with_lines = made(hrbfnpr_shading_desc_init);
    with_lines.flags = HRBFNPR_SHADING_WITH_LINES;
    ASSERT_OK(shade(items[0]));
    items[0].shading = shading.get();
    EXPECT_EQ(strokes_of(items[0], HRBFNPR_LINE_KIND_SHADOW), 0) << "the lines were not asked for";
    EXPECT_EQ(strokes_of(items[0], HRBFNPR_LINE_KIND_TERMINATOR), 0);
    ASSERT_OK(shade(items[1], &with_lines));
    items[1].shading = shading.get();
    EXPECT_EQ(strokes_of(items[1], HRBFNPR_LINE_KIND_SHADOW), 0) << "nothing is above the upper ball";
    EXPECT_GE(strokes_of(items[1], HRBFNPR_LINE_KIND_TERMINATOR), 1);
    light.place[0] = 0.3;
    ASSERT_OK(shade(items[0], &with_lines));
    items[0].shading = shading.get();
    EXPECT_GE(strokes_of(items[0], HRBFNPR_LINE_KIND_SHADOW), 1);
    light.shadow = 0.0F;
    ASSERT_OK(shade(items[0], &with_lines));
    items[0].shading = shading.get();
    EXPECT_EQ(strokes_of(items[0], HRBFNPR_LINE_KIND_SHADOW), 0) << "the light casts no shadow";
    EXPECT_EQ(strokes_of(items[0], HRBFNPR_LINE_KIND_TERMINATOR), 0);
}

TEST_F(Shadings, OccludersKeepTheLineSets) {
    auto with_lines = made(hrbfnpr_shading_desc_init);
    with_lines.flags = HRBFNPR_SHADING_WITH_LINES;
    light.place[0] = 0.3;
    auto line_desc = made(hrbfnpr_line_set_desc_init);
    hrbfnpr_line_set* own = nullptr;
    ASSERT_OK(hrbfnpr_line_set_create(context.get(), model.get(), &line_desc, nullptr, &own, error));
    const hrbfnpr::test::LineSet owned(own);
    lines.reset(); // the line set of the occluders
    items[0].line_set = own;
    ASSERT_OK(shade(items[0], &with_lines));
    items[0].shading = shading.get();
    occluders.reset();
    EXPECT_GE(strokes_of(items[0], HRBFNPR_LINE_KIND_SHADOW), 1);
}

TEST_F(Shadings, WrongArgumentsAreRefused) {
    auto shading_desc = made(hrbfnpr_shading_desc_init);
    shading_desc.flags = 2;
    EXPECT_FAILS(shade(items[0], &shading_desc), HRBFNPR_STATUS_INVALID_ARGUMENT, "shading_desc.flags is 0x2");
    shading_desc.flags = HRBFNPR_SHADING_WITH_LINES;
    hrbfnpr_item without_lines = items[0];
    without_lines.line_set = nullptr;
    EXPECT_FAILS(shade(without_lines, &shading_desc), HRBFNPR_STATUS_INVALID_ARGUMENT, "item.line_set is NULL");
    shading_desc.flags = 0;
    shading_desc.sky_rays = 0;
    EXPECT_FAILS(shade(items[0], &shading_desc), HRBFNPR_STATUS_INVALID_ARGUMENT, "shading_desc.sky_rays is 0");
    ASSERT_OK(shade(items[0]));
    const PointSet other = generate(context, model, desc);
    items[0].shading = shading.get();
    items[0].point_set = other.get();
    Drawing drawing;
    EXPECT_FAILS(try_to_draw(renderer, items[0], camera, drawing, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "items[0].shading was made for another point set");
    for (hrbfnpr_item& item : items) item.line_set = nullptr;
    hrbfnpr_occluders* none = nullptr;
    EXPECT_FAILS(hrbfnpr_occluders_create(context.get(), items.data(), 2, 0, nullptr, &none, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "items have no line_set");
}

} // namespace
} // namespace api_test::shading_test
