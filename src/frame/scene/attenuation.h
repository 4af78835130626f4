// SPDX-License-Identifier: MIT
// Laws of hidden-line attenuation: how much paper a mark paints over what lies behind.  [NPAR 6.1]
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::frame {

// nu = n . v, v from the camera to the mark: negative in front.
[[nodiscard]] inline float front_alpha(float nu, float lambda) noexcept {
    return std::clamp(nu * nu * lambda, 0.0F, 1.0F);
}

// The logarithm is the natural one, and the law ends where it does: 0 for nu <= 0.05.
[[nodiscard]] inline float back_alpha(float nu, float lambda) noexcept {
    if (!(nu > 0.05F)) return 0.0F;
    return std::clamp(0.2F * (std::log(nu - 0.05F) + 5.0F) * lambda, 0.0F, 1.0F);
}

// How many discs of a layer overlap at a pixel: disc area over the screen area of a mark's piece of
// surface, which shrinks with |nu|.  radius and spacing in pixels.
[[nodiscard]] inline float expected_overlap(float radius, float spacing, float nu) noexcept {
    const float piece = spacing * spacing * std::max(std::abs(nu), 0.01F);
    return piece > 0.0F ? std::max(1.0F, std::numbers::pi_v<float> * radius * radius / piece) : 1.0F;
}

// The opacity of each of `overlap` discs that together are as opaque as `layers` of opacity alpha:
// (1 - opacity)^overlap = (1 - alpha)^layers.  layers = 0: alpha itself, as published.
[[nodiscard]] inline float disc_opacity(float alpha, float layers, float overlap) noexcept {
    if (!(layers > 0.0F) || alpha >= 1.0F) return alpha;
    return -std::expm1(std::log1p(-alpha) * layers / overlap);
}

} // namespace hrbfnpr::frame
