// SPDX-License-Identifier: MIT
// The tuning constants of hatching on the screen. Tuned with `scripts/bench strokes` on a ramp, a sphere, a torus,
// knots, a head and a bunny.
#pragma once

#include <cstdint>

namespace hrbfnpr::frame {

struct HatchTuning {
    // ---- The width law

    // A line of a level that fades in is drawn if its computed width is at least this, in pens. Larger: levels come in
    // later and are more visible when they do.
    float thinnest_fading = 0.5F;
    // A line that fades in has its full width if its computed width exceeds `thinnest_fading` by this, in pens. Until
    // then, the other lines are wider instead. Larger: levels come in more slowly.
    float fading_ramp = 0.25F;
    // Above this weight, from 0 to 1, the margin of a level that fades in rises to the margin of a full level. Larger:
    // a steeper change at the end.
    float nearly_full = 0.6F;

    // ---- The ends of lines

    // Lines end where n . v rises above this, just before the contour. Nearer 0: lines end closer to the contour, where
    // they merge.
    float last_nu = -0.03F;
    // Marks with n . v above this have no width. Larger: more marks are processed.
    float widest_nu = 0.2F;
    // The presence of a line (presence.h) is 1 where the line is darker, by at least this, than the tone at which lines
    // begin. Where the line is less dark, its presence falls towards 0, and the parts of the line on either side are
    // less connected. Larger: ends are softer where the tone changes slowly.
    float tone_ramp = 0.03F;
    // A line fades if the margin of its level is below this. Larger: levels with hardly any space change more of the
    // lines beside them.
    float level_ramp = 0.8F;

    // Towards the contour, a line fades over this range of n . v. Larger: lines along a contour are more broken there.
    float rim_ramp = 0.05F;

    // ---- Gaps and short parts

    // Gaps shorter than half of this are closed. Longer gaps open gradually, and are fully open at this length. In line
    // widths. Larger: fewer and longer lines.
    float least_gap = 2.0F;
    // `least_gap` is never less than this, in pixels, however thin the line is. Larger: lines cross small spots of
    // light.
    float least_gap_pixels = 1.0F;
    // A hidden gap no longer than this many halos is closed, because a contour and its halo end in it. Up to
    // `opened_halos`, gaps open gradually. Larger: halos are crossed.
    float closed_halos = 1.0F;
    float opened_halos = 1.5F;
    // A part between two hidden parts must be at least this many times `hatch_shortest` long. Shorter parts are in the
    // halo of a line beside them. Larger: fewer flecks beside contours, and less hatching between close contours.
    float shortest_between_hidden = 3.0F;
    // When short parts are left out, the length of a line is multiplied by this if its level has hardly any space
    // between other lines. Smaller: fewer short lines between long ones.
    float length_of_filling = 1.0F / 3.0F;
    // When short parts are left out, a thin part counts as shorter than it is. Parts at least this wide, in pens, count
    // in full. Larger: thin parts must be longer.
    float full_width = 0.5F;

    // ---- Tapers

    // The taper at the end of a line is this share of `hatch_taper` long if the stroke or the level ends there, or if
    // the line ends at a contour that is nearly parallel to it. Larger: softer ends.
    float blunt_taper = 0.35F;
    // At a crease, the end of a line is rounded over this many widths, because the face is dark up to its edge. Larger:
    // pointed ends at creases.
    float round_tip = 0.5F;
    // Where a line becomes hidden, it narrows over this many pixels. Larger: softer ends at contours.
    float hidden_taper = 2.0F;
    // If the sine of the angle between a line and a contour is at least `crossing_sine`, the line keeps its width up to
    // the contour. If the sine is at most `parallel_sine`, the line narrows towards the contour. Larger: more lines
    // narrow.
    float crossing_sine = 0.5F;
    float parallel_sine = 0.25F;
    // The angle between a line and a contour is measured over this share of `hatch_taper`, because every line becomes
    // tangent to the contour at its end. Larger: lines that bend count as crossing.
    float chord_share = 0.5F;
    // The width of the first point after a tip is at most this, in pens. Larger: blunter tips of wide lines.
    float widest_tip = 0.1F;

    // ---- Points

    // The distance between samples of a line, in pixels. Smaller: closer to the curve, more time.
    float step = 2.75F;
    // On either side of the marks that may be drawn, this many other marks are loaded: the first mark that is not
    // drawn, one for its tangent, and one for its spacing. Fewer: ends are wrong.
    std::int64_t marks_around = 3;
    // If fewer marks than this lie between two ranges that may be drawn, they are loaded, too. Larger: fewer ranges,
    // more marks.
    std::int64_t fewest_left_out = 16;
    // Between marks closer than this, in pixels, a line is straight. It is at most an eighth of this distance away from
    // the curve. Larger: corners show.
    float shortest_curve = 1.0F;
    // The least distance between samples, in pixels. Larger: ends are less exact.
    float least_step = 1.0F / 64.0F;
    // Within this distance from a tip, in pixels, extra points replace the samples. They follow the square root of the
    // width near the tip. Larger: fewer of the samples' own widths are used.
    float tip_reach = 2.5F;
    // At most this many consecutive points are left out. Larger: opacities and ids are less exact.
    std::int64_t most_left_out = 6;
    // A point is left out if its distance from the line between its neighbours is below `place_tolerance`, and its
    // radius differs from the interpolated radius by less than `radius_tolerance`. Both are in pixels. Larger: fewer
    // points, corners show.
    float place_tolerance = 0.05F;
    float radius_tolerance = 0.006F;

    // ---- Closed strokes

    // A stroke is closed if the distance of its ends is at most `closed_gap`, in mean distances of marks, and the
    // cosine between the directions of its ends is at least `closed_cosine`. Larger gap, smaller cosine: more strokes
    // are closed, also spirals.
    float closed_gap = 1.5F;
    float closed_cosine = 0.8F;
    // Two ends closer than this count as one mark, in mean distances of marks. Larger: a mark is lost.
    float same_mark = 0.1F;
    std::int64_t fewest_of_closed = 4; // the smallest number of marks of a closed stroke

    // ---- An unsteady hand

    // The wavelength of the noise. `wobble_swing` is for the wobble, in pens. `end_swing` is for the ends of strokes,
    // as a multiple of the longest overshoot. Larger: calmer.
    float wobble_swing = 60.0F;
    float end_swing = 4.0F;
    // The noise has this many knots in a wavelength, and at least `fewest_knots` around a closed stroke. Larger:
    // rounder, slower.
    double knots_of_swing = 3.0;
    double fewest_knots = 4.0;

    // ---- Lights

    // In the lights, the coverage at a place of a line is up to this share higher or lower than the tone asks for.
    // Larger: ends of neighbouring lines are farther apart, and lines are more broken.
    float break_range = 1.0F;
    // The wavelength of the noise that breaks a line, in distances from the line to others of its level. Larger: fewer
    // and longer parts.
    float break_swing = 12.0F;

    // ---- Edges that hide lines

    // An edge is in front of a line if it is nearer to the eye by more than this, in pixels. Larger: creases of the
    // line's own surface hide less, and so do surfaces just in front of it.
    float least_depth_gap = 1.0F;
    // An edge has its full halo if it is nearer than the line by this many times `halo_gap`. Larger: halos grow more
    // slowly.
    float full_halo = 3.0F;
    // If the halo of an edge has no width, a line ends at this distance from the edge, in pixels.
    float edge_gap = 0.05F;
    // The borders of halos up to this width, in pixels, are found exactly. Wider halos stay as the depth layers made
    // them. Larger: slower.
    float widest_halo = 32.0F;
    // If an extended line crosses an edge within this distance, in pixels, the depths are compared at the crossing.
    // Otherwise the comparison allows for a surface as steep as `steepest_slope`: depth per distance in the picture.
    // Larger: fewer edges count as in front of a slanted surface.
    float farthest_crossing = 24.0F;
    float steepest_slope = 6.0F;
    // If the cosine of the angle between a line and an edge is at most `across_cosine`, the line has a blunt end there.
    // If it is at least `along_cosine`, the line is narrowed so that it does not cover the edge.
    float across_cosine = 0.25F;
    float along_cosine = 0.5F;
    // The search for edges begins at least this many samples before the last sample that is seen. It begins farther
    // back if an edge is within `edge_reach` pixels. Larger: slower.
    std::int64_t samples_back = 2;
    float edge_reach = 1.5F;
    // A sample may be wrongly hidden if its distance from an edge is below a splat's radius plus this, in pixels, but
    // not if it is above `farthest_hidden`. Larger: more hidden samples are tested again.
    float splat_margin = 1.0F;
    float farthest_hidden = 24.0F;
};
inline constexpr HatchTuning hatch_tuning;

} // namespace hrbfnpr::frame
