// SPDX-License-Identifier: MIT
// The tuning constants of drawings by depth layers. `scripts/bench frame` measures their effects.
#pragma once

namespace hrbfnpr::frame {

struct LayerTuning {
    // ---- Ink

    // Towards the contour, the ink of front marks fades over this range of n . v, unless coverage already makes it
    // fade. Larger: a paler rim.
    float front_fade = 0.08F;

    // ---- Stipples that are even in the picture. Distances are in units of the square root of the area of a mark.

    // Marks get smaller over this part of the distance below which they are too near. Larger: more small marks, and
    // tones with less grain.
    float even_soft = 0.7F;
    // An earlier mark counts fully if the distance that its place stands for is larger than needed by this share.
    // Larger: denser marks with less even distances.
    float even_shown = 0.6F;
    // Marks with less than this part of their area are left out. Larger: fewer small marks, more grain.
    float even_least = 0.05F;
    // Two marks are on one sheet of a surface if the depth between them differs from the mean slope by at most this
    // part of the change of the slope, and by this many pixels. Larger: hidden marks keep away more of the marks in
    // front of them.
    float sheet_bend = 0.5F;
    float sheet_gap = 2.0F;
    // Marks up to this many pixels outside the window count, too. Larger: more time, and steadier marks near the border
    // of the picture.
    float even_margin = 32.0F;
    // The most cells along the side of a tile, in which near marks are searched. Larger: more memory, less time.
    std::int32_t most_even_cells = 32;

    // ---- Splats

    // The radius of splats in spacings; half a pixel is added. In a blue-noise order, no place is farther than 0.8
    // spacings from a mark. Of random marks, one place in two thousand remains uncovered. Larger: fewer holes, but more
    // is hidden beyond the border of a layer.
    float even_splat_radius = 0.85F;
    float random_splat_radius = 1.6F;
    // If the curvature is not known, marks whose |n . v| is larger than this are not near a contour. Larger: more
    // splats.
    float unknown_rim_nu = 0.2F;

    // ---- Halos

    // Marks at most this many pixels from the contour are near it. They get halos, and clusters that may contain such
    // marks have the splat spacing of the contour. Larger: halos have fewer gaps and are less exact, and there are more
    // splats.
    float contour_band = 1.0F;
    // A halo is at most this many times as wide as the line of its contour, so that it fades with the line. Larger:
    // halos of thin lines are wider.
    float halo_per_width = 3.0F;
    // The line of a contour is at most a halo's width and this far, in pixels, from the place where marks put the
    // contour. Larger: halos continue beyond the ends of lines. Smaller: halos have gaps.
    float farthest_line = 4.0F;
    // A contour has no halo where its depth changes by more than this per pixel. Larger: halos continue farther along
    // such a contour, and may hide the contour's own line.
    float steepest_contour = 8.0F;
    // A halo hides as much as a layer that faces away with this n . v. Larger: halos hide more where lines are
    // attenuated.
    float halo_angle = 0.25F;

    // ---- Layers

    // A layer is separate from a nearer layer that faces the same way if their distance is more than this many radii of
    // its discs. Larger: close layers count as one.
    float layer_gap = 4.0F;
    // Ink or a layer is behind a layer that faces the other way if their distance is more than this many pixels.
    // Larger: thin parts hide less.
    float side_gap = 1.0F;
    // Ink is behind another layer of its item that faces the same way if the distance between ink and layer is more
    // than this many radii of the splats. Larger: fewer marks are hidden by the layer that they lie on, and more marks
    // show through close layers.
    float own_gap = 5.0F;
    // Discs extend beyond the border of a surface, and could hide a strip of another surface that begins there. So ink
    // that is at most `border_gap` radii behind such a layer is hidden only if the layer continues in all directions
    // for `border_reach` radii. Larger: less of the strip is hidden, and more marks show through small parts.
    float border_gap = 2.0F;
    float border_reach = 1.5F;

    // ---- Exact visibility

    // A ray starts at this distance, in pixels, from the layer that its mark lies on. Larger: fewer marks are hidden by
    // their own layer, and more marks show through surfaces that touch this layer.
    double ray_offset = 0.5;

    // ---- Progress

    // The shares of the time for gathering and for depth layers, if there are many marks.
    double gathered_share = 0.4;
    double dimmed_share = 0.8;
};
inline constexpr LayerTuning layer_tuning;

} // namespace hrbfnpr::frame
