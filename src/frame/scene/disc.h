// What a frame has of a mark to draw.
#pragma once

#include "frame/scene/mark_class.h"
#include "geometry/vec.h"

namespace hrbfnpr::frame {

// One disc of ink or of paper, in image space.
struct Disc {
    float x = 0.0F; // pixels, from the image's top-left corner
    float y = 0.0F;
    float radius = 0.0F;   // pixels
    float depth = 0.0F;    // window depth, in the camera's convention
    glm::vec4 color{0.0F}; // straight RGBA; a disc of paper: the paper's RGB, and its opacity alpha
    std::uint32_t id = 0;  // 1 + running number of the mark
    MarkClass mark_class = MarkClass::none;
    bool is_paper = false;
};

} // namespace hrbfnpr::frame
