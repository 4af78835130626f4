// SPDX-License-Identifier: MIT
#include "scenes/scenes.h"

#include "scenes/shapes.h"

#include <array>

namespace scenes {
namespace {

constexpr std::array<std::string_view, 5> scene_names = {"sphere-stipple", "torus-cross-hatch", "tori-contours",
                                                         "knot-full", "heart-combing"};

std::int32_t heart(void* user, std::int64_t count, const double* points, double* value, double* gradient,
                   double* hessian) {
    return taubin_heart(user, count, points, value, gradient, hessian);
}

hrbfnpr_array packed(const std::vector<double>& numbers) {
    return {numbers.data(), static_cast<std::int64_t>(numbers.size() / 3), 0, HRBFNPR_SCALAR_FLOAT64, 3};
}

Model fit(hrbfnpr_context* context, const Samples& samples) {
    Check check;
    hrbfnpr_fit_desc desc;
    hrbfnpr_fit_desc_init(&desc, sizeof desc);
    desc.points = packed(samples.points);
    desc.normals = packed(samples.normals);
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_fit(context, &desc, nullptr, &model, check.error()));
    return Model(model);
}

Model heart_model(hrbfnpr_context* context) {
    Check check;
    hrbfnpr_custom_desc desc;
    hrbfnpr_custom_desc_init(&desc, sizeof desc);
    desc.function = heart;
    desc.flags = HRBFNPR_CUSTOM_HAS_GRADIENT | HRBFNPR_CUSTOM_THREAD_SAFE;
    const std::array<double, 3> low = {-1.2, -0.75, -1.05};
    const std::array<double, 3> high = {1.2, 0.75, 1.3};
    for (std::size_t i = 0; i < 3; ++i) {
        desc.bounds_min[i] = low[i];
        desc.bounds_max[i] = high[i];
    }
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_create_custom(context, &desc, &model, check.error()));
    return Model(model);
}

struct Recipe {
    std::uint32_t preset;
    std::int64_t marks; // number in each layer
    std::array<double, 3> direction;
    std::array<double, 3> up;
};

Recipe recipe(std::string_view name) {
    if (name == "sphere-stipple") return {HRBFNPR_PRESET_STIPPLE, 6000, {0, -0.3, -1}, {0, 1, 0}};
    if (name == "torus-cross-hatch") return {HRBFNPR_PRESET_CROSS_HATCH, 40000, {0.2, 0.9, -0.8}, {0, 0, 1}};
    if (name == "tori-contours") return {HRBFNPR_PRESET_CONTOUR_AND_STIPPLE, 30000, {-0.4, 0.6, -0.7}, {0, 0, 1}};
    if (name == "knot-full") return {HRBFNPR_PRESET_FULL, 40000, {0.2, 0.3, -1}, {0, 1, 0}};
    return {HRBFNPR_PRESET_COMBING, 40000, {0.5, 1, -0.2}, {0, 0, 1}};
}

Model model_of(hrbfnpr_context* context, std::string_view name) {
    if (name == "sphere-stipple") return fit(context, sphere_6());
    if (name == "torus-cross-hatch") return fit(context, torus(200));
    if (name == "tori-contours") return fit(context, linked_tori(128));
    if (name == "knot-full") return fit(context, trefoil(480));
    if (name == "heart-combing") return heart_model(context);
    throw std::runtime_error("there is no scene called " + std::string(name));
}

PointSet marks_of(hrbfnpr_context* context, const hrbfnpr_model* model, const Recipe& recipe) {
    Check check;
    std::int64_t count = 0;
    const hrbfnpr_layer_desc* const preset = hrbfnpr_preset_layers(recipe.preset, &count);
    std::vector<hrbfnpr_layer_desc> layers(preset, preset + count);
    for (hrbfnpr_layer_desc& layer : layers) layer.budget = recipe.marks;
    hrbfnpr_generate_desc desc;
    hrbfnpr_generate_desc_init(&desc, sizeof desc);
    desc.layers = layers.data();
    desc.layer_count = count;
    hrbfnpr_point_set* set = nullptr;
    check(hrbfnpr_point_set_generate(context, model, &desc, nullptr, &set, check.error()));
    return PointSet(set);
}

LineSet lines_of(hrbfnpr_context* context, const hrbfnpr_model* model) {
    Check check;
    hrbfnpr_line_set* set = nullptr;
    check(hrbfnpr_line_set_create(context, model, nullptr, nullptr, &set, check.error()));
    return LineSet(set);
}

} // namespace

std::span<const std::string_view> names() { return scene_names; }

Scene make(hrbfnpr_context* context, std::string_view name, int width, int height) {
    Check check;
    Scene scene;
    scene.model = model_of(context, name);
    const Recipe r = recipe(name);
    check(hrbfnpr_style_init_preset(&scene.style, sizeof scene.style, r.preset, check.error()));
    if (name == "heart-combing") scene.style.paper[3] = 0.0F; // this scene has transparent paper
    scene.marks = marks_of(context, scene.model.get(), r);
    if (scene.style.line_count > 0) scene.lines = lines_of(context, scene.model.get());
    hrbfnpr_point_set_info info;
    hrbfnpr_point_set_info_init(&info, sizeof info);
    check(hrbfnpr_point_set_get_info(scene.marks.get(), &info, check.error()));
    hrbfnpr_camera_init(&scene.camera, sizeof scene.camera);
    check(hrbfnpr_camera_fit_bounds(&scene.camera, info.bounds_min, info.bounds_max, r.direction.data(), r.up.data(),
                                    0.6, width, height, 0.05, check.error()));
    return scene;
}

Picture draw(hrbfnpr_context* context, const Scene& scene) {
    Check check;
    hrbfnpr_renderer* handle = nullptr;
    check(hrbfnpr_renderer_create(context, &handle, check.error()));
    const Renderer renderer(handle);
    hrbfnpr_item item;
    hrbfnpr_item_init(&item, sizeof item);
    item.point_set = scene.marks.get();
    item.line_set = scene.lines.get();
    item.style = &scene.style;
    hrbfnpr_drawing* drawn = nullptr;
    check(hrbfnpr_renderer_draw(handle, &item, 1, 0, &scene.camera, &drawn, check.error()));
    const Drawing drawing(drawn);

    Picture picture;
    picture.width = static_cast<int>(scene.camera.viewport[2]);
    picture.height = static_cast<int>(scene.camera.viewport[3]);
    picture.rgba.assign(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 4, 0);
    hrbfnpr_image image;
    hrbfnpr_image_init(&image, sizeof image);
    image.width = picture.width;
    image.height = picture.height;
    image.pixels = picture.rgba.data();
    check(hrbfnpr_drawing_rasterize(drawn, &image, nullptr, check.error()));
    return picture;
}

} // namespace scenes
