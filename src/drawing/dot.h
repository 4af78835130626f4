// SPDX-License-Identifier: MIT
// Defines the parts of a drawing: dots and strokes of ink, and the splats of the surfaces that they lie on. Positions
// are window coordinates: pixels from the picture's top-left corner, and window depth in the camera's convention.
#pragma once

#include "geometry/vec.h"

#include <cstdint>

namespace hrbfnpr::drawing {

// The values equal the constants HRBFNPR_DEPTH_*.
enum class DepthConvention : std::uint32_t { negative_one_to_one = 0, zero_to_one = 1, reversed = 2 };

// Returns the window depth of the far plane, which empty pixels have.
[[nodiscard]] constexpr float far_depth(DepthConvention depth) noexcept {
    return depth == DepthConvention::reversed ? 0.0F : 1.0F;
}
// Returns whether window depth a is in front of b. The result is false if a or b is NaN.
[[nodiscard]] constexpr bool nearer(float a, float b, DepthConvention depth) noexcept {
    return depth == DepthConvention::reversed ? a > b : a < b;
}

struct Window {
    glm::dvec4 viewport{0.0}; // x and y of the top-left corner, width, height; pixels
    DepthConvention depth = DepthConvention::negative_one_to_one;
};

// How the surface at a mark faces: towards the camera, away from it, or near a contour [NPAR 6]. `none` means that
// there is no mark, or that it is outside the picture. The values equal the constants HRBFNPR_CLASS_*.
enum class MarkClass : std::uint8_t { none = 0, front = 1, back = 2, silhouette = 3 };

// Dots with a radius below `smallest_radius` are drawn with that radius, but paler. All rims fade over one pixel:
// `soft_rim` on either side of the rim. Both are in pixels.
inline constexpr float smallest_radius = 0.5F;
inline constexpr float soft_rim = 0.5F;

// A disc of ink, or of paper.
struct Dot {
    float x, y;   // in pixels
    float radius; // pixels
    // For ink, it multiplies the opacity of the layer's ink; for paper, it is the alpha; 0: not drawn.
    float opacity;
    float depth;           // depth along the view direction, in units of eye coordinates
    float window;          // window depth in the camera's convention
    float pixels_per_unit; // pixels per unit of eye coordinates at the depth of the dot
    std::uint32_t id;      // 1 + the index of the mark among all marks of the drawing
    std::uint32_t layer;   // index of the dot's layer in the drawing
    MarkClass mark_class;
    std::uint8_t flags;   // a combination of the bits dot_* below
    std::uint8_t ink = 0; // while a frame is made: the number of the dot's ink among those of its run
};
inline constexpr std::uint8_t dot_faces_back = 1;
inline constexpr std::uint8_t dot_is_exact = 2; // the model itself, and not depth layers, decides what hides the dot
inline constexpr std::uint8_t dot_is_paper = 4;
// Ink whose opacity is below this would not change a pixel.
inline constexpr float faintest_ink = 1.0F / 512.0F;

// The end of a stroke. `round` adds half a disc around the last point. `flat` cuts the stroke at that point. `pointed`
// adds a straight tip, whose length is point_length times the stroke's width there.
enum class Cap : std::uint8_t { round = 0, flat = 1, pointed = 2 };
inline constexpr float point_length = 2.0F;

// A line through consecutive points of the drawing. It has the class of its layer. The outer side of each turn is
// round.
struct Stroke {
    std::int64_t first = 0; // index of its first point in the drawing
    std::int32_t count = 0; // number of its points, at least 2
    std::uint32_t layer = 0;
    // Depth of the stroke's middle along the view direction, in units of eye coordinates; strokes are painted from far
    // to near.
    float depth = 0.0F;
    Cap cap_begin = Cap::round;
    Cap cap_end = Cap::round;
    // Whether the last point coincides with the first and is joined to it. A closed stroke has no caps.
    bool closed = false;
    // The next three members are set only for strokes of lines. `line` is a number of the line that is the same in all
    // frames. `hidden_layers` is the number of surface layers in front of the stroke. `hidden_by` is the item of the
    // nearest of these layers, or -1 if no layer hides the stroke.
    std::uint32_t line = 0;
    std::int32_t hidden_layers = 0;
    std::int32_t hidden_by = -1;
};

// A point of a stroke. Between two points, centre, half width and opacity are interpolated linearly.
struct StrokePoint {
    float x, y;            // in pixels
    float radius;          // half the width, in pixels
    float opacity;         // multiplies the opacity of the layer's ink
    float depth;           // depth along the view direction, in units of eye coordinates
    float window;          // window depth in the camera's convention
    float pixels_per_unit; // pixels per unit of eye coordinates at the depth of the point
    float length;          // length along the stroke from its first point to this one, in pixels
    std::uint32_t id;      // 1 + the index of the mark among all marks of the drawing; 0 for points of lines
};

// A disc of surface around a mark, which the camera sees as an ellipse. Depth layers are computed from splats.
struct Splat {
    float x, y;             // in pixels
    float radius;           // radius of the disc without foreshortening, in pixels
    float depth;            // depth along the view direction, in units of eye coordinates
    float slope_x, slope_y; // change of the surface's depth across the picture, in eye units per pixel
    float pixels_per_unit;  // pixels per unit of eye coordinates at the depth of the splat
    float transmittance;    // the share of the ink behind the splat that remains visible
    float window;           // window depth in the camera's convention
    // The halo is a disc of this radius in pixels around the nearest point of the contour. If it is 0, no contour is
    // near, and the other halo members are not used.
    float halo;
    float halo_transmittance;
    float halo_x, halo_y, halo_depth;
    float halo_slope_x, halo_slope_y; // change of the contour's depth along it, in eye units per pixel
    std::uint32_t id;
    bool faces_back;
};

// The largest slope of depth layers, as depth per length perpendicular to the view direction. The ellipses of steeper
// splats would be so thin that they fall between pixels.
inline constexpr float steepest_slope = 4.0F;

} // namespace hrbfnpr::drawing
