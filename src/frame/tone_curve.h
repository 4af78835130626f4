// How much ink a tone takes: from coverage to ink per area, discs that overlap counted twice.
#pragma once

#include "frame/ink.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::frame {

// How the marks of an item lie.
enum class Overlap : unsigned char {
    random,     // anywhere: coverage = 1 - exp(-x)
    blue_noise, // apart from each other: measured
    lines       // evenly spaced lines in so many layers
};

// Ink per area x of a blue-noise order whose discs cover 0, 1/16, 2/16 ... of it: measured on a flat patch, over
// prefixes of 5 to 100 % and radii of 1 to 3 pixels (docs/quality.md).
inline constexpr std::array<float, 17> blue_noise_ink = {0.0F,    0.0625F, 0.1250F, 0.1875F, 0.2500F, 0.3125F,
                                                         0.3755F, 0.4400F, 0.5068F, 0.5772F, 0.6528F, 0.7362F,
                                                         0.8318F, 0.9479F, 1.1005F, 1.3370F, 3.0000F};

// The ink of a disc as it is drawn, square pixels: its rim falls off over a pixel, and below half a pixel of radius it
// gets paler instead of smaller.
[[nodiscard]] inline float disc_ink(float radius) noexcept {
    constexpr float pi = 3.14159265F;
    const float drawn = std::max(radius, smallest_radius);
    const float dimmed = radius / drawn;
    return pi * (drawn * drawn + 1.0F / 12.0F) * dimmed * dimmed;
}

// coverage in [0, 1]; at 1 the result is large.  layers: 1, 2 or 3.
[[nodiscard]] inline float ink_for(float coverage, Overlap overlap, float layers) noexcept {
    const float left = std::max(1.0F - coverage, 1e-4F);
    switch (overlap) {
    case Overlap::random: return -std::log(left);
    case Overlap::lines:
        return layers == 1.0F ? coverage : layers * (1.0F - (layers == 2.0F ? std::sqrt(left) : std::cbrt(left)));
    case Overlap::blue_noise: break;
    }
    const float at = std::clamp(coverage, 0.0F, 1.0F) * 16.0F;
    const auto cell = static_cast<std::size_t>(std::min(at, 15.0F));
    const float part = at - static_cast<float>(cell);
    return blue_noise_ink[cell] + (blue_noise_ink[cell + 1] - blue_noise_ink[cell]) * part;
}

} // namespace hrbfnpr::frame
