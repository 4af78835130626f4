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

void draw_frame(Frame& frame, const Scene& scene, const hrbfnpr_camera& camera) {
    frame.size = {static_cast<int>(camera.viewport[2]), static_cast<int>(camera.viewport[3])};
    frame.camera = camera;
    frame.drawing.reset(); // the next drawing reuses its memory
    const Stopwatch drawing;
    frame.drawing = make<hrbfnpr_drawing>(hrbfnpr_drawing_release, [&](auto** out, auto* error) {
        return hrbfnpr_picture_draw(scene.picture.get(), &camera, nullptr, out, error);
    });
    frame.draw_milliseconds = drawing.milliseconds();
    const Stopwatch pixels;
    rasterize(frame);
    frame.raster_milliseconds = pixels.milliseconds();
    frame.info = defaults<hrbfnpr_drawing_info>(hrbfnpr_drawing_info_init);
    checked([&](auto* error) { return hrbfnpr_drawing_get_info(frame.drawing.get(), &frame.info, error); });
}

} // namespace viewer
