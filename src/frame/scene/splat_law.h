// SPDX-License-Identifier: MIT
// How opaque a layer of surface is, and how far apart the marks are that it is found from.     [NPAR 6.1]
#pragma once

#include "base/bits.h"
#include "frame/scene/attenuation.h"
#include "frame/scene/style.h"

namespace hrbfnpr::frame {

// A halo is as dark as a layer that turns away by this n . v.
inline constexpr float halo_angle = 0.25F;
// A halo's contour is nearer than what it cuts by so many pixels.
inline constexpr float halo_gap = 4.0F;

// What a layer of this item lets through of what lies behind.  What a solid hides lies behind two layers, one that
// faces the eye and one that faces away.  Of a surface that is drawn on both sides only one may lie there: it hides
// like both.
[[nodiscard]] inline float layer_transmittance(const Style& style, float nu, bool both_sides) noexcept {
    if (style.hidden_lines == HiddenLines::show) return 1.0F;
    if (style.hidden_lines == HiddenLines::hide) return 0.0F;
    const auto of = [&](float alpha) {
        return style.splat_overlap > 0.0F ? std::pow(1.0F - alpha, style.splat_overlap) : 1.0F - alpha;
    };
    const float angle = std::abs(nu);
    float transmittance = 1.0F;
    if (nu > 0.0F || both_sides) transmittance *= of(back_alpha(angle, static_cast<float>(style.attenuation_back)));
    if (!(nu > 0.0F) || both_sides)
        transmittance *= of(front_alpha(-angle, static_cast<float>(style.attenuation_front)));
    return transmittance;
}

// What a layer lets through has its item in the lowest bits, where no pixel shows it: planes of items would take as
// long to lay as those of depths.  Items that agree in these bits are taken for one.
inline constexpr std::uint32_t item_bits = 15;
// The nearest number with these bits that is not above 1.
[[nodiscard]] inline float of_item(float transmittance, std::int32_t item) noexcept {
    const std::uint32_t own = static_cast<std::uint32_t>(item) & item_bits;
    const auto bits = base::bit_cast<std::uint32_t>(transmittance);
    if (bits <= item_bits) return base::bit_cast<float>(own);
    const std::uint32_t with = ((bits + item_bits / 2 - own) & ~item_bits) + own;
    return base::bit_cast<float>(with > base::bit_cast<std::uint32_t>(1.0F) ? with - item_bits - 1 : with);
}
[[nodiscard]] inline std::uint32_t item_of(float transmittance) noexcept {
    return base::bit_cast<std::uint32_t>(transmittance) & item_bits;
}
[[nodiscard]] inline bool is_of_item(float transmittance, std::int32_t item) noexcept {
    return item_of(transmittance) == (static_cast<std::uint32_t>(item) & item_bits);
}

// Pixels between the marks that stand for a layer where there are enough of them, and near its contour.
inline constexpr float splat_spacing = 6.0F;
inline constexpr float contour_splat_spacing = 4.0F;
// Their discs' radius, in spacings, without half a pixel: a blue-noise order leaves no place farther than 0.8 from a
// mark; marks at random leave one place in two thousand.
inline constexpr float even_splat = 0.85F;
inline constexpr float random_splat = 1.6F;
} // namespace hrbfnpr::frame
