// SPDX-License-Identifier: MIT
// A round piece of surface around a mark, seen as an ellipse: what depth layers are found from.
#pragma once

#include <cstdint>

namespace hrbfnpr::drawing {

struct Splat {
    float x, y;             // pixels
    float radius;           // of the disc in space, pixels
    float depth;            // eye units along the view
    float slope_x, slope_y; // of the surface: eye units of depth per pixel
    float pixels_per_unit;  // of eye space
    float transmittance;    // of the depth layer
    float window;           // depth in the camera's convention
    // Pixels around the nearest place of the contour; 0: none, and the rest does not count.
    float halo;
    float halo_transmittance;
    float halo_x, halo_y, halo_depth;
    float halo_slope_x, halo_slope_y; // of the contour: eye units of depth per pixel along it
    std::uint32_t id;
    bool faces_back;
};

// Depth layers are not taken as steeper than this, depth over pixels: their ellipses would fall between pixels.
inline constexpr float steepest = 4.0F;

} // namespace hrbfnpr::drawing
