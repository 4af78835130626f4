// SPDX-License-Identifier: MIT
// The parts of a drawing: dots and strokes of ink, and the splats of the surfaces that they lie on. Their places are
// window coordinates: pixels from the picture's top-left corner, and depth in the camera's convention.
#pragma once

#include "geometry/vec.h"

#include <cstdint>

namespace hrbfnpr::drawing {

// The numbers are those of the constants HRBFNPR_DEPTH.
enum class DepthConvention : std::uint32_t { negative_one_to_one = 0, zero_to_one = 1, reversed = 2 };

// Window depth of the far plane, which empty pixels have.
[[nodiscard]] constexpr float far_depth(DepthConvention depth) noexcept {
    return depth == DepthConvention::reversed ? 0.0F : 1.0F;
}
// Whether window depth a lies in front of b.  False if one of them is not a number.
[[nodiscard]] constexpr bool nearer(float a, float b, DepthConvention depth) noexcept {
    return depth == DepthConvention::reversed ? a > b : a < b;
}

struct Window {
    glm::dvec4 viewport{0.0}; // x, y of the top-left corner, width, height, pixels
    DepthConvention depth = DepthConvention::negative_one_to_one;
};

// Whether the surface at a mark faces the camera, faces away or is near a contour [NPAR 6]; none: no mark, or one that
// is not in the picture. The numbers are those of the constants HRBFNPR_CLASS.
enum class MarkClass : std::uint8_t { none = 0, front = 1, back = 2, silhouette = 3 };

// Smaller dots are drawn paler instead of smaller; all have a rim that falls off over a pixel.
inline constexpr float smallest_radius = 0.5F;
inline constexpr float soft_rim = 0.5F;

// A disc of ink, or of paper.
struct Dot {
    float x, y;            // pixels
    float radius;          // pixels
    float opacity;         // factor of the opacity of the layer's ink; for paper, its alpha; 0: not drawn
    float depth;           // eye units along the view
    float window;          // depth in the camera's convention
    float pixels_per_unit; // pixels per eye unit at this depth
    std::uint32_t id;      // 1 + running number of the mark
    std::uint32_t layer;   // number of its layer in the drawing
    MarkClass mark_class;
    std::uint8_t flags; // bits of the constants dot_ below
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
    std::int64_t first = 0; // number of its first point in the drawing
    std::int32_t count = 0; // number of its points, at least 2
    std::uint32_t layer = 0;
    float depth = 0.0F; // depth of its middle, eye units along the view; strokes are painted far to near by it
    Cap cap_begin = Cap::round;
    Cap cap_end = Cap::round;
    bool closed = false; // its last point stands where its first one does, and they are joined: it has no caps
    // Only lines have these: a number that stays the same from frame to frame, the number of surface layers before the
    // stroke, and the item of the nearest such layer; -1: none hides it.
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
    float pixels_per_unit; // pixels per eye unit at this depth
    float length;          // along the stroke from its first point, pixels
    std::uint32_t id;      // 1 + running number of the mark; 0 for points of lines
};

// A round piece of surface around a mark, seen as an ellipse: depth layers are found from these.
struct Splat {
    float x, y;             // pixels
    float radius;           // radius of the disc in space, pixels
    float depth;            // eye units along the view
    float slope_x, slope_y; // slope of the surface's depth over the picture, eye units per pixel
    float pixels_per_unit;  // pixels per eye unit at this depth
    float transmittance;    // share of the ink after it that its depth layer lets through
    float window;           // depth in the camera's convention
    // The halo is a disc of this radius around the nearest place of the contour, pixels. 0: no contour is near, and the
    // other members of the halo are not read.
    float halo;
    float halo_transmittance;
    float halo_x, halo_y, halo_depth;
    float halo_slope_x, halo_slope_y; // slope of the contour's depth along it, eye units per pixel
    std::uint32_t id;
    bool faces_back;
};

// Depth layers count as no steeper than this, depth over pixels: their ellipses would fall between pixels.
inline constexpr float steepest = 4.0F;

} // namespace hrbfnpr::drawing
