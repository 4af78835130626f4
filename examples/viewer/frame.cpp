// SPDX-License-Identifier: MIT
#include "frame.h"

#include <chrono>

namespace viewer {

namespace {

class Stopwatch {
public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void rasterize(Frame& frame) {
    const auto width = static_cast<std::size_t>(frame.size.width), height = static_cast<std::size_t>(frame.size.height);
    frame.pixels.resize(4 * width * height);
    frame.depth.resize(frame.wants_depth ? width * height : 0);
    auto image = defaults<hrbfnpr_image>(hrbfnpr_image_init);
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = frame.size.width;
    image.height = frame.size.height;
    image.pixels = frame.pixels.data();
    auto desc = defaults<hrbfnpr_raster_desc>(hrbfnpr_raster_desc_init);
    if (frame.wants_depth)
        desc.depth = {frame.depth.data(), static_cast<std::int64_t>(frame.depth.size()), 0, HRBFNPR_SCALAR_FLOAT32, 1};
    checked([&](auto* error) { return hrbfnpr_drawing_rasterize(frame.drawing.get(), &image, &desc, error); });
}

} // namespace

void draw_frame(Frame& frame, const Renderer& renderer, const Surface& surface, const Ink& ink,
                const Settings& settings, const PaintedMap& tone, Size size) {
    frame.size = size;
    frame.camera = camera_of(*settings.view, size);
    const Style style = style_for(settings, size, surface);
    hrbfnpr_style fields = pointed(style);
    PaintedTone painted;
    if (!tone.is_empty()) {
        const Vec light{fields.light[0], fields.light[1], fields.light[2]};
        const bool turns = fields.light_space == HRBFNPR_LIGHT_CAMERA;
        painted = {&tone, unit(turns ? to_world(frame.camera, light) : light), fields.tone_exponent,
                   static_cast<double>(fields.fill_light), fields.tone == HRBFNPR_TONE_LIGHT};
        fields.tone = HRBFNPR_TONE_CALLBACK;
        fields.tone_function = painted_tone;
        fields.tone_user = &painted;
    }
    auto item = defaults<hrbfnpr_item>(hrbfnpr_item_init);
    item.point_set = ink.marks.get();
    item.style = &fields;
    item.line_set = ink.lines.get();
    frame.drawing.reset(); // its memory serves the next one
    const Stopwatch drawing;
    frame.drawing =
        make<hrbfnpr_drawing>([](hrbfnpr_drawing* drawn) { hrbfnpr_drawing_release(drawn); },
                              [&](auto** out, auto* error) {
                                  return hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &frame.camera, out, error);
                              });
    frame.draw_milliseconds = drawing.milliseconds();
    const Stopwatch pixels;
    rasterize(frame);
    frame.raster_milliseconds = pixels.milliseconds();
    frame.info = defaults<hrbfnpr_drawing_info>(hrbfnpr_drawing_info_init);
    checked([&](auto* error) { return hrbfnpr_drawing_get_info(frame.drawing.get(), &frame.info, error); });
}

} // namespace viewer
