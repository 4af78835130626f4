// SPDX-License-Identifier: MIT
// Lists of lights and tone laws of a style, by the C interface.
#include "fixture.h"

namespace api_test::style_lights_test {
namespace {

// A sphere with stipples.
class Lights : public testing::Test {
protected:
    Lights() : model(custom_sphere(context, sphere)), renderer(make_renderer(context)) {
        desc.add(HRBFNPR_LAYER_KIND_STIPPLES, 4000);
        set = generate(context, model, desc);
        EXPECT_OK(hrbfnpr_item_init(&item, sizeof item));
        item.point_set = set.get();
        item.style = &style;
        style.fill_light = 0.0F;
        style.tone_fade = 0.0F;
    }
    // Returns the number of marks that are shown.
    std::int64_t shown() { return info_of(draw_item(renderer, item, camera)).shown; }
    hrbfnpr_status draw() {
        Drawing drawing;
        return try_to_draw(renderer, item, camera, drawing, error);
    }
    void set_lights(const std::vector<hrbfnpr_light>& given) {
        lights = given;
        style.lights = lights.data();
        style.light_count = static_cast<std::int64_t>(lights.size());
    }

    Error error;
    Context context = make_context();
    Sphere sphere;
    Model model;
    Renderer renderer;
    Generation desc;
    PointSet set;
    hrbfnpr_style style = made(hrbfnpr_style_init);
    hrbfnpr_light light = made(hrbfnpr_light_init);
    hrbfnpr_item item{};
    hrbfnpr_camera camera = front_camera(400);
    std::vector<hrbfnpr_light> lights;
};

TEST_F(Lights, AListOfTheDefaultLightDrawsTheSame) {
    const std::int64_t alone = shown();
    EXPECT_GT(alone, 200);
    set_lights({light});
    EXPECT_EQ(shown(), alone);
    set_lights({light, light});
    EXPECT_LT(shown(), alone) << "twice the light";
    lights[1].intensity = 0.0F;
    EXPECT_EQ(shown(), alone);
}

TEST_F(Lights, APlaceFarAwayIsADirection) {
    const std::int64_t alone = shown();
    light.kind = HRBFNPR_LIGHT_KIND_PLACE;
    for (double& c : light.place) c *= 1e4;
    set_lights({light});
    EXPECT_NEAR(static_cast<double>(shown()), static_cast<double>(alone), 3.0);
}

TEST_F(Lights, AmbientLightAndRimLightTakeMarksAway) {
    const std::int64_t alone = shown();
    style.ambient_sky = 0.3F;
    const std::int64_t sky = shown();
    EXPECT_LT(sky, alone);
    style.ambient_ground = 0.3F;
    const std::int64_t both = shown();
    EXPECT_LT(both, sky);
    style.rim_light = 1.0F;
    EXPECT_LT(shown(), both);
    style.ambient_sky = style.ambient_ground = 1.0F;
    EXPECT_EQ(shown(), 0);
}

TEST_F(Lights, TheToneLawMakesBlackAndWhite) {
    const std::int64_t alone = shown();
    style.tone_black = 0.4F;
    EXPECT_GT(shown(), alone);
    style.tone_black = 0.0F;
    style.tone_white = 0.5F;
    EXPECT_LT(shown(), alone);
    style.tone_white = 1.0F;
    style.tone_gamma = 2.0F;
    EXPECT_GT(shown(), alone);
    style.tone_gamma = 1.0F;
    style.tone_steps = 2;
    EXPECT_NE(shown(), alone);
}

TEST_F(Lights, WrongOnesAreRefused) {
    const auto says = [&](const char* words) { EXPECT_FAILS(draw(), HRBFNPR_STATUS_INVALID_ARGUMENT, words); };
    set_lights(std::vector<hrbfnpr_light>(9, light));
    says("light_count is 9");
    set_lights({light});
    lights[0].kind = 2;
    says("items[0].style.lights[0].kind");
    lights[0] = light;
    lights[0].intensity = -1.0F;
    says("items[0].style.lights[0].intensity");
    lights[0] = light;
    lights[0].place[0] = lights[0].place[1] = lights[0].place[2] = 0.0;
    says("items[0].style.lights[0].place is zero");
    lights[0] = light;
    style.tone_white = 0.0F;
    says("tone_white must be greater");
    style.tone_white = 1.0F;
    style.tone_steps = 1;
    says("tone_steps is 1");
    style.tone_steps = 0;
    style.ambient_up[1] = 0.0;
    says("ambient_up is zero");
}

} // namespace
} // namespace api_test::style_lights_test
