// SPDX-License-Identifier: MIT
// What a drawing is made of: dots and strokes of ink, and the splats of the surfaces that they lie on.
#pragma once

#include <cstdint>

namespace hrbfnpr::drawing {

// What a mark is for the camera [NPAR 6]. Same numbers as HRBFNPR_CLASS_...
enum class MarkClass : std::uint8_t { none = 0, front = 1, back = 2, silhouette = 3 };

// Smaller dots are drawn paler instead of smaller; all have a rim that falls off over a pixel.
inline constexpr float smallest_radius = 0.5F;
inline constexpr float soft_rim = 0.5F;

// A disc of ink, or of paper.
struct Dot {
    float x, y;            // pixels
    float radius;          // pixels
    float opacity;         // times the opacity of the layer's ink; the alpha of paper; 0: not drawn
    float depth;           // eye units along the view
    float window;          // depth in the camera's convention
    float pixels_per_unit; // of eye space
    std::uint32_t id;      // 1 + running number of the mark
    std::uint32_t layer;   // of the drawing
    MarkClass mark_class;
    std::uint8_t flags; // dot_...
};
inline constexpr std::uint8_t dot_faces_back = 1;
inline constexpr std::uint8_t dot_is_exact = 2; // its model says what hides it, not the depth layers
inline constexpr std::uint8_t dot_is_paper = 4;
// Fainter ink would not change a pixel.
inline constexpr float faintest_ink = 1.0F / 512.0F;

// A stroke ends with half a disc around its last point, across that point, or with a tip that goes straight on and is
// point_length times as long as the stroke is wide there.
enum class Cap : std::uint8_t { round = 0, flat = 1, pointed = 2 };
inline constexpr float point_length = 2.0F;

// A line through points of the drawing, in a layer, whose class is the stroke's. Its outside is round where it turns.
struct Stroke {
    std::int64_t first = 0; // of its points
    std::int32_t count = 0; // two and more
    std::uint32_t layer = 0;
    float depth = 0.0F; // of its middle, eye units along the view; strokes are painted in the order of it
    Cap cap_begin = Cap::round;
    Cap cap_end = Cap::round;
    bool closed = false; // its last point stands where its first one does, and they are joined: it has no caps
    // Lines have a number, the same from frame to frame, layers of surface before them, and the nearest layer's item.
    std::uint32_t line = 0;
    std::int32_t hidden_layers = 0;
    std::int32_t hidden_by = -1;
};

// Between two of its points a stroke's centre, half width and opacity change evenly.
struct StrokePoint {
    float x, y;            // pixels
    float radius;          // half the width, pixels
    float opacity;         // times the opacity of the layer's ink
    float depth;           // eye units along the view
    float window;          // depth in the camera's convention
    float pixels_per_unit; // of eye space
    float length;          // along the stroke from its first point, pixels
    std::uint32_t id;      // of the mark
};

// A round piece of surface around a mark, seen as an ellipse: depth layers are found from these.
struct Splat {
    float x, y;             // pixels
    float radius;           // of the disc in space, pixels
    float depth;            // eye units along the view
    float slope_x, slope_y; // of the surface: eye units of depth per pixel
    float pixels_per_unit;  // of eye space
    float transmittance;    // of the depth layer
    float window;           // depth in the camera's convention
    // The radius around the nearest place of the contour, pixels; 0: no contour, and the rest is not read.
    float halo;
    float halo_transmittance;
    float halo_x, halo_y, halo_depth;
    float halo_slope_x, halo_slope_y; // of the contour: eye units of depth per pixel along it
    std::uint32_t id;
    bool faces_back;
};

// Depth layers count as no steeper than this, depth over pixels: their ellipses would fall between pixels.
inline constexpr float steepest = 4.0F;

} // namespace hrbfnpr::drawing
