// SPDX-License-Identifier: MIT
#include "fixture.h"
#include "support/preset_names.h"

#include <cmath>
#include <limits>
#include <set>

namespace api_test::camera_style_test {
namespace {

// The pixel position of a world point.
std::array<double, 2> pixel(const hrbfnpr_camera& camera, const double (&world)[3]) {
    double eye[4] = {0, 0, 0, 0};
    double clip[4] = {0, 0, 0, 0};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            eye[row] += camera.view[4 * column + row] * (column < 3 ? world[column] : 1.0);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) clip[row] += camera.projection[4 * column + row] * eye[column];
    return {camera.viewport[0] + camera.viewport[2] * (0.5 + 0.5 * clip[0] / clip[3]),
            camera.viewport[1] + camera.viewport[3] * (0.5 - 0.5 * clip[1] / clip[3])};
}

TEST(Camera, FitsPoints) {
    Error error;
    auto camera = made(hrbfnpr_camera_init);
    const std::vector<float> relative{-1, 0, 0, 1, 0, 0, 0, 0.5F, 0.25F};
    const hrbfnpr_array points = in(relative);
    const double origin[3] = {10, 20, 30};
    const double direction[3] = {0, 0, -1};
    const double up[3] = {0, 1, 0};
    EXPECT_OK(hrbfnpr_camera_fit_points(&camera, &points, origin, direction, up, 0, 200, 100, 0.1, error));
    EXPECT_NEAR(pixel(camera, {9, 20, 30})[0], 20.0, 1e-6); // the margin is a tenth on each side
    EXPECT_NEAR(pixel(camera, {11, 20, 30})[0], 180.0, 1e-6);
    const auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
    const hrbfnpr_array none{nullptr, 0, 0, 0, 0};
    EXPECT_FAILS(hrbfnpr_camera_fit_points(&camera, &none, origin, direction, up, 0, 9, 9, 0, error), invalid,
                 "points is empty");
    EXPECT_FAILS(hrbfnpr_camera_fit_points(&camera, nullptr, origin, direction, up, 0, 9, 9, 0, error), invalid,
                 "points is NULL");
    const std::vector<float> bad{0, 0, 0, 0, std::nanf(""), 0};
    const hrbfnpr_array bad_points = in(bad);
    EXPECT_FAILS(hrbfnpr_camera_fit_points(&camera, &bad_points, origin, direction, up, 0, 9, 9, 0, error), invalid,
                 "points[1]");
}

TEST(Camera, AFailureChangesNothing) {
    Error error;
    auto camera = made(hrbfnpr_camera_init);
    const hrbfnpr_camera before = camera;
    const double a[3] = {0, 0, 1};
    const double b[3] = {0, 0, 2};
    const double zero[3] = {0, 0, 0};
    const double nan[3] = {0, 0, std::nan("")};
    const auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
    EXPECT_FAILS(hrbfnpr_camera_look_at(&camera, a, a, b, error), invalid, "eye and target are the same point");
    EXPECT_FAILS(hrbfnpr_camera_look_at(&camera, a, b, a, error), invalid, "is parallel to the direction of view");
    EXPECT_FAILS(hrbfnpr_camera_look_at(&camera, a, b, zero, error), invalid, "up is the zero vector");
    EXPECT_FAILS(hrbfnpr_camera_look_at(&camera, nan, b, a, error), invalid, "eye is (0, 0, nan)");
    EXPECT_FAILS(hrbfnpr_camera_look_at(&camera, nullptr, b, a, error), invalid, "eye is NULL");
    EXPECT_FAILS(hrbfnpr_camera_look_at(nullptr, a, b, a, error), invalid, "camera is NULL");
    EXPECT_FAILS(hrbfnpr_camera_perspective(&camera, 0.0, 9, 9, 1, 2, error), invalid, "vertical_angle is 0");
    EXPECT_FAILS(hrbfnpr_camera_perspective(&camera, 1.0, 0, 9, 1, 2, error), invalid, "width is 0");
    EXPECT_FAILS(hrbfnpr_camera_perspective(&camera, 1.0, 9, -9, 1, 2, error), invalid, "height is -9");
    EXPECT_FAILS(hrbfnpr_camera_perspective(&camera, 1.0, 9, 9, 0, 2, error), invalid, "near_plane is 0");
    EXPECT_FAILS(hrbfnpr_camera_perspective(&camera, 1.0, 9, 9, 3, 2, error), invalid, "near_plane is 3");
    EXPECT_FAILS(hrbfnpr_camera_orthographic(&camera, 0, 9, 9, 1, 2, error), invalid, "view_height is 0");
    EXPECT_FAILS(hrbfnpr_camera_fit_bounds(&camera, b, a, a, a, 0, 9, 9, 0, error), invalid, "bounds_min[2] is 2");
    EXPECT_FAILS(hrbfnpr_camera_fit_bounds(&camera, a, b, zero, a, 0, 9, 9, 0, error), invalid,
                 "direction is the zero vector");
    EXPECT_FAILS(hrbfnpr_camera_fit_bounds(&camera, a, b, a, a, 0, 9, 9, 0.5, error), invalid, "margin is 0.5");
    EXPECT_FAILS(hrbfnpr_camera_fit_bounds(&camera, a, nullptr, a, a, 0, 9, 9, 0, error), invalid,
                 "bounds_max is NULL");
    EXPECT_EQ(std::memcmp(&camera, &before, sizeof camera), 0);
    camera.depth_convention = 3;
    EXPECT_FAILS(hrbfnpr_camera_perspective(&camera, 1.0, 9, 9, 1, 2, error), invalid, "camera.depth_convention is 3");
}

// The layer style that a style uses for a kind of layers: the first that matches.
hrbfnpr_layer_style style_for(const hrbfnpr_style& style, std::uint32_t kind) {
    for (std::int64_t i = 0; i < style.layer_count; ++i)
        if (style.layers[i].kind == kind || style.layers[i].kind == HRBFNPR_LAYER_KIND_ANY) return style.layers[i];
    return made(hrbfnpr_layer_style_init);
}

TEST(Style, PresetsHaveNamesAndLayers) {
    std::set<std::string> names;
    std::uint32_t presets = 0;
    for (; hrbfnpr_preset_name(presets) != nullptr; ++presets) {
        SCOPED_TRACE(hrbfnpr_preset_name(presets));
        names.insert(hrbfnpr_preset_name(presets));
        Error error;
        hrbfnpr_style style;
        EXPECT_OK(hrbfnpr_style_init_preset(&style, sizeof style, presets, error));
        EXPECT_EQ(style.struct_size, sizeof style);
        EXPECT_GT(style.layer_count, 0);
        std::int64_t count = 0;
        const hrbfnpr_layer_desc* const layers = hrbfnpr_preset_layers(presets, &count);
        ASSERT_NE(layers, nullptr);
        ASSERT_GT(count, 0);
        for (std::int64_t i = 0; i < count; ++i) EXPECT_EQ(layers[i].struct_size, sizeof *layers);
        // The style shows at least one of the layers that a program generates for it.
        bool draws = false;
        for (std::int64_t i = 0; i < count; ++i) {
            const hrbfnpr_layer_style layer = style_for(style, layers[i].kind);
            EXPECT_EQ(layer.struct_size, sizeof layer);
            draws = draws || layer.shown != 0 || layer.contours != 0;
        }
        EXPECT_TRUE(draws);
    }
    EXPECT_EQ(presets, std::size(hrbfnpr::testing::preset_names));
    EXPECT_EQ(names.size(), presets);
    for (const auto& known : hrbfnpr::testing::preset_names)
        EXPECT_STREQ(hrbfnpr_preset_name(known.preset), known.name);
    EXPECT_EQ(hrbfnpr_preset_name(0xFFFFFFFFU), nullptr);
    std::int64_t count = 77;
    EXPECT_EQ(hrbfnpr_preset_layers(presets, &count), nullptr);
    EXPECT_EQ(count, 0);
    Error error;
    hrbfnpr_style style;
    const std::string all = "it must be one of HRBFNPR_PRESET_* (0 to " + std::to_string(presets - 1) + ")";
    EXPECT_FAILS(hrbfnpr_style_init_preset(&style, sizeof style, presets, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "preset is " + std::to_string(presets) + "; " + all);
    EXPECT_FAILS(hrbfnpr_style_init_preset(nullptr, sizeof style, 0, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "style is NULL");
    EXPECT_FAILS(hrbfnpr_style_init_preset(&style, 4, 0, error), HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
                 "style.struct_size is 4");
}

TEST(Style, PresetsAreGeneratedAndDrawn) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const Renderer renderer = make_renderer(context);
    hrbfnpr_line_set* raw_lines = nullptr;
    ASSERT_OK(hrbfnpr_line_set_create(context.get(), model.get(), nullptr, nullptr, &raw_lines, error));
    const LineSet lines(raw_lines);
    for (std::uint32_t preset = 0; hrbfnpr_preset_name(preset) != nullptr; ++preset) {
        auto desc = made(hrbfnpr_generate_desc_init);
        desc.layers = hrbfnpr_preset_layers(preset, &desc.layer_count); // unchanged
        desc.shared_budget = 2000;
        hrbfnpr_point_set* raw = nullptr;
        ASSERT_OK(hrbfnpr_point_set_generate(context.get(), model.get(), &desc, nullptr, &raw, error));
        const PointSet set(raw);
        hrbfnpr_style style;
        ASSERT_OK(hrbfnpr_style_init_preset(&style, sizeof style, preset, error));
        hrbfnpr_item item = item_of(set, &style);
        item.line_set = lines.get();
        const hrbfnpr_drawing_info info = info_of(draw_item(renderer, item, front_camera()));
        EXPECT_GT(info.dots + info.stroke_points, 20) << hrbfnpr_preset_name(preset);
    }
}

} // namespace
} // namespace api_test::camera_style_test
