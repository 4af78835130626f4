// SPDX-License-Identifier: MIT
// The tuning constants of hatching on the screen. Set on a ramp, a sphere, a torus, knots, a head and a bunny, by
// scripts/bench strokes.
#pragma once

#include <cstdint>

namespace hrbfnpr::frame {

struct HatchTuning {
    // ---- The width law

    // A line of a level that fades in is drawn where it should be at least this wide, in pens. Larger: levels come in
    // later and are more visible when they do.
    float thinnest_fading = 0.5F;
    // A line that fades in reaches its width where it should be this much wider than `thinnest_fading`, in pens; until
    // then the full lines have the rest. Larger: levels come in more slowly.
    float fading_ramp = 0.25F;
    // From this weight on, from 0 to 1, the margin of a level that fades in goes over to that of a full line. Larger:
    // a steeper change at the end.
    float nearly_full = 0.6F;

    // ---- Where a line is drawn

    // Lines end where n . v is above this, just before the contour. Nearer 0: lines end closer to the contour, where
    // they run together.
    float last_nu = -0.03F;
    // Marks that face away by more than this have no width. Larger: more marks are worked on.
    float widest_nu = 0.2F;
    // Where a line is this much darker than where lines begin, both sides hold together in full. Larger:
    // ends are softer where the tone changes slowly.
    float tone_ramp = 0.03F;
    // The same of the margin of its level. Larger: levels that hardly have room change more of the lines beside them.
    float level_ramp = 0.8F;

    // The same of n . v. Larger: lines that run along a contour are more broken there.
    float rim_ramp = 0.05F;

    // ---- Gaps and short parts

    // Gaps of fewer widths are closed; between half of this and this they open. Larger: fewer and longer lines.
    float least_gap = 2.0F;
    // A gap is closed no matter how wide the line is where it is shorter than this, in pixels. Larger: lines cross
    // dots of light.
    float least_gap_pixels = 1.0F;
    // A gap that something hides is closed where it is no longer than this many halos, since it is where a contour and
    // its halo run out; up to `halo_and_more` it opens. Larger: halos are crossed.
    float halo_alone = 1.0F;
    float halo_and_more = 1.5F;
    // A part between two hidden ones is at least this many times the least length. It is in the halo of a line that
    // runs along it. Larger: fewer flecks beside contours, and less hatching between close contours.
    float between_hidden = 3.0F;
    // A line between others, for which there is hardly room, counts as this part of its length where short parts are
    // left out. Smaller: fewer short lines between long ones.
    float length_of_filling = 1.0F / 3.0F;
    // From this many pens on all widths count alike in a part's length. Larger: thin parts must be longer.
    float full_width = 0.5F;

    // ---- Tapers

    // A line's end where its stroke or its level ends, or at a contour that it runs along, is this part of hatch_taper
    // long. Larger: softer ends.
    float blunt = 0.35F;
    // An end at a crease rounds off over this many widths: the face is dark up to its edge. Larger: pointed ends at
    // creases.
    float round_tip = 0.5F;
    // A line narrows over this many pixels where something hides it. Larger: softer ends at contours.
    float hidden_taper = 2.0F;
    // A line that meets the contour's normal by at least the first of these sines runs on under the contour; one by
    // the second narrows before it. Larger: more lines narrow.
    float crosses = 0.5F;
    float runs_along = 0.25F;
    // That angle is of the chord over this part of hatch_taper, since in the end all lines touch the contour. Larger:
    // lines that bend count as crossing.
    float rim_part = 0.5F;
    // At the first point from a tip a line is at most this wide, in pens. Larger: blunter tips of wide lines.
    float widest_tip = 0.1F;

    // ---- Points

    // The distance between samples of a line, in pixels. Smaller: closer to the curve, more time.
    float step = 2.75F;
    // Marks around those that may be drawn are looked at, too, as many on either side: the first that is not drawn, the
    // next one for its tangent, and the next one for the spacing there. Fewer: ends are wrong.
    std::int64_t marks_around = 3;
    // Fewer marks between two ranges that may be drawn are looked at. Larger: fewer ranges, more marks.
    std::int64_t fewest_left_out = 16;
    // Between marks that are nearer than this a line is straight, pixels. It leaves the curve by at most an eighth of
    // it. Larger: corners show.
    float shortest_curve = 1.0F;
    // Samples are farther apart than this, pixels. Larger: ends are less exact.
    float least_step = 1.0F / 64.0F;
    // Samples within this distance of a tip give way to points that follow the root by which the width changes there,
    // pixels. Larger: less of the samples' own widths.
    float tip_reach = 2.5F;
    // At most as many points that follow each other are left out. Larger: opacities and ids are coarser.
    std::int64_t most_left_out = 6;
    // Points that differ by less than this from the line between those beside them are left out, in pixels. Larger:
    // fewer points, corners show.
    float straight = 0.05F;
    float even_radius = 0.006F;

    // ---- Closed strokes

    // A stroke is closed if its ends are no farther apart than this, in steps from mark to mark, and go on into each
    // other with at least this cosine. Larger gap, smaller cosine: more strokes are closed, also spirals.
    float closed_gap = 1.5F;
    float closed_cosine = 0.8F;
    // Ends nearer than this are one mark, in steps. Larger: a mark is lost.
    float same_place = 0.1F;
    std::int64_t fewest_of_closed = 4; // marks

    // ---- An unsteady hand

    // The length of a swing: in pens of the hand's wobble, and in the longest overshoot of its ends. Larger: calmer.
    float wobble_swing = 60.0F;
    float end_swing = 4.0F;
    // A swing has as many knots of the noise, and a closed stroke at least as many. Larger: rounder, slower.
    double knots_of_swing = 3.0;
    double fewest_knots = 4.0;

    // ---- Edges that hide lines

    // An edge lies before a line if it is nearer to the eye by this, pixels. Larger: creases of the line's own surface
    // hide less, and so do surfaces just before it.
    float least_before = 1.0F;
    // Edges that are nearer by this many times halo_gap have all of their halo. Larger: halos grow more slowly.
    float full_halo = 3.0F;
    // Without a halo a line ends as far before an edge, pixels.
    float at_edge = 0.05F;
    // Halos wider than this are left as depth layers made them, pixels. Larger: slower.
    float widest_halo = 32.0F;
    // Where lines that run on would cross an edge at most this far on, pixels, their depths there are compared; else
    // surfaces may be as steep as `steepest`, depth over pixels. Larger: fewer edges before a slanted surface.
    float farthest_crossing = 24.0F;
    float steepest = 6.0F;
    // A line that makes an angle with an edge of at most the first cosine ends bluntly there; one of at least the
    // second is narrowed so that it does not reach over it.
    float goes_across = 0.25F;
    float goes_along = 0.5F;
    // From the sample that is seen last edges are looked for at least as many samples back, and on to where none is
    // within `off_edge` pixels. Larger: slower.
    std::int64_t samples_back = 2;
    float off_edge = 1.5F;
    // Samples may be hidden by mistake as far from an edge as a splat's radius and this, pixels, up to
    // `farthest_hidden`. Larger: more hidden samples are asked again.
    float beyond_splat = 1.0F;
    float farthest_hidden = 24.0F;
};
inline constexpr HatchTuning hatch_tuning;

} // namespace hrbfnpr::frame
