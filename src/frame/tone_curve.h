// How much ink a tone takes: from coverage to ink per area, discs that overlap counted twice.
#pragma once

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
inline constexpr std::array<float, 17> blue_noise_ink = {0.0F,   0.063F, 0.126F, 0.190F, 0.254F, 0.320F,
                                                         0.388F, 0.459F, 0.535F, 0.618F, 0.711F, 0.819F,
                                                         0.949F, 1.113F, 1.336F, 1.683F, 2.6F};

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
