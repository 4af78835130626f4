// SPDX-License-Identifier: MIT
// The tones that follow from distance and zoom, and the marks that are drawn for a tone. lighting.h has the tones by
// light. Dots, hatching, lines and published marks all use these functions.                                 [NPAR 6.2]
//
// 1. DepthTone, zoom_scale: the share of the marks that is left at a distance and a zoom.
// 2. front_verdict, silhouette_shown: whether a mark is drawn.
// 3. front_alpha, back_alpha, layer_transmittance: how much marks and layers hide.
#pragma once

#include "base/assert.h"
#include "base/bits.h"
#include "frame/scene/style.h"
#include "frame/scene/tuning.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace hrbfnpr::frame {

// Returns tau_d, which is 1 up to depth_min and 0 from depth_max on. In between, it falls linearly with the logarithm
// of the distance.
[[nodiscard]] inline float depth_tone(double distance, double depth_min, double depth_max) noexcept {
    if (!(distance > depth_min)) return 1.0F;
    const double tone = 1.0 - std::log(distance / depth_min) / std::log(depth_max / depth_min);
    return static_cast<float>(std::clamp(tone, 0.0, 1.0));
}

// How a style makes tone from distance.
struct DepthTone {
    DepthTone(const Style& style, float eye_units_per_world_unit) noexcept
        : depth_min(style.depth_min), depth_max(style.depth_max), eye_per_world(eye_units_per_world_unit),
          is_on(depth_min > 0.0 && depth_max > depth_min) {}

    // Returns the tone. `distance` is in eye units.
    [[nodiscard]] float operator()(float distance) const noexcept {
        return is_on ? depth_tone(static_cast<double>(distance / eye_per_world), depth_min, depth_max) : 1.0F;
    }

    double depth_min, depth_max; // in world units
    float eye_per_world;
    bool is_on;
};

// Returns the share of the marks that is shown at a zoom. The reference view has the zoom 1.
[[nodiscard]] inline float zoom_scale(float zoom, float exponent) noexcept {
    return zoom >= 1.0F ? 1.0F : std::pow(std::max(zoom, 0.0F), exponent);
}

// Whether a mark is shown, or the reason why it is not.
enum class Verdict : std::uint8_t { shown = 0, tone = 1, zoom = 2, depth = 3 };

struct ToneTerms {
    float tau = 0.0F;       // the tone by light
    float tau_depth = 1.0F; // the tone by distance
    float scale = 1.0F;     // the share of the marks that is shown at this zoom
    float share = 1.0F;     // the share of the layer's marks that may be used at all
};

// Returns whether a mark with the rank `u` is shown. Three tests follow each other: share and light, zoom, and depth.
// The verdict names the first test that drops the mark.
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

// ---- Hidden lines: how much paper a mark paints over the ink beyond it, and how much a layer of surface lets through
//                                                                                                          [NPAR 6.1]

// Returns the opacity of a front mark. nu = n . v, where v points from the camera to the mark, so nu is negative in
// front.
[[nodiscard]] inline float front_alpha(float nu, float lambda) noexcept {
    return std::clamp(nu * nu * lambda, 0.0F, 1.0F);
}

// Returns the opacity of a back mark. It contains the natural logarithm of nu, so it is 0 for nu <= 0.05.
[[nodiscard]] inline float back_alpha(float nu, float lambda) noexcept {
    if (!(nu > 0.05F)) return 0.0F;
    return std::clamp(0.2F * (std::log(nu - 0.05F) + 5.0F) * lambda, 0.0F, 1.0F);
}

// Returns the expected number of discs of a layer that overlap at a pixel: the area of a disc divided by the screen
// area of a mark's piece of surface, which shrinks with |nu|. radius and spacing are in pixels.
[[nodiscard]] inline float expected_overlap(float radius, float spacing, float nu) noexcept {
    const float piece = spacing * spacing * std::max(std::abs(nu), 0.01F);
    return piece > 0.0F ? std::max(1.0F, std::numbers::pi_v<float> * radius * radius / piece) : 1.0F;
}

// Returns the opacity for each of `overlap` discs, so that together they are as opaque as `layers` layers with the
// opacity alpha: (1 - opacity)^overlap = (1 - alpha)^layers. With layers = 0 it returns alpha, as published.
[[nodiscard]] inline float disc_opacity(float alpha, float layers, float overlap) noexcept {
    if (!(layers > 0.0F) || alpha >= 1.0F) return alpha;
    return -std::expm1(std::log1p(-alpha) * layers / overlap);
}

// Returns the transmittance of an item's layer. Ink that a solid hides is behind two layers: one faces the eye and one
// faces away. A surface drawn on both sides may be a single layer, so it hides as much as two.
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

// A mask for the bits of an item's index that are stored in the lowest bits of a transmittance. The change of the
// transmittance is too small to show in a pixel. Separate planes for items would take as much time as planes of depths.
// Items with the same bits count as one item.
inline constexpr std::uint32_t item_bits = 15;
[[nodiscard]] inline std::uint32_t bits_of_item(std::int32_t item) noexcept {
    return static_cast<std::uint32_t>(item) & item_bits;
}
[[nodiscard]] inline std::uint32_t item_of(float transmittance) noexcept {
    return base::bit_cast<std::uint32_t>(transmittance) & item_bits;
}
// Returns the number nearest to `transmittance` that contains the item's bits and is not above 1.
[[nodiscard]] inline float with_item(float transmittance, std::int32_t item) noexcept {
    HRBFNPR_ASSERT(transmittance >= 0.0F && transmittance <= 1.0F);
    const std::uint32_t own = bits_of_item(item);
    const auto bits = base::bit_cast<std::uint32_t>(transmittance);
    if (bits <= item_bits) return base::bit_cast<float>(own);
    const std::uint32_t with = ((bits + item_bits / 2 - own) & ~item_bits) + own;
    return base::bit_cast<float>(with > base::bit_cast<std::uint32_t>(1.0F) ? with - item_bits - 1 : with);
}

// ---- The order of painting, as published

// Returns how far behind a front mark its disc of paper is painted, in eye units. The disc must be behind all ink of
// the mark's layer. Within the disc's radius R, a sphere of any size that faces the eye at the angle theta is at most R
// (1 + sin(theta)) / cos(theta) deeper. This bound holds for a plane (R tan(theta)), and for a sphere so small that its
// contour is just within R.
[[nodiscard]] inline float front_push(float radius, float nu, float pixels_per_unit) noexcept {
    const float cosine = std::clamp(std::abs(nu), scene_tuning.smallest_cosine, 1.0F);
    return radius / pixels_per_unit * (1.0F + std::sqrt(1.0F - cosine * cosine)) / cosine;
}

// Returns how far behind a back mark its disc of paper is painted, in eye units. The disc must not cover the ink of the
// contour, where the layer of the mark turns towards the eye. The contour is nearer to the eye than the mark, so a
// small distance is enough.
[[nodiscard]] inline float back_push(float radius, float pixels_per_unit) noexcept { return radius / pixels_per_unit; }

} // namespace hrbfnpr::frame
