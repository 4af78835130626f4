// Sizes and opacities of the discs of one group of marks, as functions of the place on the screen.
// All lengths in pixels; `ppe` is pixels per eye unit at the mark.
#pragma once

#include "frame/attenuation.h"
#include "frame/lens.h"
#include "frame/style.h"
#include "frame/tone.h"

namespace hrbfnpr::frame {

// A cover this many spacings wide leaves no gaps between evenly spread marks.
inline constexpr float cover_spacings = 1.5F;
// Nearer to the contour than this discs are not pushed any farther.
inline constexpr float smallest_cosine = 0.05F;

struct Pen {
    float spacing = 0.0F;      // of the group's marks, eye units
    float zoom_per_ppe = 0.0F; // 0: no reference, the zoom is 1
    float zoom_exponent = 2.0F;
    float ink_radius = 1.0F, ink_zoom = 0.0F;
    float silhouette_radius = 1.0F, silhouette_zoom = 0.0F;
    float cover_radius = 0.0F; // 0: from the spacing
    float halo = 0.0F;
    float layers = 0.0F;
    float lambda_front = 1.0F, lambda_back = 1.0F;
    float largest_cover = 0.0F;

    [[nodiscard]] float zoom(float ppe) const noexcept { return zoom_per_ppe > 0.0F ? ppe * zoom_per_ppe : 1.0F; }
    [[nodiscard]] float scale(float ppe) const noexcept { return zoom_scale(zoom(ppe), zoom_exponent); }
    [[nodiscard]] float front_ink(float ppe) const noexcept { return grown(ink_radius, ink_zoom, ppe); }
    [[nodiscard]] float silhouette_ink(float ppe) const noexcept {
        return grown(silhouette_radius, silhouette_zoom, ppe);
    }

    [[nodiscard]] float front_cover(float ppe) const noexcept {
        // One pixel at least, so that small drawings are covered as well.
        const float radius = cover_radius > 0.0F ? cover_radius : std::max(1.0F, cover_spacings * spacing * ppe);
        return std::min(radius, largest_cover);
    }
    // The area scales with the zoom.  An automatic cover follows the zoom already, so there it is
    // only the halo that is left to scale.
    [[nodiscard]] float back_cover(float ppe) const noexcept {
        const float shrink = std::sqrt(scale(ppe));
        if (cover_radius > 0.0F) return std::min((cover_radius + halo) * shrink, largest_cover);
        return front_cover(ppe) + halo * shrink;
    }

    [[nodiscard]] float front_opacity(float nu, float radius, float ppe) const noexcept {
        return disc_opacity(front_alpha(nu, lambda_front), layers, expected_overlap(radius, spacing * ppe, nu));
    }
    [[nodiscard]] float back_opacity(float nu, float radius, float ppe) const noexcept {
        return disc_opacity(back_alpha(nu, lambda_back), layers, expected_overlap(radius, spacing * ppe, nu));
    }

private:
    [[nodiscard]] float grown(float radius, float exponent, float ppe) const noexcept {
        return exponent == 0.0F ? radius : radius * std::pow(zoom(ppe), exponent);
    }
};

// How far behind its mark, in eye units, a front mark's disc of paper is painted, so that it lies
// behind all ink of its own sheet: within the disc's radius R a sphere of any size that faces the
// eye under the angle theta falls back by R (1 + sin(theta)) / cos(theta) at most, be it a plane
// (R tan(theta)) or so small that its contour is just within reach.
[[nodiscard]] inline float front_push(float radius, float nu, float ppe) noexcept {
    const float cosine = std::clamp(std::abs(nu), smallest_cosine, 1.0F);
    return radius / ppe * (1.0F + std::sqrt(1.0F - cosine * cosine)) / cosine;
}

// The ink that a back mark must not cover is that of the contour, where its sheet turns to the
// front.  That is nearer to the eye, and all that is needed is some slack.
[[nodiscard]] inline float back_push(float radius, float ppe) noexcept { return radius / ppe; }

} // namespace hrbfnpr::frame
