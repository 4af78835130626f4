// SPDX-License-Identifier: MIT
// The time that the rasteriser takes per pixel of a stroke's length, against a row of discs along the same curves.
#pragma once

#include "calls.h"
#include "painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bench {

inline constexpr int raster_width = 1280;
inline constexpr int raster_height = 720;
inline constexpr double raster_radius = 1.2; // pixels

// Makes `count` waves across the picture, one below the other, with marks `step` pixels apart.  A pixel is a unit.
[[nodiscard]] inline scenes::PointSet waves(hrbfnpr_context* context, int count, double step) {
    std::vector<double> position;
    std::vector<double> normal;
    std::vector<std::uint32_t> first{0};
    for (int wave = 0; wave < count; ++wave) {
        const double middle = raster_height * ((wave + 0.5) / count - 0.5);
        for (double at = -0.5 * raster_width; at <= 0.5 * raster_width; at += step / 1.25) {
            position.insert(position.end(), {at, middle + 20.0 * std::sin(0.05 * at + wave), 0.0});
            normal.insert(normal.end(), {0.0, 0.0, 1.0});
        }
        first.push_back(static_cast<std::uint32_t>(position.size() / 3));
    }
    const auto marks = static_cast<std::int64_t>(position.size() / 3);
    auto layer = scenes::made(hrbfnpr_layer_arrays_init);
    layer.position = {position.data(), marks, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    layer.normal = {normal.data(), marks, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    layer.stroke_first = {first.data(), static_cast<std::int64_t>(first.size()), 0, HRBFNPR_SCALAR_UINT32, 1};
    auto desc = scenes::made(hrbfnpr_point_set_desc_init);
    desc.layers = &layer;
    desc.layer_count = 1;
    scenes::Check check;
    hrbfnpr_point_set* set = nullptr;
    check(hrbfnpr_point_set_create(context, &desc, &set, check.error()));
    return scenes::PointSet(set);
}

// Returns the total length of the waves, in pixels.
[[nodiscard]] inline double length_of_waves(int count) {
    double sum = 0.0;
    for (int wave = 0; wave < count; ++wave)
        for (double at = -0.5 * raster_width; at < 0.5 * raster_width; at += 1.0)
            sum += std::hypot(1.0, 20.0 * (std::sin(0.05 * (at + 1.0) + wave) - std::sin(0.05 * at + wave)));
    return sum;
}

[[nodiscard]] inline hrbfnpr_camera raster_camera() {
    scenes::Check check;
    auto camera = scenes::made(hrbfnpr_camera_init);
    const double eye[3] = {0.0, 0.0, 5.0};
    const double target[3] = {0.0, 0.0, 0.0};
    const double up[3] = {0.0, 1.0, 0.0};
    check(hrbfnpr_camera_look_at(&camera, eye, target, up, check.error()));
    check(hrbfnpr_camera_orthographic(&camera, raster_height, raster_width, raster_height, 1.0, 10.0, check.error()));
    return camera;
}

[[nodiscard]] inline Style raster_style(std::uint32_t shape) {
    Style style(HRBFNPR_PRESET_STIPPLE);
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    style.tone = HRBFNPR_TONE_NONE;
    style.layer.resize(1);
    style.layer[0] = scenes::made(hrbfnpr_layer_style_init);
    style.layer[0].shape = shape;
    style.layer[0].radius = static_cast<float>(raster_radius);
    return style;
}

struct RasterTimes {
    double stroke_ns = 0.0, disc_ns = 0.0; // per pixel of length: the least of all runs
};

// The pictures of `count` waves.
class RasterPictures {
public:
    RasterPictures(hrbfnpr_context* context, int count)
        : pixels_(length_of_waves(count)), sparse_(waves(context, count, 4.0)),
          dense_(waves(context, count, 0.5 * raster_radius)),
          empty_(context, sparse_.get(), nothing(), raster_width, raster_height),
          strokes_(context, sparse_.get(), raster_style(HRBFNPR_SHAPE_STROKES), raster_width, raster_height),
          discs_(context, dense_.get(), raster_style(HRBFNPR_SHAPE_DOTS), raster_width, raster_height) {}

    void run(const hrbfnpr_camera& camera) {
        std::size_t which = 0;
        for (Painter* const painter : {&empty_, &strokes_, &discs_}) {
            painter->draw(camera);
            least_[which] = std::min(least_[which], painter->image_ms());
            ++which;
        }
    }
    // Returns times minus the time of an empty picture.
    [[nodiscard]] RasterTimes times() const {
        return {1e6 * (least_[1] - least_[0]) / pixels_, 1e6 * (least_[2] - least_[0]) / pixels_};
    }

private:
    [[nodiscard]] static Style nothing() {
        Style style = raster_style(HRBFNPR_SHAPE_STROKES);
        style.layer[0].shown = 0;
        return style;
    }

    double pixels_;
    scenes::PointSet sparse_, dense_;
    Painter empty_, strokes_, discs_;
    std::array<double, 3> least_{1e9, 1e9, 1e9};
};

} // namespace bench
