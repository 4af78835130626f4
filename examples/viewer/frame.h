// SPDX-License-Identifier: MIT
// One picture: from marks, a style and a camera to pixels.
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
    std::vector<float> depth;       // 0 near .. 1 far, if it is wanted
    double draw_milliseconds = 0;   // of the library: the drawing ...
    double raster_milliseconds = 0; // ... and its pixels
};

// `tone`: painted tones, may be empty.
void draw_frame(Frame& frame, const Renderer& renderer, const Surface& surface, const Ink& ink,
                const Settings& settings, const PaintedMap& tone, Size size);

} // namespace viewer
