// SPDX-License-Identifier: MIT
// The ink that a tone needs, and the ink of a disc.
#pragma once

#include "base/assert.h"
#include "drawing/dot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace hrbfnpr::frame {

// How the marks of an item overlap.
enum class Overlap : unsigned char {
    random,     // at random: coverage = 1 - exp(-x)
    blue_noise, // apart from each other: coverage as in blue_noise_ink
    lines       // evenly spaced lines in some layers
};

// The ink per area at which the discs of a blue-noise order cover 0, 1/16, 2/16 and so on of the area. Measured on a
// flat patch, for the first 5 to 100 % of the marks and radii of 1 to 3 pixels (docs/measurements.md).
inline constexpr std::array<float, 17> blue_noise_ink = {0.0F,    0.0625F, 0.1250F, 0.1875F, 0.2500F, 0.3125F,
                                                         0.3755F, 0.4400F, 0.5068F, 0.5772F, 0.6528F, 0.7362F,
                                                         0.8318F, 0.9479F, 1.1005F, 1.3370F, 3.0000F};

// Returns the ink per area that gives a coverage. Where discs overlap, the ink counts twice. For a coverage of 1 the
// result is large. `layers` is the number of layers of lines on top of each other.
[[nodiscard]] inline float ink_for(float coverage, Overlap overlap, float layers) noexcept {
    HRBFNPR_ASSERT(coverage >= 0.0F && coverage <= 1.0F && (overlap != Overlap::lines || layers >= 1.0F));
    const float left = std::max(1.0F - coverage, 1e-4F);
    if (overlap == Overlap::random) return -std::log(left);
    if (overlap == Overlap::lines) {
        if (layers == 1.0F) return coverage;
        const float root = layers == 2.0F   ? std::sqrt(left)
                           : layers == 3.0F ? std::cbrt(left)
                                            : std::pow(left, 1.0F / layers);
        return layers * (1.0F - root);
    }
    const float at = coverage * 16.0F;
    const auto cell = static_cast<std::size_t>(std::min(at, 15.0F));
    return blue_noise_ink[cell] + (blue_noise_ink[cell + 1] - blue_noise_ink[cell]) * (at - static_cast<float>(cell));
}

// The ink of a disc in square pixels. Its rim fades over a pixel. A disc with a radius below half a pixel becomes paler
// instead of smaller.
[[nodiscard]] inline float disc_ink(float radius) noexcept {
    const float drawn = std::max(radius, drawing::smallest_radius);
    const float dimmed = radius / drawn;
    return std::numbers::pi_v<float> * (drawn * drawn + 1.0F / 12.0F) * dimmed * dimmed;
}

} // namespace hrbfnpr::frame
