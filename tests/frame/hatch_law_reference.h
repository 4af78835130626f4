// SPDX-License-Identifier: MIT
// A plain reference of the laws of hatching in frame/hatch/loops.cpp: the widths of the lines of each level of a nested
// set that together cover a share of the paper. [Winkenbach & Salesin 1994, "Computer-generated pen-and-ink
// illustration"; Praun et al. 2001, "Real-time hatching": lines of a lighter tone stay in a darker one]
#pragma once

#include "frame/scene/style.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::testing::law {

using frame::LayerStyle;

// Maps darkness to coverage, both from 0 to 1. The curve is a little hollow, since ink spreads and dark tones close up.
// It is within 0.00014 of x to the power of 1.1: x times a polynomial of its root, which takes far less time.
inline constexpr std::array<float, 5> hollow = {0.5399F, 1.1747F, -1.5068F, 1.1364F, -0.3442F};
[[nodiscard]] inline float hollowed(float x) noexcept {
    return x * ((hollow[0] + hollow[2] * x + hollow[4] * (x * x)) + std::sqrt(x) * (hollow[1] + hollow[3] * x));
}

// The coverage for a darkness. Below the darkness at which lines begin, the coverage falls evenly to 0 over the style's
// fade. Without a fade it is that at the beginning.
[[nodiscard]] inline float hatch_coverage(const LayerStyle& style, float darkness) noexcept {
    const float fade = std::min(style.hatch_fade, style.hatch_tone_begin);
    const float below = style.hatch_tone_begin - darkness;
    if (below > 0.0F && fade > 0.0F)
        return style.share * style.hatch_coverage_begin * std::max(1.0F - below / fade, 0.0F);
    const float span = style.hatch_tone_end - style.hatch_tone_begin;
    const float at = std::clamp((darkness - style.hatch_tone_begin) / span, 0.0F, 1.0F);
    return style.share *
           (style.hatch_coverage_begin + (style.hatch_coverage_end - style.hatch_coverage_begin) * hollowed(at));
}

// The lines at one place: those of levels up to `full` are `width` wide, those of the next level `fading`, in pixels.
struct HatchWidths {
    float lambda = 0.0F; // number of levels for which there is room
    std::int32_t full = 0;
    float width = 0.0F;
    float fading = 0.0F;
    float margin = 0.0F; // margin of the level that fades in: the level is drawn if this is positive, and is full at 1
};

// A line that fades in is drawn if its width should be at least this, in pens.
inline constexpr float thinnest_fading = 0.5F;
// Above `thinnest_fading` the width of such a line rises to its full value within this range. Until then the full lines
// have the rest of the ink.
inline constexpr float fading_ramp = 0.25F;
// From this weight on, the margin of the level rises to that of a full line.
inline constexpr float nearly_full = 0.6F;

// `spacing` is the distance of the lines of level 0 in the picture, in pixels; those of levels 0 to k are 2^k times as
// close. `gap` is the factor by which lines are really farther apart; levels come and go without it.
[[nodiscard]] inline HatchWidths hatch_widths(const LayerStyle& style, float coverage, float spacing,
                                              std::int32_t levels, float gap = 1.0F) noexcept {
    const float wanted = std::max(style.hatch_spacing, style.hatch_pen / coverage);
    HatchWidths widths;
    if (spacing > wanted) widths.lambda = std::min(std::log2(spacing / wanted), static_cast<float>(levels));
    widths.full = static_cast<std::int32_t>(widths.lambda);
    const float weight = widths.lambda - static_cast<float>(widths.full); // 0 at the finest level
    const float period = gap * spacing / static_cast<float>(1U << static_cast<unsigned>(widths.full));
    // A period has (1 + weight) full lines. Lines that are closer together than asked are thinner than the pen.
    const float lines = 1.0F + weight;
    const float ink =
        std::min(coverage * period, std::max(period - lines * style.hatch_white, lines * style.hatch_pen));
    const float next = weight * ink / lines;
    widths.margin = next / style.hatch_pen - thinnest_fading;
    const float rise = std::max((weight - nearly_full) / (1.0F - nearly_full), 0.0F);
    widths.margin += rise * std::max(1.0F - widths.margin, 0.0F);
    widths.fading = next * std::clamp(widths.margin / fading_ramp, 0.0F, 1.0F);
    widths.width = ink - widths.fading;
    return widths;
}

// The width of a line of this level.
[[nodiscard]] inline float hatch_width(const HatchWidths& widths, std::int32_t level) noexcept {
    return level <= widths.full ? widths.width : level == widths.full + 1 ? widths.fading : 0.0F;
}

// Positive if a line of this level is drawn, and continuous where it begins.
[[nodiscard]] inline float level_margin(const HatchWidths& widths, std::int32_t level) noexcept {
    if (level <= widths.full) return 1.0F;
    if (level == widths.full + 1) return widths.margin;
    return widths.lambda - static_cast<float>(level - 1) - thinnest_fading;
}

} // namespace hrbfnpr::testing::law
