// SPDX-License-Identifier: MIT
// The tuning constants of meshing a surface and of tracing curves on it. The units: a side is the longest side of the
// mesh's cells, a diagonal is that of the surface's bounds. Set by scripts/bench lines on fitted scans, knots, tori and
// bumpy spheres, and on surfaces whose contours are known.
#pragma once

#include <cstdint>

namespace hrbfnpr::curves {

struct CurveTuning {
    // ---- The mesh

    // Places closer than this, in sides, count as one, and a place this close to the surface or to the region's wall is
    // on it. Used for seeds, starts of curves, ends of paths, and crossings of a line with triangles. Larger: fewer
    // evaluations; small loops and close sheets may be missed.
    double close = 1e-3;
    // A vertex represents its sheet of the surface within this many sides: a seed without such a vertex counts as
    // missed. Larger: thin parts are reported less often.
    double vertex_reach = 1.5;
    // The mesh extends this many sides beyond the surface's end, if that is known. Larger: more cells that are cut away
    // again.
    double beyond_end = 2.0;
    // Cell corners nearer to the surface than this, in sides, move away to this distance. All tetrahedra keep their
    // orientation. Larger: fewer slivers, and less regular cells.
    double corner_clearance = 0.05;
    // Root searches along edges, pieces and segments take at most `most_steps` steps, and use bisection after
    // `trusted_steps`. Larger trusted_steps: faster where f is smooth, slower where it has kinks.
    int most_steps = 60;
    int trusted_steps = 6;
    // The tolerance of places on edges, in sides, and on pieces of curves, in lengths of the piece. Larger: the border
    // and cusps are less exact.
    double exact = 1e-9;
    // A cut may be this far from the place interpolated from the values at the edge's ends, in sides. Larger: cuts may
    // jump to another part of the border.
    double farthest_cut = 0.35;
    // The number of bisections between two places where Newton's steps failed: to start them again, and to cut a mesh
    // there. Larger: more evaluations.
    int halvings = 8;
    int cut_halvings = 30;

    // ---- The surface's end

    // The surface may end within this many sides of a place on the border. Larger: more evaluations of the support.
    double border_reach = 3.0;
    // A place of a sheet is on the whole surface if it is this near to it, in sides. Larger: curves may continue beyond
    // a crease.
    double on_sheet = 1e-7;

    // ---- Newton's steps

    // Newton's method gives up a point or a seed after this many steps. Larger: more evaluations.
    int newton_steps = 12;
    // A step of up to `may_be_last` tolerances is accepted as the last one if the next one is predicted to be below
    // `negligible_step` tolerances. Larger: fewer evaluations, points less exact.
    double may_be_last = 5.0;
    double negligible_step = 1e-3;

    // ---- Starts

    // A start may move this far to its curve, in sides. Larger: a start may be led to an adjacent curve.
    double start_reach = 1.0;
    // A change of sign counts as covered if a curve passes within this distance, in sides. Larger: close curves may be
    // missed.
    double covered = 0.35;
    // Starts and runs this near to a known curve or a longer run count as part of it, in sides. Larger: close curves
    // may be missed; smaller: curves are found twice.
    double found_already = 0.02;
    // Where changes of sign have no curve, the mesh is made again with cells this many times smaller, but with at most
    // `most_cells` along a box's diagonal. Larger: more time, fewer curves missed.
    double closer = 8.0;
    double most_cells = 128.0;
    // With more changes of sign without a curve, smaller cells are not tried, because the surface is torn in smaller
    // cells, too.
    std::int64_t most_lost = 2000;

    // ---- Runs of points

    // The distance between starts, in longest steps. Larger: fewer starts, and more gaps to fill.
    double chosen_apart = 0.65;
    // Points closer than this count as one, in longest steps, except where the curve turns. Larger: fewer points.
    double least_run = 0.1;
    // Points across a wider gap are not linked, in longest steps. Larger: more gaps are tried.
    double widest_gap = 3.0;
    // Points of the previous view are kept where the curve turns by this share of the allowed turn. Larger: fewer
    // points.
    double kept_turn = 0.8;
    // The angle between a piece's chord and its tangents may be this share of the allowed turn; on an arc it is half of
    // the turn. Larger: cubics may leave the curve.
    double off_chord = 0.75;
    // A gap is halved at most this many times, down to about `kink_length`.
    int gap_halvings = 10;

    // ---- Following

    // The first step of a path, in sides.
    double first_step = 0.25;
    // The step length is adapted so that a path turns by this share of the allowed turn. Larger: fewer points, more
    // steps that fail.
    double step_safety = 0.7;
    // A step fails after this many corrections without convergence.
    int corrector_steps = 5;
    // Corrections end when one is below this share of the step. The next one would be below 1e-6 sides, which is needed
    // since rays to points farther off the surface would cross it next to them.
    double converged = 1e-3;
    // A path meets a point that is within this share of the step of the step's cubic. Larger: paths may end on a close
    // curve.
    double beside = 0.05;
    // A path meets a point only if the cosine between their directions is at least this. Larger: curves may be followed
    // twice at kinks.
    double same_way = 0.7;
    // A path may meet the run from which it started after this many steps.
    std::int32_t fewest_steps_of_loop = 3;
    // Between points closer than `kink_length`, in sides, a curve may turn by `sharpest_kink` radians, since the
    // Hessian of a Hermite sum jumps at each sample.
    double kink_length = 2e-3;
    double sharpest_kink = 1.2;

    // ---- Loops between vertices

    // The distance between the places for finite differences of grad g, in sides.
    double probe = 0.05;
    // A step towards an extremum of g is at most `longest_search` long, and the extremum at most `farthest_extremum`
    // from its vertex, in sides. Larger: more evaluations, extrema of other vertices.
    double longest_search = 0.5;
    double farthest_extremum = 1.5;
    int extremum_steps = 5;
    // A search ends if the predicted |g| at the extremum is above this share of |g| at the vertex, since g has no zero
    // there. Larger: more evaluations.
    double hopeless = 0.5;

    // ---- Changes along curves

    // A point of a cubic counts as on the curve if Newton's step there is shorter than this, in lengths of the piece.
    // Larger: fewer evaluations, points less exact.
    double near_curve = 2e-4;
    // A point that moves farther than this from its cubic belongs to another curve, in lengths of the piece.
    double astray = 0.3;
    // Pieces have no cusp if the sine of the angle with the line of sight is above this at both ends, since they turn
    // by a third of a radian. Larger: more pieces are examined.
    double clear_of_cusps = 0.5;
    // A cusp within `at_end` of an end of its piece replaces that end; the border passes through a point that is within
    // `at_point` of it. Both are in lengths of the piece.
    double at_end = 1e-2;
    double at_point = 1e-6;
    // A piece is halved at most `deepest_piece` times, and gets `most_added` points on average: an eye on the surface
    // would need more.
    int deepest_piece = 12;
    std::int64_t most_added = 16;

    // ---- Sheets between two points

    // The surface's assumed distance from a triangle is at least this, in sides. Larger: longer spans, more
    // evaluations.
    double least_bulge = 0.02;
    // The distance between the first places at which f is evaluated in a span, in sides. Larger: pairs of roots may be
    // missed.
    double place_spacing = 0.5;
    // Spans with a smaller gap are merged, in sides.
    double span_gap = 0.05;
    // A place this near to the surface, in diagonals, counts as on it: the error of prepared values is about 1e-9.
    double root_noise = 1e-9;
    // A segment touches the surface where it is within `touching` of it, in diagonals, and the sine of the angle
    // between them is below `along_surface`. Larger: more answers are uncertain.
    double touching = 2e-8;
    double along_surface = 0.02;
    // If a segment ends on the surface at an angle whose sine is at least this, its slope tells on which side it lies.
    double leaves_surface = 1e-4;
    // A root is on the surface's border if Domain::beyond() there is this near to 0.
    double on_border = 1e-6;
};
inline constexpr CurveTuning curve_tuning;

} // namespace hrbfnpr::curves
