// SPDX-License-Identifier: MIT
// Laws of hidden lines: how much paper a mark paints over the ink beyond it, and how much a layer of surface lets
// through.                                                                                                  [NPAR 6.1]
#pragma once

#include "base/assert.h"
#include "base/bits.h"
#include "frame/scene/style.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace hrbfnpr::frame {

// nu = n . v, v from the camera to the mark: it is negative in front.
[[nodiscard]] inline float front_alpha(float nu, float lambda) noexcept {
    return std::clamp(nu * nu * lambda, 0.0F, 1.0F);
}

// The logarithm is the natural one, and the law ends where it does: it is 0 for nu <= 0.05.
[[nodiscard]] inline float back_alpha(float nu, float lambda) noexcept {
    if (!(nu > 0.05F)) return 0.0F;
    return std::clamp(0.2F * (std::log(nu - 0.05F) + 5.0F) * lambda, 0.0F, 1.0F);
}

// How many discs of a layer overlap at a pixel: a disc's area over the screen area of a mark's piece of surface, which
// shrinks with |nu|. radius and spacing are in pixels.
[[nodiscard]] inline float expected_overlap(float radius, float spacing, float nu) noexcept {
    const float piece = spacing * spacing * std::max(std::abs(nu), 0.01F);
    return piece > 0.0F ? std::max(1.0F, std::numbers::pi_v<float> * radius * radius / piece) : 1.0F;
}

// The opacity of each of `overlap` discs that together are as opaque as `layers` of opacity alpha:
// (1 - opacity)^overlap = (1 - alpha)^layers. With layers = 0 it is alpha itself, as published.
[[nodiscard]] inline float disc_opacity(float alpha, float layers, float overlap) noexcept {
    if (!(layers > 0.0F) || alpha >= 1.0F) return alpha;
    return -std::expm1(std::log1p(-alpha) * layers / overlap);
}

// The transmittance of an item's layer. Ink that a solid hides lies beyond two layers, one that faces the eye and one
// that faces away. A surface that is drawn on both sides may be the only one there: it hides like both.
[[nodiscard]] inline float layer_transmittance(const Style& style, float nu, bool both_sides) noexcept {
    if (style.hidden_lines == HiddenLines::show) return 1.0F;
    if (style.hidden_lines == HiddenLines::hide) return 0.0F;
    const auto left_by = [&](float alpha) {
        return style.splat_overlap > 0.0F ? std::pow(1.0F - alpha, style.splat_overlap) : 1.0F - alpha;
    };
    const float angle = std::abs(nu);
    float transmittance = 1.0F;
    if (nu > 0.0F || both_sides)
        transmittance *= left_by(back_alpha(angle, static_cast<float>(style.attenuation_back)));
    if (!(nu > 0.0F) || both_sides)
        transmittance *= left_by(front_alpha(-angle, static_cast<float>(style.attenuation_front)));
    return transmittance;
}

// A transmittance has its item in the lowest bits, where no pixel shows it: planes of items would take as long to lay
// as planes of depths. Items that agree in these bits are taken for one.
inline constexpr std::uint32_t item_bits = 15;
[[nodiscard]] inline std::uint32_t bits_of_item(std::int32_t item) noexcept {
    return static_cast<std::uint32_t>(item) & item_bits;
}
[[nodiscard]] inline std::uint32_t item_of(float transmittance) noexcept {
    return base::bit_cast<std::uint32_t>(transmittance) & item_bits;
}
// The nearest number with the item's bits that is not above 1.
[[nodiscard]] inline float with_item(float transmittance, std::int32_t item) noexcept {
    HRBFNPR_ASSERT(transmittance >= 0.0F && transmittance <= 1.0F);
    const std::uint32_t own = bits_of_item(item);
    const auto bits = base::bit_cast<std::uint32_t>(transmittance);
    if (bits <= item_bits) return base::bit_cast<float>(own);
    const std::uint32_t with = ((bits + item_bits / 2 - own) & ~item_bits) + own;
    return base::bit_cast<float>(with > base::bit_cast<std::uint32_t>(1.0F) ? with - item_bits - 1 : with);
}

} // namespace hrbfnpr::frame
