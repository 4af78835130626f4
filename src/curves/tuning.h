// SPDX-License-Identifier: MIT
// The tuning constants of meshing a surface and of tracing curves on it. A side is the longest side of the mesh's
// cells, a diagonal that of the surface's bounds. Set by scripts/bench lines on fitted scans, knots, tori and bumpy
// spheres, and on surfaces whose contours are known.
#pragma once

#include <cstdint>

namespace hrbfnpr::curves {

struct CurveTuning {
    // ---- The mesh

    // Places that are nearer than this to each other, to the surface or to the region's wall are one, or on it, in
    // sides: seeds, starts of curves, ends of paths, crossings of a line with triangles. Larger: fewer evaluations;
    // small loops and close sheets may be missed.
    double close = 1e-3;
    // A vertex stands for the surface of its sheet within this many sides: a seed that has none is missed. Larger: less
    // is told of thin parts.
    double vertex_reach = 1.5;
    // The mesh goes on for this many sides beyond the surface's end, where that is known. Larger: more cells that are
    // cut away again.
    double beyond_end = 2.0;
    // Corners of cells nearer to the surface than this, in sides, move away to this distance. All tetrahedra keep their
    // orientation. Larger: fewer slivers, and cells of less even shape.
    double corner_clearance = 0.05;
    // Searches along edges, pieces and segments end after this many steps; from trusted_steps on they halve. Larger
    // trusted_steps: faster where f is smooth, slower where it has kinks.
    int most_steps = 60;
    int trusted_steps = 6;
    // Places on edges, in sides, and on pieces of curves, in lengths of the piece, are exact to this. Larger: the
    // border and cusps are less exact.
    double exact = 1e-9;
    // A cut may be this far from the place that the values at the edge's ends tell, in sides. Larger: cuts may jump to
    // another part of the border.
    double farthest_cut = 0.35;
    // The way between two places is halved this often where Newton's steps failed: to begin them anew, or to cut a mesh
    // there. Larger: more evaluations.
    int halvings = 8;
    int cut_halvings = 30;

    // ---- The surface's end

    // The surface may end within this many sides of the border's places. Larger: more evaluations of the support.
    double border_reach = 3.0;
    // A place of a sheet is on the whole surface if it is this near to it, in sides. Larger: curves may go on beyond a
    // crease.
    double on_sheet = 1e-7;

    // ---- Newton's steps

    // A point that is not on its curve, or a seed that is not on the surface, after this many steps is given up.
    // Larger: more evaluations.
    int newton_steps = 12;
    // A step of up to this many tolerances may be the last one, where the next one would be below this share of the
    // tolerance. Larger: fewer evaluations, points less exact.
    double may_be_last = 5.0;
    double negligible_step = 1e-3;

    // ---- Starts

    // A curve may be this far from the place that it is looked for at, in sides. Larger: a start may be led to the next
    // curve.
    double start_reach = 1.0;
    // A change of sign has its curve if one passes within this, in sides. Larger: close curves may be missed.
    double covered = 0.35;
    // Starts and runs that are this near to a known curve or a longer run lie on it, in sides. Larger: close curves may
    // be missed; smaller: curves are found twice.
    double found_already = 0.02;
    // Where no curve was found for changes of sign, cells are this many times smaller, with at most this many along a
    // box's diagonal. Larger: more time, fewer curves missed.
    double closer = 8.0;
    double most_cells = 128.0;
    // A surface that has lost more changes of sign than this is torn, in smaller cells as well.
    std::int64_t most_lost = 2000;

    // ---- Runs of points

    // Starts are this far apart, in longest steps. Larger: fewer starts, and more gaps to fill.
    double chosen_apart = 0.65;
    // Points that are nearer to each other than this are one, in longest steps, but where the curve turns. Larger:
    // fewer points.
    double least_run = 0.1;
    // Points across a wider gap than this are not on one curve, in longest steps. Larger: more gaps are tried.
    double widest_gap = 3.0;
    // Points of the view before are kept where the curve turns by this much, in turns. Larger: fewer points.
    double kept_turn = 0.8;
    // A piece's chord may be off its ends' directions by this much, in turns; an arc's is by half. Larger: cubics may
    // leave the curve.
    double off_chord = 0.75;
    // A gap is halved this many times, down to a kink.
    int gap_halvings = 10;

    // ---- Following

    // The first step of a path, in sides.
    double first_step = 0.25;
    // A path that turns by other than this share of the turn allowed gets longer or shorter steps. Larger: fewer
    // points, more steps that fail.
    double step_safety = 0.7;
    // A step fails after this many corrections.
    int corrector_steps = 5;
    // Where a correction is below this share of the step, the next one is negligible: below 1e-6 sides, since rays to
    // points that are farther off the surface cross it beside them.
    double converged = 1e-3;
    // A point is met within this share of the step beside the cubic of a step. Larger: paths may end on a close curve.
    double beside = 0.05;
    // The least cosine between the directions of a path and of a point that it meets. Larger: curves may be followed
    // twice at kinks.
    double same_way = 0.7;
    // A path may come to its own run after this many steps.
    std::int32_t fewest_steps_of_loop = 3;
    // Where points are nearer to each other than this, in sides, a curve may have a kink between them, of this many
    // radians, since the Hessian of a Hermite sum jumps at each sample.
    double kink_length = 2e-3;
    double sharpest_kink = 1.2;

    // ---- Loops between vertices

    // The distance between the places that differences of grad g are taken from, in sides.
    double probe = 0.05;
    // A step towards an extremum of g is at most this long, and the extremum this far from its vertex, in sides.
    // Larger: more evaluations, extrema of other vertices.
    double longest_search = 0.5;
    double farthest_extremum = 1.5;
    int extremum_steps = 5;
    // A quadratic whose extremum is near has no zero if it is not below this share of |g| at the vertex. Larger: more
    // evaluations.
    double hopeless = 0.5;

    // ---- Changes along curves

    // A point of a cubic is on the curve after a step shorter than this, in lengths of the piece. Larger: fewer
    // evaluations, points less exact.
    double near_curve = 2e-4;
    // A point that is led farther off its cubic than this, in lengths of the piece, belongs to another curve.
    double astray = 0.3;
    // Pieces at whose ends this is the sine of the angle with the line of sight have no cusp: they turn by a third of a
    // radian. Larger: more pieces are looked at.
    double clear_of_cusps = 0.5;
    // A cusp nearer to an end of its piece than the first of these, in lengths of the piece, replaces that end; the
    // border is where the point is if it is nearer than the second.
    double at_end = 1e-2;
    double at_point = 1e-6;
    // A piece is halved this often at most, and gets this many points in the mean: an eye on the surface wants more.
    int deepest_piece = 12;
    std::int64_t most_added = 16;

    // ---- Sheets between two points

    // The surface may be at least this far from a triangle, in sides. Larger: longer spans, more evaluations.
    double least_bulge = 0.02;
    // f is evaluated at places this far apart in a span, in sides. Larger: pairs of roots may be missed.
    double place_spacing = 0.5;
    // Spans with a smaller gap are one, in sides.
    double span_gap = 0.05;
    // A place this near to the surface, in diagonals, is on it as far as f can be trusted: prepared values are off by
    // some 1e-9.
    double root_noise = 1e-9;
    // A segment touches the surface where it is this near, in diagonals, and the sine of the angle between them is
    // below the second. Larger: more answers are uncertain.
    double touching = 2e-8;
    double along_surface = 0.02;
    // At an end on the surface a segment that leaves it by at least this sine tells on which side it is.
    double leaves_surface = 1e-4;
    // A root is on the border of the surface if s is this near to its limit.
    double on_border = 1e-6;
};
inline constexpr CurveTuning curve_tuning;

} // namespace hrbfnpr::curves
