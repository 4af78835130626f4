// SPDX-License-Identifier: MIT
// The tuning constants for the visibility of lines. `scripts/bench lines --only=truth,views,flicker` measures their
// effects.
#pragma once

#include <cstdint>

namespace hrbfnpr::visibility {

struct VisibilityTuning {
    // ---- Surfaces and their own lines, in sides of the mesh

    // A surface does not hide its own contours where it is nearer than this before them. Larger: surfaces just before a
    // line do not hide it.
    double clearance = 0.02;
    // `clearance` for creases. They are as exact as the sheets, and the sheet that hides a crease is near it beside its
    // ends.
    double crease_clearance = 1e-3;

    // ---- Polylines in the image

    // A cubic is halved at most this many times. Larger: finer polylines beside the eye.
    int most_halvings = 8;
    // Places seen farther than this from the image's corner are left out, in pixels. They are too near to the plane
    // through the eye. Larger: coordinates lose digits.
    double farthest_place = 1.0e9;

    // ---- Crossings

    // The least side of a cell of the grid, in pixels. Larger: fewer cells, and more pairs of segments in each.
    double cell_side = 4.0;
    // The grid has at most this many cells. Larger: more memory for large images.
    double most_cells = 1.0e6;
    // Segments farther outside the image than this, in pixels, are put into the outermost cells of the grid.
    double grid_end = 1.0e4;
    // A cell with more than this many crossings per segment is a tangle, and its crossings are ignored. In a tangle
    // lines run to and fro over one another within a pixel, as contours do on a flat face that is seen edge-on.
    int most_crossings_per_segment = 16;
    // A cell with more segments than this is a tangle, too. Larger: more time for tangles.
    int most_segments = 4096;
    // Newton's method takes at most this many steps, and ends when a step is shorter than `newton_tolerance`, in
    // pieces.
    int newton_steps = 20;
    double newton_tolerance = 1e-10;
    // Crossings of one pair of pieces are merged where they are nearer to each other than this, in pieces.
    double same_place = 1e-7;
    // A place may lie beyond the end of its piece by this much, in pieces.
    double end_slack = 1e-8;
    // Curves that are nearer than this to each other at a crossing are the same curve, in sides of the mesh. Larger:
    // crossings of surfaces that nearly touch are lost.
    double least_gap = 1e-5;
    // If a line crosses itself with a smaller gap than this, in mesh sides, it is no crossing: the line turns back at a
    // cusp. Larger: small loops are lost.
    double least_loop = 0.02;
    // `least_gap` for a border or another line and the contours of its own surface, since their images touch.
    double touching_gap = 0.05;

    // ---- Verification of crossings

    // A crossing is verified if the distance of its curves is below this, in mesh sides. Larger: more time.
    double suspicious_gap = 0.5;
    // The search for a crossing on the curves ends after this many rounds, or when a step is shorter than
    // `settled_step`, in gaps between the curves.
    int verifying_rounds = 8;
    double settled_step = 0.01;
    // The search fails where it moves a place farther than `farthest_crossing`, or where the gap shrinks below
    // `smallest_gap`, both in gaps. Larger and smaller: crossings are kept that the curves do not have.
    double farthest_crossing = 0.5;
    double smallest_gap = 0.1;

    // ---- Lines that pass through another item's surface

    // A piece whose ends are both outside the surface's region is halved at most this many times. Larger: pieces that
    // only touch the region are found.
    int most_halvings_outside = 6;
    // A line nearer than this to a surface lies in the surface, in diagonals of the surface's region.
    double in_surface_distance = 1e-7;

    // ---- Counting

    // Cusps nearer than this to each other along a line form a group, in pixels. In a contradictory line, a part
    // shorter than this takes the number of the part before it. Larger: small swallowtails that can be seen are
    // ignored.
    double unseen_length = 0.25;
    // The branches of a group of cusps cross at most this many times `unseen_length` away from it.
    double branch_reach = 8.0;
    // Each line whose outline is wanted gets at most this many rays.
    int outline_rays = 3;
    // Each round multiplies the tolerance of the image by this.
    double round_factor = 0.1;
    // Curves are refined to this share of the next round's tolerance.
    double refined_tolerance_share = 0.2;
    // Curves are refined only if at most this many lines contradict themselves. If there are more, the tolerance of the
    // curves is not the cause. Larger: more time for torn surfaces.
    std::int64_t most_refined_lines = 50;
    // Around a doubtful crossing, this many pieces before and after it on both curves are refined, too.
    int pieces_beside_crossing = 2;
};
inline constexpr VisibilityTuning visibility_tuning;

} // namespace hrbfnpr::visibility
