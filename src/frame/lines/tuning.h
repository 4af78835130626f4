// SPDX-License-Identifier: MIT
// The tuning constants of a drawing's lines. `scripts/bench lines` measures their effects.
#pragma once

#include <cstdint>

namespace hrbfnpr::frame {

struct LineTuning {
    // ---- Tracing

    // Tracing begins with the contours of the last frame if their points move by at most this, in mesh sides. Larger:
    // more contours are continued wrongly, and are traced again.
    double farthest_move = 1.0;
    // If more than this share of all points moves farther, all contours are traced anew. Larger: more contours may be
    // missed.
    double most_left_out = 0.1;
    // The tolerance for tracing contours from the contours of the last frame, in mesh sides. The next frame starts from
    // the result. After a Newton step as long as this, the error is a millionth of a mesh side.
    double moved_tolerance = 1e-3;
    // The caller's own lines may be this deep inside the surface, in mesh sides. Larger: surface just before such lines
    // does not hide them.
    double caller_line_clearance = 1.0;
    // Shorter feature lines are noise, in diagonals of the model.
    double shortest_feature = 0.01;
    // The number of refinement rounds of apparent ridges.
    int ridge_rounds = 2;
    // Two items keep their intersections if no place moves by more than this, in diagonals of the model, from one to
    // the other. Larger: intersections follow slow items in steps. It is above the errors of rounding.
    double same_pose = 1e-10;
    // If the camera is moved because of creases, this share of its move is to one side.
    double sideways_share = 0.05;

    // ---- Numbers of lines

    // The largest number of points of a line that are compared with the last frame. Larger: more time, and fewer wrong
    // numbers.
    int most_points = 16;
    // One in this many points of a line is kept for the next frame.
    int points_per_kept = 4;
    // A contour keeps its number if it moves on its surface by at most this many mesh sides between two frames. Larger:
    // lines take the numbers of other lines.
    double farthest_numbered_move = 3.0;

    // ---- Parts

    // A part shorter than this, in pixels, is joined with the part before it, because a gap would show. Larger: lines
    // are drawn through narrow things that hide them.
    double shortest_part = 0.35;
    // A visible part between hidden parts is left out if it is shorter than this many widths. Larger: fewer dots.
    double shortest_dot = 0.5;
    // A hidden part of a contour is drawn under two conditions: it is shorter than `longest_hugging` widths of the
    // widest lines, and everywhere within `hugging_distance` widths of a visible contour. This is tested at steps of
    // `hugging_distance` widths. Fitted faces are not quite flat: seen edge-on, bulges a tenth of a pixel high hide
    // some of their edges. Larger: more hidden parts are drawn.
    double longest_hugging = 5.0;
    double hugging_distance = 0.3;
    // Ends of lines closer than this many widths are one end. Close ends occur where two sheets nearly coincide.
    double same_end_distance = 0.4;
    // A line with less opacity than this does not continue another line.
    float least_opacity = 0.5F;
    // A line that runs into a nearer line continues up to it. But if the sine of the angle between the lines is above
    // `joining_sine`, the line leaves a gap. The gap grows with the sine, and is full from `full_gap_sine` on.
    double joining_sine = 0.35;
    double full_gap_sine = 0.6;

    // ---- Verification by rays

    // A ray is decided if it is farther than this from the outlines of surfaces, in pixels. Larger: more places are
    // undecided. Smaller: the errors of lines, which are up to 0.05 pixels, look like wrong parts.
    double verified_margin = 0.4;
    // Rays go to places at least this far from the ends of a part, in pixels, and at most this far apart. Larger: fewer
    // rays, and short wrong pieces are missed.
    double verified_from_end = 1.5;
    double verified_step = 6.0;
    // The largest number of places of a part.
    double verified_most = 256.0;
    // The way between two places that differ is halved this many times. Larger: repaired parts end more exactly.
    int verified_halvings = 7;
    // Repaired parts are looked at again at most this many times.
    int verified_rounds = 3;

    // ---- Widths and places along a line

    // Depths are measured at up to about twice this many vertices of the surfaces. Larger: more time, and steadier
    // widths if only a small part of a surface is in the window.
    std::int64_t most_depths = 8192;
    // A place less than this share of the window from the window's border counts less for the range of depths. Larger:
    // widths change more slowly if a surface enters the window.
    double depth_margin = 0.05;
    // The range of depths is at least this share of the surfaces' extent across the line of sight. Larger: flat
    // surfaces that are seen from above have more even widths.
    double flat_depth = 0.5;
    // Beyond the ends of the outline, its width changes to that of other lines over this many widths. Larger: softer.
    double fade_widths = 6.0;
    // The number of points of a line along a change of width at an end of the outline, and between two knots of a
    // wobble (`steps_a_knot`).
    double fade_steps = 8.0;
    double steps_a_knot = 4.0;
    // Curvatures are smoothed along a line over this many widths. Larger: widths change more slowly.
    double smooth_widths = 8.0;
    // The number of random numbers of a wobble in each `wobble_length` of the style, which is its wavelength. Larger: a
    // more nervous hand.
    double knots_a_swing = 3.0;
    // The least number of random numbers around a closed line.
    double fewest_knots = 4.0;
    // The least distance between points along a wobble, in pixels.
    double shortest_step = 0.5;
    // The largest index of a knot of a wobble. A line that passes beside the eye may be immensely long.
    double farthest_knot = 1e15;
    // A soft edge has no width where |n . v| is below `soft_edge_ends`, and its whole width from `soft_edge_begins` on.
    // Larger: wider gaps between contours and soft edges. Smaller: double lines along contours.
    double soft_edge_ends = 0.15;
    double soft_edge_begins = 0.45;
    // Points for wobbles and fades are made in the window, and up to this many steps outside it.
    double steps_beside = 16.0;

    // ---- Lines beside other lines

    // Lines are compared at places this many pens apart. A pen is the width of the widest line. Larger: less time, and
    // widths that change unevenly.
    double steps_beside_others = 0.5;
    // The distances of a line from the edge of another one at which it begins to have width, and at which it has its
    // full width, in radii of the line. With its full width at a distance of 1, it would touch the other line. Larger:
    // more white between lines, and lines end farther from others.
    double least_room = 0.5;
    double full_room = 2.0;
    // A line thins another one if the sine of the angle between them is below the first value, and does not above the
    // second. Larger: lines that cross are thinned at their crossing.
    double beside_sine = 0.25;
    double crossing_sine = 0.6;
    // Two places of one stroke are compared if they are this many reaches apart along the stroke. A reach is 1.5 pens.
    // Smaller: bends of a line are thinned.
    double least_apart = 4.0;
    // Weights of the logarithm of the ratio of two widths and of two lengths, and of the age of two lines. If the sum
    // is 1, only one of the two lines is thinned; if it is 0, both are, by half. Larger: the property decides more
    // often, and lines change places faster.
    double weight_of_width = 8.0;
    double weight_of_length = 0.8;
    double weight_of_age = 1.0;
    // The number of times that widths are computed from those of other lines. It should be even: then a line whose
    // neighbours are undecided stays. Larger: more lines of a stack are right.
    int beside_rounds = 6;
    // Changes of width are averaged twice over this many pens to each side. Larger: softer ends, and lines must run
    // beside each other longer before one is left out.
    double beside_fade = 1.0;
    // Parts that keep at most this share of their width are left out. Larger: ends are blunter.
    double least_kept = 0.03;
};
inline constexpr LineTuning line_tuning;

} // namespace hrbfnpr::frame
