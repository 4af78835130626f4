// SPDX-License-Identifier: MIT
// The tuning constants of a drawing's lines. scripts/bench lines measures their effects.
#pragma once

namespace hrbfnpr::frame {

struct LineTuning {
    // ---- Tracing

    // Contours of the last frame are begun with where their points move by at most this, in sides of the mesh. Larger:
    // more contours that go on wrongly, and are traced again.
    double farthest_move = 1.0;
    // None of them are where more than this share of all points moves farther. Larger: more contours may be missed.
    double most_left_out = 0.1;
    // Contours that go on are traced to this tolerance, in sides of the mesh. After a step of this length a millionth
    // of a side is left, and the next frame asks again.
    double moved_tolerance = 1e-3;
    // Lines of the caller's own may lie this deep inside the surface, in sides of the mesh. Larger: more of the surface
    // just before such lines does not hide them.
    double clear_of_own = 1.0;
    // Shorter feature lines are noise, in diagonals of the model.
    double shortest_feature = 0.01;
    // Apparent ridges are refined this many times.
    int ridge_rounds = 2;
    // From farther away lines of sight are parallel to all digits that contours are found to, in diagonals.
    double parallel_from = 1e9;
    // The camera of models with creases moves by this share of the scene's radius, so that no face is seen exactly
    // edge-on. Larger: lines move visibly.
    double off_planes = 2e-5;
    // It moves by this share of that to one side, at an angle that no plane of symmetry is likely to hold.
    double aside = 0.05;
    double aside_angle = 0.9;

    // ---- Numbers of lines

    // At most this many points of a line are looked for in the last frame. Larger: more time, surer numbers.
    int most_points = 16;
    // One of this many points is kept for the next frame.
    int kept_each = 4;
    // A contour moves by at most this on its surface between frames, in sides of the mesh. Larger: lines take the
    // numbers of others.
    double farthest_number = 3.0;

    // ---- Parts

    // Parts shorter than this belong to the one before, in pixels: a gap would be seen. Larger: lines are drawn through
    // narrow things that hide them.
    double unseen = 0.35;
    // A visible part between hidden ones that is shorter than this many widths is left out. Larger: fewer dots.
    double dot = 0.5;
    // A hidden part of a contour shorter than this many widths of the widest lines is drawn where all of it is within
    // `beside` widths of a contour that is seen, as looked at every `beside` widths: a face that is seen edge-on is not
    // quite flat where it is fitted, and bulges a tenth of a pixel high hide some of its edge. Larger: more hidden
    // parts are drawn.
    double longest_hugging = 5.0;
    double beside = 0.3;
    // Ends of lines are one where they are nearer than this many widths: sheets that are nearly one have such ends.
    double together = 0.4;
    // Lines less opaque than this are not taken for what another one goes on as.
    float least_opacity = 0.5F;
    // A line that runs into another one joins it: it ends before a line that crosses it by more than the first of these
    // sines, at the full gap from the second on.
    double joins = 0.35;
    double ends_before = 0.6;

    // ---- Widths and places along a line

    // Over this many widths the outline's width goes over to that of the line beyond its ends. Larger: softer.
    double fade_widths = 6.0;
    // There, and along a wobble between its knots, a line has points this often.
    double fade_steps = 8.0;
    double steps_a_knot = 4.0;
    // Curvatures are smoothed along a line over this many widths. Larger: widths change more slowly.
    double smooth_widths = 8.0;
    // The random numbers of a wobble, for each wobble_length of a style. Larger: a more nervous hand.
    double knots_a_swing = 3.0;
    // A closed line has at least this many of them.
    double fewest_knots = 4.0;
    // Points along a wobble are at least this far apart, in pixels.
    double shortest_step = 0.5;
    // Numbers of knots end here: a line that passes beside the eye is as long as numbers go.
    double farthest_knot = 1e15;
    // Lines have such points in the window, and this many steps beside it.
    double steps_beside = 16.0;
};
inline constexpr LineTuning line_tuning;

} // namespace hrbfnpr::frame
