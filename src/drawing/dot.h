// SPDX-License-Identifier: MIT
// What a drawing is made of: dots and strokes of ink, and the splats of the surfaces that they lie on.
#pragma once

#include "drawing/mark_class.h"

#include <cstdint>

namespace hrbfnpr::drawing {

// Smaller dots are not drawn smaller, but paler; and all have a rim that falls off over a pixel.
inline constexpr float smallest_radius = 0.5F;
inline constexpr float soft_rim = 0.5F;

// A disc of ink, or of paper.
struct Dot {
    float x, y;            // pixels
    float radius;          // pixels
    float opacity;         // times that of the layer's ink; of paper its alpha; 0: not drawn
    float depth;           // eye units along the view
    float window;          // depth in the camera's convention
    float pixels_per_unit; // of eye space
    std::uint32_t id;      // 1 + running number of the mark
    std::uint32_t layer;   // of the drawing
    MarkClass mark_class;
    std::uint8_t flags; // dot_...
};
inline constexpr std::uint8_t dot_faces_back = 1;
inline constexpr std::uint8_t dot_is_exact = 2; // what hides it is asked of its model, not of the depth layers
inline constexpr std::uint8_t dot_is_paper = 4;
// Fainter ink would not change a pixel.
inline constexpr float faintest_ink = 1.0F / 512.0F;

// How a stroke ends: with half a disc around its last point; across that point; or beyond it, straight on, with a tip
// that is point_length times as long as the stroke is wide there.
enum class Cap : std::uint8_t { round = 0, flat = 1, pointed = 2 };
inline constexpr float point_length = 2.0F;

// A line through points of the drawing, in a layer, whose class is the stroke's.  Where it turns it is round outside.
// One with a point at an end does not repeat the point of that end.
struct Stroke {
    std::int64_t first = 0; // of its points
    std::int32_t count = 0; // two and more
    std::uint32_t layer = 0;
    float depth = 0.0F; // of its middle, eye units along the view: strokes are painted by it
    Cap cap_begin = Cap::round;
    Cap cap_end = Cap::round;
    bool closed = false; // its last point stands where its first one does, and they are joined: it has no caps
    // Of lines only: its number, the same from frame to frame; layers of surface before it, and the nearest one's item.
    std::uint32_t line = 0;
    std::int32_t hidden_layers = 0;
    std::int32_t hidden_by = -1;
};

// Between two of its points a stroke's centre, half width and opacity change evenly.
struct StrokePoint {
    float x, y;            // pixels
    float radius;          // half the width, pixels
    float opacity;         // times that of the layer's ink
    float depth;           // eye units along the view
    float window;          // depth in the camera's convention
    float pixels_per_unit; // of eye space
    float length;          // along the stroke from its first point, pixels
    std::uint32_t id;      // of the mark
};

} // namespace hrbfnpr::drawing
