// SPDX-License-Identifier: MIT
// The tuning constants of drawings by depth layers. `scripts/bench frame` measures their effects.
#pragma once

namespace hrbfnpr::frame {

struct LayerTuning {
    // ---- Ink

    // If all marks together cover less than this share of the paper, they are shown as if they covered that much, so
    // that dark tones still differ. Larger: paler pictures where there are few marks.
    float darkest = 0.6F;
    // Ink of the front fades towards the contour over this range of n . v, unless coverage makes it fade. Larger: a
    // paler rim.
    float front_fade = 0.08F;

    // ---- Splats

    // The distance between splats, in pixels, if a layer has enough marks; the second value holds near the contour.
    // Larger: less time, but small features are missed.
    float splat_spacing = 6.0F;
    float contour_splat_spacing = 4.0F;
    // The radius of splats in spacings, without half a pixel that is added. A blue-noise order leaves no place farther
    // than 0.8 spacings from a mark; random marks leave one place in two thousand uncovered. Larger: fewer holes, but
    // more is hidden beyond a layer's border.
    float even_splat_radius = 0.85F;
    float random_splat_radius = 1.6F;
    // Marks whose |n . v| is larger than this are not near a contour, if the curvature is not known. Larger: more
    // splats.
    float unknown_rim_nu = 0.2F;

    // ---- Halos

    // Marks within this many pixels of the contour are near it. They get halos, and clusters that may hold such a mark
    // use the contour's splat spacing. Larger: halos have fewer gaps and are less exact, and there are more splats.
    float contour_band = 1.0F;
    // A contour gets no halo where it runs into the depth more steeply than this, depth over pixels. Larger: halos
    // reach farther along such a contour, and may hide the contour's own line.
    float steepest_contour = 8.0F;
    // A halo hides as much as a layer that faces away with this n . v. Larger: halos hide more where lines are
    // attenuated.
    float halo_angle = 0.25F;

    // ---- Layers

    // A layer lies behind another one that faces the same way if it is farther by this many radii of its discs. Larger:
    // close layers count as one.
    float layer_gap = 4.0F;
    // A layer lies behind one that faces the other way if it is farther by this many pixels. Larger: thin parts hide
    // less.
    float side_gap = 1.0F;
    // Ink lies behind another layer of its item that faces the same way as its own if it is farther by this many radii
    // of the splats. Larger: fewer marks are hidden by their own layer, and more shine through close layers.
    float own_gap = 5.0F;
    // Discs reach beyond the border of a surface, and would hide a strip of another surface that begins there. Up to
    // `border_gap` radii behind such a layer, ink is hidden only if the layer continues to all sides for `border_reach`
    // radii. Larger: less of the strip is hidden, and more shines through small parts.
    float border_gap = 2.0F;
    float border_reach = 1.5F;

    // ---- Exact visibility

    // Rays start this many pixels off the layer of their mark. Larger: fewer marks are hidden by their own layer, and
    // more shine through surfaces that touch it.
    double ray_offset = 0.5;

    // ---- Progress

    // The shares of the time after which marks are gathered and dimmed, when there are many marks.
    double gathered_share = 0.4;
    double dimmed_share = 0.8;
};
inline constexpr LayerTuning layer_tuning;

} // namespace hrbfnpr::frame
