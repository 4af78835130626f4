// SPDX-License-Identifier: MIT
#include "picture/ground.h"

#include "picture/tuning_ground.h"
#include "planned_call.h"

#include <gtest/gtest.h>

#include <cmath>

namespace picture_tests::ground_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

constexpr glm::dvec3 up(0.0, 0.0, 1.0);

// A camera that looks at the origin from a height.
hrbfnpr_camera camera_above(double height, bool has_perspective = true) {
    auto camera = picture::defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    const glm::dvec3 eye(6.0, 0.0, height);
    const glm::dvec3 target(0.0);
    picture::call(
        [&](hrbfnpr_error* error) { return hrbfnpr_camera_look_at(&camera, &eye.x, &target.x, &up.x, error); });
    picture::call([&](hrbfnpr_error* error) {
        return has_perspective ? hrbfnpr_camera_perspective(&camera, 0.5, 200, 200, 4.0, 8.0, error)
                               : hrbfnpr_camera_orthographic(&camera, 4.0, 200, 200, 4.0, 8.0, error);
    });
    return camera;
}

// A ground at z = -1 under a few places, with a light in world space.
class GroundTest : public testing::Test {
protected:
    GroundTest() : planned(HRBFNPR_PRESET_STIPPLE), places(&planned.pool) {
        planned.desc.ground = HRBFNPR_PICTURE_GROUND_LOWEST;
        for (const glm::dvec3& place : {glm::dvec3(1, 0, -1), glm::dvec3(-1, 1, 0), glm::dvec3(0, -1, 1)})
            places.push_back(place);
    }
    [[nodiscard]] Ground ground(double x, double y, double z, std::uint32_t kind = HRBFNPR_LIGHT_KIND_DIRECTIONAL) {
        Style style(HRBFNPR_PRESET_STIPPLE, planned.pool);
        auto light = picture::defaults<hrbfnpr_light>(hrbfnpr_light_init);
        light.kind = kind;
        light.space = HRBFNPR_LIGHT_WORLD;
        light.place[0] = x;
        light.place[1] = y;
        light.place[2] = z;
        style.lights.push_back(light);
        return ground_of(planned.call().options, style, up, places);
    }

    PlannedCall planned;
    Points places;
};

TEST_F(GroundTest, IsAtTheLowestPlace) {
    EXPECT_EQ(ground(0, 0, 1).plane.height, -1.0);
    planned.desc.ground = HRBFNPR_PICTURE_GROUND_HEIGHT;
    planned.desc.ground_height = -3.0;
    EXPECT_EQ(ground(0, 0, 1).plane.height, -3.0);
}

TEST_F(GroundTest, ShadowsFallAwayFromTheLight) {
    const Points shadows = framed_shadows(ground(1, 0, 2), camera_above(3.0), places, planned.pool);
    ASSERT_EQ(shadows.size(), 3U);
    EXPECT_NEAR(glm::distance(shadows[1], glm::dvec3(-1.5, 1, -1)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(shadows[2], glm::dvec3(-1, -1, -1)), 0.0, 1e-12);
    const Points of_place =
        framed_shadows(ground(0, 0, 3, HRBFNPR_LIGHT_KIND_PLACE), camera_above(3.0), places, planned.pool);
    ASSERT_EQ(of_place.size(), 3U);
    EXPECT_NEAR(glm::distance(of_place[1], glm::dvec3(-4.0 / 3.0, 4.0 / 3.0, -1)), 0.0, 1e-12);
}

TEST_F(GroundTest, FramedShadowsEndNearTheObject) {
    const Ground low = ground(1, 0, 0.01);
    for (const glm::dvec3& place : framed_shadows(low, camera_above(3.0), places, planned.pool))
        EXPECT_GE(place.x, -1.0 - ground_tuning.framed * low.diagonal - 1e-12);
    EXPECT_TRUE(framed_shadows(ground(1, 0, -1), camera_above(3.0), places, planned.pool).empty());
}

TEST_F(GroundTest, OnlyCamerasAboveSeeIt) {
    for (const bool has_perspective : {false, true}) {
        EXPECT_TRUE(sees_ground(camera_above(2.0, has_perspective), {up, -1.0}));
        EXPECT_FALSE(sees_ground(camera_above(-2.0, has_perspective), {up, -1.0}));
    }
    EXPECT_TRUE(sees_ground(camera_above(-0.5), {up, -1.0})); // It looks upward, but is above the ground.
    EXPECT_FALSE(sees_ground(camera_above(-0.5, false), {up, -1.0}));
}

// The light of open ground is the white of the tone law: n . l, and what comes from the sky.
TEST_F(GroundTest, OpenGroundIsWhite) {
    Ground found = ground(0, 3, 4);
    found.style.base.ambient_sky = 0.25F;
    found.style.base.ambient_up[1] = 0.0;
    found.style.base.ambient_up[2] = 1.0;
    set_ground_light(camera_above(3.0), found);
    EXPECT_NEAR(found.style.base.tone_white, (0.8 + 0.25) * (1.0 - ground_tuning.white_share), 1e-6);
    EXPECT_EQ(found.style_view.tone_white, found.style.base.tone_white);
}

TEST_F(GroundTest, FirstLightCastsShadowsIfNoneDoes) {
    EXPECT_EQ(ground(0, 0, 1).style.lights.front().shadow, 1.0F);
    EXPECT_EQ(ground(0, 0, 1).style.lights.front().softness, ground_tuning.softness);
}

TEST_F(GroundTest, FieldsOfTheObjectAreNotForIt) {
    for (const char* const name : {static_cast<const char*>(nullptr), "ground"}) {
        Style style(HRBFNPR_PRESET_STIPPLE, planned.pool);
        hrbfnpr_layer_style& layer = style.layers.front();
        layer.name = name;
        for (const auto field :
             {&hrbfnpr_layer_style::density_field, &hrbfnpr_layer_style::tone_field, &hrbfnpr_layer_style::width_field,
              &hrbfnpr_layer_style::mask_field, &hrbfnpr_layer_style::ink_field})
            layer.*field = "heat";
        layer.radius = 3.0F;
        const Call call = planned.call();
        const hrbfnpr_camera camera = camera_above(4.0);
        auto desc = picture::defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
        desc.kind = HRBFNPR_LAYER_KIND_STIPPLES;
        Ground made = ground_of(call.options, style, up, places);
        place_ground(call, GroundPlan{style, std::span(&desc, 1), places, camera, 1.0, false}, made);
        const hrbfnpr_layer_style& drawn = made.style.layers.front();
        EXPECT_EQ(drawn.radius, 3.0F);
        EXPECT_EQ(drawn.density_field, nullptr);
        EXPECT_EQ(drawn.tone_field, nullptr);
        EXPECT_EQ(drawn.width_field, nullptr);
        EXPECT_EQ(drawn.mask_field, nullptr);
        EXPECT_EQ(drawn.ink_field, nullptr);
    }
}

TEST(GroundCamera, PlanesMoveForPlacesOfTheGround) {
    base::Memory memory;
    Pool pool(memory);
    const auto window_depth = [](const hrbfnpr_camera& camera, const glm::dvec3& place) {
        const glm::dvec4 clip = clip_place(camera, place);
        return clip.z / clip.w;
    };
    for (const bool has_perspective : {false, true}) {
        const hrbfnpr_camera camera = camera_above(0.0, has_perspective);
        Points places(&pool);
        places.emplace_back(3.0, 0.0, 0.0);
        places.emplace_back(-5.0, 0.0, 0.0);
        EXPECT_LT(window_depth(camera, places[0]), -1.0);
        EXPECT_GT(window_depth(camera, places[1]), 1.0);
        const hrbfnpr_camera moved = with_depth_of(camera, places);
        EXPECT_NEAR(window_depth(moved, places[0]), -1.0, 1e-12);
        EXPECT_NEAR(window_depth(moved, places[1]), 1.0, 1e-12);
        const glm::dvec4 before = clip_place(camera, {1.0, 0.5, 0.25});
        const glm::dvec4 after = clip_place(moved, {1.0, 0.5, 0.25});
        EXPECT_EQ(glm::dvec2(before), glm::dvec2(after));
        EXPECT_EQ(before.w, after.w);
    }
}

} // namespace
} // namespace picture_tests::ground_test
