// SPDX-License-Identifier: MIT
// Laws of tone: which marks are drawn as ink.                                    [NPAR 6.2]
#pragma once

#include "frame/scene/style.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {

// tau = max(0, n . l)^exponent + fill max(0, -n . l)^2: 1 is light, 0 is dark.  The fill light comes from the other
// side.  Its square leaves the terminator dark, and varies where a surface faces it.
[[nodiscard]] inline float light_tone(float n_dot_l, float exponent, float fill = 0.0F) noexcept {
    const float lit = std::clamp(n_dot_l, 0.0F, 1.0F);
    const float away = std::clamp(-n_dot_l, 0.0F, 1.0F);
    return (exponent == 1.0F ? lit : std::pow(lit, exponent)) + fill * away * away;
}

// A style's law of light.
struct LightTone {
    explicit LightTone(const Style& style) noexcept
        : exponent(static_cast<float>(style.tone_exponent)), fill(style.fill()) {}

    [[nodiscard]] float operator()(float n_dot_l) const noexcept { return light_tone(n_dot_l, exponent, fill); }

    float exponent, fill;
};

// tau_d: 1 up to depth_min, 0 from depth_max on, falling with the logarithm between.
[[nodiscard]] inline float depth_tone(double distance, double depth_min, double depth_max) noexcept {
    if (!(distance > depth_min)) return 1.0F;
    const double tone = 1.0 - std::log(distance / depth_min) / std::log(depth_max / depth_min);
    return static_cast<float>(std::clamp(tone, 0.0, 1.0));
}

// Share of the marks that is shown at a zoom below the reference's.
[[nodiscard]] inline float zoom_scale(float zoom, float exponent) noexcept {
    return zoom >= 1.0F ? 1.0F : std::pow(std::max(zoom, 0.0F), exponent);
}

enum class Verdict : std::uint8_t { shown = 0, tone = 1, zoom = 2, depth = 3 }; // shown, or dropped by what

struct ToneTerms {
    float tau = 0.0F;       // light
    float tau_depth = 1.0F; // depth attenuation
    float scale = 1.0F;     // zoom
    float share = 1.0F;     // of the group
};

// u is the mark's rank.  The reason for a drop is the first of share and light, zoom, depth that
// drops it when they act one after the other.
[[nodiscard]] inline Verdict front_verdict(float u, const ToneTerms& t, ToneRule rule) noexcept {
    if (rule == ToneRule::published) {
        if (!(u >= t.tau && u < t.share)) return Verdict::tone;
        if (!(u < t.scale)) return Verdict::zoom;
        return u < t.tau_depth ? Verdict::shown : Verdict::depth;
    }
    float shown = (1.0F - t.tau) * t.share;
    if (!(u >= 1.0F - shown)) return Verdict::tone;
    shown *= t.scale;
    if (!(u >= 1.0F - shown)) return Verdict::zoom;
    return u >= 1.0F - shown * t.tau_depth ? Verdict::shown : Verdict::depth;
}

[[nodiscard]] inline bool silhouette_shown(float u, float tau_depth, ToneRule rule) noexcept {
    return rule == ToneRule::published ? u < tau_depth : u >= 1.0F - tau_depth;
}

} // namespace hrbfnpr::frame
