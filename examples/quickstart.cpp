// SPDX-License-Identifier: MIT
// 192 samples of a torus become a pen-and-ink drawing, torus.ppm.
#include <array>
#include <cmath>
#include <fstream>
#include <hrbfnpr.h>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <vector>

using Vec = std::array<double, 3>;

hrbfnpr_error error;

void check(hrbfnpr_status status) {
    if (status != HRBFNPR_STATUS_OK) throw std::runtime_error(error.message);
}

// Calls hrbfnpr_..._create and the like, and owns what they make.
template <class Handle, class Release, class Call>
auto make(Release release, Call&& call) {
    Handle* handle = nullptr;
    check(call(&handle));
    return std::unique_ptr<Handle, Release>(handle, release);
}

// A descriptor with every default in place.
template <class Struct, class Init>
Struct defaults(Init init) {
    Struct result;
    check(init(&result, sizeof result));
    return result;
}

hrbfnpr_array view(const std::vector<Vec>& v) {
    return {v.data(), static_cast<std::int64_t>(v.size()), 0, HRBFNPR_SCALAR_FLOAT64, 3};
}

void draw_torus(int width, int height) {
    const double turn = 6.283185307179586;
    std::vector<Vec> points, normals;
    for (int i = 0; i < 192; ++i) {
        const double a = turn * (i / 8) / 24, b = turn * (i % 8) / 8;
        const Vec n = {std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
        normals.push_back(n);
        points.push_back({std::cos(a) + 0.4 * n[0], std::sin(a) + 0.4 * n[1], 0.4 * n[2]});
    }

    // Samples become a smooth surface ...
    const auto context = make<hrbfnpr_context>(hrbfnpr_context_release,
                                               [&](auto out) { return hrbfnpr_context_create(nullptr, out, &error); });
    auto fit = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
    fit.points = view(points);
    fit.normals = view(normals);
    const auto model = make<hrbfnpr_model>(
        hrbfnpr_model_release, [&](auto out) { return hrbfnpr_model_fit(context.get(), &fit, nullptr, out, &error); });

    // ... on which the marks of a style are placed ...
    hrbfnpr_style style;
    auto generate = defaults<hrbfnpr_generate_desc>(hrbfnpr_generate_desc_init);
    check(hrbfnpr_style_init_preset(&style, sizeof style, HRBFNPR_PRESET_CROSS_HATCH, &error));
    generate.layers = hrbfnpr_preset_layers(HRBFNPR_PRESET_CROSS_HATCH, &generate.layer_count);
    const auto marks = make<hrbfnpr_point_set>(hrbfnpr_point_set_release, [&](auto out) {
        return hrbfnpr_point_set_generate(context.get(), model.get(), &generate, nullptr, out, &error);
    });

    // ... and drawn for a camera.
    auto info = defaults<hrbfnpr_model_info>(hrbfnpr_model_info_init);
    check(hrbfnpr_model_get_info(model.get(), &info, &error));
    const Vec direction = {0, 1, -1}, up = {0, 0, 1};
    auto camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    check(hrbfnpr_camera_fit_bounds(&camera, info.bounds_min, info.bounds_max, direction.data(), up.data(), 0.5, width,
                                    height, 0.02, &error));
    auto item = defaults<hrbfnpr_item>(hrbfnpr_item_init);
    item.point_set = marks.get();
    item.style = &style;
    const auto renderer = make<hrbfnpr_renderer>(
        hrbfnpr_renderer_release, [&](auto out) { return hrbfnpr_renderer_create(context.get(), out, &error); });
    const auto drawing = make<hrbfnpr_drawing>(hrbfnpr_drawing_release, [&](auto out) {
        return hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &camera, out, &error);
    });
    std::vector<std::array<char, 4>> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    auto image = defaults<hrbfnpr_image>(hrbfnpr_image_init);
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = width;
    image.height = height;
    image.pixels = pixels.data();
    check(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, &error));

    std::ofstream file("torus.ppm", std::ios::binary);
    file << "P6 " << width << ' ' << height << " 255\n";
    for (const auto& pixel : pixels) file.write(pixel.data(), 3);
}

int main() {
    try {
        check(hrbfnpr_error_init(&error, sizeof error));
        draw_torus(800, 600);
        return 0;
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
        return 1;
    }
}
