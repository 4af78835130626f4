// SPDX-License-Identifier: MIT
// A picture from the window's camera, as pixels.
#pragma once

#include "scene.h"

namespace viewer {

struct Frame {
    Drawing drawing;
    hrbfnpr_camera camera{};
    hrbfnpr_drawing_info info{};
    Size size;
    std::vector<std::uint8_t> pixels; // RGBA, rows from the top
    bool wants_depth = false;
    std::vector<float> depth;       // 0 near .. 1 far; filled on request
    double draw_milliseconds = 0;   // the library's time for the drawing
    double raster_milliseconds = 0; // the library's time for the pixels
};

void draw_frame(Frame& frame, const Scene& scene, const hrbfnpr_camera& camera);

} // namespace viewer
