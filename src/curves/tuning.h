// SPDX-License-Identifier: MIT
// The tuning constants for meshing a surface and for tracing curves on it. Units: a side is the longest side of the
// mesh's cells; a diagonal is the diagonal of the surface's bounds. The constants were chosen with scripts/bench lines
// on fitted scans, knots, tori and bumpy spheres, and on surfaces whose contours are known.
#pragma once

#include <cstdint>

namespace hrbfnpr::curves {

struct CurveTuning {
    // ---- The mesh

    // Two places closer together than this, in sides, count as one place. A place closer than this to the surface or to
    // the wall of the region counts as lying on it. The limit applies to seeds, starts of curves, ends of paths, and
    // crossings of lines with triangles. Larger: fewer evaluations; small loops and close sheets may be missed.
    double close = 1e-3;
    // A seed counts as missed if no vertex of its sheet is within this distance, in sides. Larger: thin parts are
    // reported less often.
    double vertex_reach = 1.5;
    // The middle of a halved edge of given triangles may move by at most this share of the edge's length. Larger:
    // coarse triangles of round shapes are halved, but edges across thin walls are, too.
    double farthest_middle = 0.4;
    // The largest number of rounds in which long edges of given triangles are halved. Larger: coarser triangles are
    // divided as finely as cells, but edges across gaps take longer.
    int most_halvings = 10;
    // Vertices of given triangles move off creases by this share of their distance from the middle of a face. Larger:
    // the triangles become less even. 0: triangles beside a crease are degenerate.
    double off_crease = 0.15;
    // The mesh extends this many sides beyond the end of the surface, if the end is known. Larger: more cells that are
    // later cut away.
    double beyond_end = 2.0;
    // Cell corners closer to the surface than this, in sides, are moved to this distance. All tetrahedra keep their
    // orientation. Larger: fewer slivers, and less regular cells.
    double corner_clearance = 0.05;
    // Root searches on edges, pieces and segments take at most `most_steps` steps. After `trusted_steps` they bisect.
    // Larger trusted_steps: faster where f is smooth, slower where it has kinks.
    int most_steps = 60;
    int trusted_steps = 6;
    // The tolerance of roots: on edges in sides, on pieces of curves in lengths of the piece. Larger: the border and
    // cusps are less exact.
    double exact = 1e-9;
    // The largest distance, in sides, between a cut and the place interpolated from the values at the ends of the edge.
    // Larger: cuts may jump to another part of the border.
    double farthest_cut = 0.35;
    // The number of bisections between two places after Newton's method has failed. `halvings` are made to find a
    // better start of a curve, `cut_halvings` to find the place where a mesh is cut. Larger: more evaluations.
    int halvings = 8;
    int cut_halvings = 30;

    // ---- The surface's end

    // Within this distance from the border, in sides, the end of the surface is tested at each point. Larger: more
    // evaluations of the support.
    double border_reach = 3.0;
    // A place on a sheet also lies on the whole surface if the distance between the place and the whole surface is at
    // most this, in sides. Larger: curves may continue beyond a crease.
    double on_sheet = 1e-7;

    // ---- Newton's steps

    // Newton's method gives up after this many steps. Larger: more evaluations.
    int newton_steps = 12;
    // A step is the last one if it is at most `may_be_last` tolerances long and the next step is predicted to be below
    // `negligible_step` tolerances. Larger: fewer evaluations, points less exact.
    double may_be_last = 5.0;
    double negligible_step = 1e-3;

    // ---- Starts

    // The largest distance, in sides, by which a start may be moved onto a curve. Larger: a start may be moved onto an
    // adjacent curve.
    double start_reach = 1.0;
    // A change of sign is covered if a curve passes within this distance, in sides. Larger: close curves may be missed.
    double covered = 0.35;
    // A start within this distance of a known curve, in sides, belongs to that curve. A run within this distance of a
    // longer run repeats the longer run. Larger: close curves may be missed; smaller: curves are found twice.
    double found_already = 0.02;
    // Around changes of sign without a curve, the mesh is made again with cells smaller by this factor, but with at
    // most `most_cells` along the diagonal of a box. Larger: more time, fewer curves missed.
    double closer = 8.0;
    double most_cells = 128.0;
    // The finer mesh has no cells in blocks that are far from all changes of sign. This is the side of a block in
    // cells. Larger: fewer questions where the changes are, but more cells.
    std::int64_t cells_of_block = 4;
    // If more changes of sign than this have no curve, smaller cells are not tried, because the surface is too
    // irregular for any cells.
    std::int64_t most_lost = 2000;

    // ---- Runs of points

    // The distance between starts, as a share of the longest step. Larger: fewer starts, and more gaps to fill.
    double chosen_apart = 0.65;
    // Points closer together than this count as one point, except where the curve turns. The distance is a share of the
    // longest step. Larger: fewer points.
    double least_run = 0.1;
    // A gap between two points is not filled by halving if it is wider than this, in longest steps. Larger: more gaps
    // are tried.
    double widest_gap = 3.0;
    // A point of the previous view is kept if the curve has turned since the last kept point by this share of the
    // allowed turn. Larger: fewer points.
    double kept_turn = 0.8;
    // The largest angle between the chord of a piece and its tangents, as a share of the allowed turn. On a circular
    // arc, this angle is half of the arc's turn. Larger: cubics may leave the curve.
    double off_chord = 0.75;
    // A gap is halved at most this many times. Its parts are then about as short as `kink_length`.
    int gap_halvings = 10;

    // ---- Following

    // The first step of a path, in sides.
    double first_step = 0.25;
    // The step length is chosen so that a path turns by this share of the allowed turn. Larger: fewer points, more
    // steps that fail.
    double step_safety = 0.7;
    // A step fails if it does not converge within this many corrections.
    int corrector_steps = 5;
    // Corrections end when a correction is shorter than this share of the step. The next correction would be shorter
    // than 1e-6 sides. Points must be so close to the surface, because a ray to a point farther away would cross the
    // surface near the point.
    double converged = 1e-3;
    // A path meets a point if the point's distance from the cubic of a step is at most this share of the step. Larger:
    // paths may end on a close curve.
    double beside = 0.05;
    // A path meets a point only if the cosine of their directions is at least this. Larger: curves may be followed
    // twice at kinks.
    double same_way = 0.7;
    // A path may meet the run it started from only after this many steps.
    std::int32_t fewest_steps_of_loop = 3;
    // Between points closer than `kink_length`, in sides, a curve may turn by up to `sharpest_kink` radians, because
    // the Hessian of a Hermite sum jumps at each sample.
    double kink_length = 2e-3;
    double sharpest_kink = 1.2;

    // ---- Loops between vertices

    // The step for finite differences of grad g, in sides.
    double probe = 0.05;
    // A step towards an extremum of g is at most `longest_search` long. The extremum must be within `farthest_extremum`
    // of the vertex from which it is searched for. Both are in sides. Larger: more evaluations, and extrema that belong
    // to other vertices.
    double longest_search = 0.5;
    double farthest_extremum = 1.5;
    int extremum_steps = 5;
    // A search ends if the predicted |g| at the extremum is above this share of |g| at the vertex, because g then has
    // no zero there. Larger: more evaluations.
    double hopeless = 0.5;

    // ---- Changes along curves

    // A point of a cubic is on the curve if the Newton step there is shorter than this, in lengths of the piece.
    // Larger: fewer evaluations, points less exact.
    double near_curve = 2e-4;
    // A point that moves farther than this from the cubic of its piece belongs to another curve. The distance is in
    // lengths of the piece.
    double astray = 0.3;
    // A piece has no cusp if the sine of the angle between curve and line of sight is above this at both ends, because
    // a piece turns by at most a third of a radian. Larger: more pieces are examined.
    double clear_of_cusps = 0.5;
    // A cusp within `at_end` of an end of its piece replaces that end. A point within `at_point` of the border is on
    // the border. Both are in lengths of the piece.
    double at_end = 1e-2;
    double at_point = 1e-6;
    // A piece is halved at most `deepest_piece` times, and at most `most_added` points are added per piece on average.
    // Only an eye on the surface would need more.
    int deepest_piece = 12;
    std::int64_t most_added = 16;

    // ---- Sheets between two points

    // The least bound for the distance of the surface from a triangle, in sides. Larger: longer spans, more
    // evaluations.
    double least_bulge = 0.02;
    // The distance between the places of a span at which f is evaluated first, in sides. Larger: pairs of roots may be
    // missed.
    double place_spacing = 0.5;
    // Two spans are merged if the gap between them is smaller than this, in sides.
    double span_gap = 0.05;
    // A place within this distance of the surface, in diagonals, counts as lying on the surface, because the errors of
    // prepared evaluation are about 1e-9.
    double root_noise = 1e-9;
    // A segment touches the surface if it is within `touching` of it, in diagonals, and the sine of the angle between
    // them is below `along_surface`. Larger: more answers are uncertain.
    double touching = 2e-8;
    double along_surface = 0.02;
    // If a segment ends on the surface, the slope of f along the segment tells whether f is positive or negative just
    // inside the segment. This is certain if the sine of the angle between the segment and the surface is at least
    // this.
    double leaves_surface = 1e-4;
    // A root is on the border of the surface if |Domain::beyond()| there is at most this.
    double on_border = 1e-6;

    // ---- Rays

    // The largest number of Newton's steps from the mesh to the surface. Larger: fewer rays are searched without the
    // mesh.
    std::int32_t most_ray_steps = 12;
};
inline constexpr CurveTuning curve_tuning;

} // namespace hrbfnpr::curves
