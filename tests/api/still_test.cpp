// SPDX-License-Identifier: MIT
// Tests marks that are placed for one drawing.
#include "fixture.h"

namespace api_test::still_test {
namespace {

class Still : public testing::Test {
protected:
    Still() : model(custom_sphere(context, sphere)), renderer(make_renderer(context)) {
        desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 20000);
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_HIDE;
        EXPECT_OK(hrbfnpr_item_init(&item, sizeof item));
        item.style = &style;
    }

    hrbfnpr_status generate_still() {
        hrbfnpr_point_set* made_set = nullptr;
        const hrbfnpr_status status = hrbfnpr_point_set_generate_still(context.get(), model.get(), desc.get(), &item,
                                                                       &camera, nullptr, &made_set, error);
        set.reset(made_set);
        return status;
    }
    hrbfnpr_status draw(hrbfnpr_drawing_info* info = nullptr) {
        hrbfnpr_item drawn = item;
        drawn.point_set = set.get();
        Drawing drawing;
        const hrbfnpr_status status = try_to_draw(renderer, drawn, camera, drawing, error);
        if (info != nullptr && status == HRBFNPR_STATUS_OK) *info = info_of(drawing);
        return status;
    }

    Error error;
    Context context = make_context();
    Sphere sphere;
    Model model;
    Renderer renderer;
    Generation desc;
    hrbfnpr_style style = made(hrbfnpr_style_init);
    hrbfnpr_item item{};
    hrbfnpr_camera camera = front_camera(400);
    PointSet set;
};

TEST_F(Still, HasFewerMarksAndShowsAsMany) {
    for (const float tone_begin : {0.0F, 0.3F}) {
        desc.layer[0].tone_begin = tone_begin;
        desc.layer[0].tone_end = 1.0F;
        ASSERT_OK(generate_still());
        const std::int64_t placed = layer_info(set, 0).marks;
        auto of_still = made(hrbfnpr_drawing_info_init);
        ASSERT_OK(draw(&of_still));
        set = generate(context, model, desc);
        const std::int64_t all = layer_info(set, 0).marks;
        auto of_all = made(hrbfnpr_drawing_info_init);
        ASSERT_OK(draw(&of_all));
        EXPECT_LT(placed, all * 6 / 10);
        EXPECT_GT(of_all.shown, 1000);
        EXPECT_NEAR(static_cast<double>(of_still.shown), static_cast<double>(of_all.shown),
                    0.02 * static_cast<double>(of_all.shown));
        // Splats that face away hide nothing, so some of them are missing.
        EXPECT_GT(of_all.splats, 1000);
        EXPECT_GT(static_cast<double>(of_still.splats), 0.7 * static_cast<double>(of_all.splats));
    }
}

TEST_F(Still, RefusesASeparationThatIsTooLarge) {
    desc.layer.clear();
    desc.add(HRBFNPR_LAYER_KIND_HATCH, 1000);
    desc.layer[0].separation = 50.0;
    EXPECT_FAILS(generate_still(), HRBFNPR_STATUS_NOT_CONVERGED, "use a smaller separation");
}

TEST_F(Still, RefusesOtherDrawings) {
    ASSERT_OK(generate_still());
    style.paper[0] = 0.5F;
    EXPECT_OK(draw());
    style.light[0] = 3.0;
    EXPECT_FAILS(draw(), HRBFNPR_STATUS_INVALID_ARGUMENT, "items[0].point_set has only the marks that another camera");
    style.light[0] = made(hrbfnpr_style_init).light[0];
    style.occlusion_lights = 0.8F; // Darker hollows need more marks.
    EXPECT_FAILS(draw(), HRBFNPR_STATUS_INVALID_ARGUMENT, "items[0].point_set has only the marks that another camera");
    style.occlusion_lights = 0.0F;
    item.transform[12] = 0.1;
    EXPECT_FAILS(draw(), HRBFNPR_STATUS_INVALID_ARGUMENT, "items[0].point_set has only the marks that another camera");
    item.transform[12] = 0.0;
    EXPECT_OK(draw());
    camera.view[12] = 0.1;
    EXPECT_FAILS(draw(), HRBFNPR_STATUS_INVALID_ARGUMENT, "items[0].point_set has only the marks that another camera");
}

// A style with another name may apply to other layers.
TEST_F(Still, RefusesAStyleForLayersOfAnotherName) {
    auto layer = made(hrbfnpr_layer_style_init);
    style.layers = &layer;
    style.layer_count = 1;
    ASSERT_OK(generate_still());
    EXPECT_OK(draw());
    layer.name = "other";
    EXPECT_FAILS(draw(), HRBFNPR_STATUS_INVALID_ARGUMENT, "items[0].point_set has only the marks that another camera");
}

TEST_F(Still, CannotBeSaved) {
    ASSERT_OK(generate_still());
    std::int64_t size = 0;
    EXPECT_FAILS(hrbfnpr_point_set_save_memory(set.get(), nullptr, 0, &size, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "set has only the marks that a still picture needs");
}

TEST_F(Still, RefusesADrawingThatCannotBeMade) {
    item.sides = 7;
    EXPECT_FAILS(generate_still(), HRBFNPR_STATUS_INVALID_ARGUMENT, "item.sides is 7");
    item.sides = HRBFNPR_SIDES_FRONT;
    style.tone_exponent = -1.0;
    EXPECT_FAILS(generate_still(), HRBFNPR_STATUS_INVALID_ARGUMENT, "item.style.tone_exponent is -1");
    style.tone_exponent = 1.0;
    camera.viewport[2] = 0.0;
    EXPECT_FAILS(generate_still(), HRBFNPR_STATUS_INVALID_ARGUMENT, "camera.viewport is 0 x 400");
    hrbfnpr_point_set* none = nullptr;
    EXPECT_FAILS(hrbfnpr_point_set_generate_still(context.get(), model.get(), desc.get(), nullptr, &camera, nullptr,
                                                  &none, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "item is NULL");
}

} // namespace
} // namespace api_test::still_test
