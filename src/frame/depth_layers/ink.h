// What a frame by layers is made of: ink, and the splats that its layers are found from.
#pragma once

#include "frame/scene/mark_class.h"

#include <cstdint>

namespace hrbfnpr::frame {

// Smaller discs are not drawn smaller, but paler; and all have a rim that falls off over a pixel.
inline constexpr float smallest_radius = 0.5F;
inline constexpr float soft_rim = 0.5F;

// A disc of ink.
struct Ink {
    float x, y;            // pixels
    float radius;          // pixels
    float alpha;           // what the layers in front let through of it; 0: not drawn
    float depth;           // eye units along the view; of a contour its own, not the mark's
    float window;          // depth in the camera's convention
    float pixels_per_unit; // pixels per eye unit
    std::uint32_t id;
    std::uint32_t color; // 2 * run, plus 1 for a contour's
    MarkClass mark_class;
    std::uint8_t flags;           // ink_...
    std::int8_t probe_x, probe_y; // from its place to where it is asked what hides it, 1 / probe_steps pixels
};
inline constexpr float probe_steps = 16.0F;
inline constexpr std::uint8_t ink_faces_back = 1;
inline constexpr std::uint8_t ink_is_exact = 2; // what hides it is asked of its model, not of the layers
// Fainter ink would not change a pixel.
inline constexpr float faintest_ink = 1.0F / 512.0F;

// A round piece of a layer, seen as an ellipse.
struct Splat {
    float x, y;             // pixels
    float radius;           // of the disc in space, pixels
    float depth;            // eye units along the view
    float slope_x, slope_y; // of the layer: eye units of depth per pixel
    float pixels_per_unit;
    float transmittance; // what the layer lets through
    float window;
    // Pixels around the nearest place of the contour; 0: none, and the rest does not count.
    float halo;
    float halo_transmittance;
    float halo_x, halo_y, halo_depth;
    float halo_slope_x, halo_slope_y; // of the contour: eye units of depth per pixel along it
    std::uint32_t id;
    bool faces_back;
};

// Layers are not taken as steeper than this, depth over pixels: their ellipses would fall between pixels.
inline constexpr float steepest = 4.0F;

} // namespace hrbfnpr::frame
