// SPDX-License-Identifier: MIT
// The tuning constants of drawings by depth layers. scripts/bench frame measures their effects.
#pragma once

namespace hrbfnpr::frame {

struct LayerTuning {
    // ---- Ink

    // Marks that cover less than this share of the paper are shown as if they covered that, so that their dark tones
    // still differ. Larger: paler pictures of few marks.
    float darkest = 0.6F;
    // Ink of the front vanishes towards the contour over this much of n . v, where nothing else makes it vanish.
    // Larger: a paler rim.
    float front_fade = 0.08F;

    // ---- Splats

    // Pixels between the marks that stand for a layer where there are enough of them, and near its contour. Larger:
    // less time, and small features are missed.
    float splat_spacing = 6.0F;
    float contour_splat_spacing = 4.0F;
    // The radius of their discs in spacings, without half a pixel. A blue-noise order leaves no place farther than 0.8
    // from a mark, and marks at random leave one place in two thousand. Larger: fewer holes, but more is hidden beyond
    // a layer's border.
    float even_splat = 0.85F;
    float random_splat = 1.6F;
    // Where the curvature is not known, marks of a larger |n . v| than this are near no contour. Larger: more splats.
    float unknown_rim = 0.2F;

    // ---- Halos

    // Marks within this many pixels of the contour are near it: halos go out from them, and a cluster that may hold one
    // has the splats of contours. Larger: halos have fewer gaps and are less exact, and there are more splats.
    float contour_band = 1.0F;
    // A contour that runs into the depth more steeply than this has no halo, depth over pixels. Larger: halos reach
    // farther along such a contour, and may hide its own line.
    float steepest_contour = 8.0F;
    // A halo is as dark as a layer that turns away by this n . v. Larger: darker halos where lines are attenuated.
    float halo_angle = 0.25F;

    // ---- Layers

    // A layer lies after another that faces alike if it is farther by this many radii of its discs. Larger: close
    // layers count as one.
    float layer_gap = 4.0F;
    // A layer lies after one that faces the other way if it is farther by this many pixels. Larger: thin parts hide
    // less.
    float side_gap = 1.0F;
    // Ink lies after another layer of its item that faces as its own does if it is farther by this many radii of the
    // splats. Larger: fewer marks are hidden by their own layer, and more shine through close ones.
    float own_gap = 5.0F;
    // Discs reach beyond the border of a surface that ends, and would hide a strip of another one that begins there. Up
    // to `border_gap` radii after such a layer, ink is hidden only if the layer goes on on all sides as far as
    // `border_reach` radii. Larger: less of the strip is hidden, and more shines through small parts.
    float border_gap = 2.0F;
    float border_reach = 1.5F;

    // ---- Exact visibility

    // Rays start this many pixels off their mark's own layer. Larger: fewer marks are hidden by their own layer, and
    // more shine through what touches it.
    double off_layer = 0.5;

    // ---- Progress

    // The shares of the time after which marks are gathered and dimmed, as with many marks.
    double gathered = 0.4;
    double dimmed = 0.8;
};
inline constexpr LayerTuning layer_tuning;

} // namespace hrbfnpr::frame
