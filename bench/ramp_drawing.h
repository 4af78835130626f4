// SPDX-License-Identifier: MIT
// The tone ramp as the library draws it, on the plane z = 0 from (-2, -1) to (2, 1).
#pragma once

#include "calls.h"
#include "tone_ramp.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace bench {

// Returns the column of a world position.
[[nodiscard]] inline double ramp_column(float x) { return (double{x} + 2.0) / 4.0 * ramp_width; }

inline constexpr double ramp_radius = 1.5; // radius of the marks, pixels

// Draws black discs on white; `tone` gives the share of marks.
[[nodiscard]] inline Style ramp_style(hrbfnpr_tone_fn tone) {
    Style style(HRBFNPR_PRESET_STIPPLE);
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    style.tone = HRBFNPR_TONE_CALLBACK;
    style.tone_function = tone;
    style.layer.resize(1); // only the stipples
    hrbfnpr_layer_style& ink = style.layer[0];
    ink.radius = static_cast<float>(ramp_radius);
    ink.radius_zoom = 0.0F;
    for (std::size_t c = 0; c < 4; ++c) {
        ink.ink[c] = c == 3 ? 1.0F : 0.0F;
        style.paper[c] = 1.0F;
    }
    return style;
}

// Returns the ink of each pixel. The plane is tilted around the x axis, so that n . v is `facing`.
[[nodiscard]] inline std::vector<double> drawn_ramp(hrbfnpr_context* context, const hrbfnpr_point_set* set, Style style,
                                                    double facing = 1.0) {
    scenes::Check check;
    hrbfnpr_camera camera;
    check(hrbfnpr_camera_init(&camera, sizeof camera));
    const Vec3 eye{0.0, -20.0 * std::sqrt(1.0 - facing * facing), 20.0 * facing};
    const Vec3 target{0.0, 0.0, 0.0};
    const Vec3 up{0.0, 1.0, 0.0};
    check(hrbfnpr_camera_look_at(&camera, eye.data(), target.data(), up.data(), check.error()));
    check(hrbfnpr_camera_orthographic(&camera, 2.0, ramp_width, ramp_height, 1.0, 40.0, check.error()));
    hrbfnpr_item item;
    check(hrbfnpr_item_init(&item, sizeof item));
    item.point_set = set;
    item.style = style.get();
    hrbfnpr_renderer* raw = nullptr;
    check(hrbfnpr_renderer_create(context, &raw, check.error()));
    const scenes::Renderer renderer(raw);
    hrbfnpr_drawing* drawn = nullptr;
    check(hrbfnpr_renderer_draw(raw, &item, 1, 0, &camera, &drawn, check.error()));
    const scenes::Drawing drawing(drawn);
    std::vector<std::uint8_t> pixels(std::size_t{4} * ramp_width * ramp_height);
    hrbfnpr_image image;
    check(hrbfnpr_image_init(&image, sizeof image));
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = ramp_width;
    image.height = ramp_height;
    image.pixels = pixels.data();
    check(hrbfnpr_drawing_rasterize(drawn, &image, nullptr, check.error()));
    std::vector<double> ink(pixels.size() / 4);
    for (std::size_t i = 0; i < ink.size(); ++i) ink[i] = 1.0 - pixels[4 * i] / 255.0;
    return ink;
}

// Returns how many blue-noise stipples would cover the share `coverage` without overlap, on the picture and the part of
// the plane around it.
[[nodiscard]] inline std::int64_t ramp_budget(hrbfnpr_context* context, const hrbfnpr_model* plane, double coverage) {
    constexpr double pi = 3.14159265358979323846;
    constexpr std::int64_t few = 4000;
    const double spacing = info_of(generate(context, plane, one_layer(HRBFNPR_LAYER_KIND_STIPPLES, few)).get()).spacing;
    const double wide = spacing * ramp_width / 4.0; // pixels
    return static_cast<std::int64_t>(coverage / (pi * ramp_radius * ramp_radius) * wide * wide * few);
}

} // namespace bench
