// SPDX-License-Identifier: MIT
// The tuning constants of the visibility of lines. scripts/bench lines --only=truth,views,flicker measures
// their effects.
#pragma once

#include <cstdint>

namespace hrbfnpr::visibility {

struct VisibilityTuning {
    // ---- Surfaces and their own lines, in sides of the mesh

    // Surface nearer than this before a contour of its own does not hide it. Larger: what hides a line just before it
    // is missed.
    double clear = 0.02;
    // The same of creases, which are as exact as sheets are: beside their ends the sheet that hides them is near.
    double clear_of_creases = 1e-3;

    // ---- Polylines in the image

    // A cubic is halved at most this many times. Larger: finer polylines beside the eye.
    int deepest = 8;
    // Places seen farther from the image's corner than this are left out, in pixels: they are too near to the plane of
    // the eye. Larger: numbers lose digits.
    double farthest = 1.0e9;

    // ---- Crossings

    // The least side of a cell of the grid, in pixels. Larger: fewer cells and more pairs of segments in each.
    double cell_side = 4.0;
    // The grid has at most this many cells. Larger: more memory for large images.
    double most_cells = 1.0e6;
    // Segments farther outside than this are in the grid's last cells, in pixels.
    double grid_end = 1.0e4;
    // A cell is a tangle, and has no crossings, where it has more than this many for each of its segments: there lines
    // run to and fro over one another within a pixel, as contours on a flat face do that is seen edge-on.
    int most_of_segment = 16;
    // The same for a cell of more segments than this. Larger: more time for tangles.
    int most_segments = 4096;
    // Newton's method takes at most this many steps, and ends by a step of less than `known` pieces.
    int newton_steps = 20;
    double known = 1e-10;
    // Crossings of one pair of pieces that are nearer than this are one, in pieces.
    double same_place = 1e-7;
    // A place may lie beyond the end of its piece by this much, in pieces.
    double slack = 1e-8;
    // Curves whose distance at a crossing is less than this are the same, in sides of the mesh. Larger: crossings of
    // surfaces that nearly touch are lost.
    double least_gap = 1e-5;
    // The least distance of a line from itself, which turns back at a cusp. Larger: small loops are lost.
    double least_loop = 0.02;
    // The least distance of a border or another line from the contours of its own surface, which touch its image.
    double touching = 0.05;

    // ---- Verification of crossings

    // Crossings of curves that are nearer to each other than this are verified, in sides of the mesh. Larger: more
    // time.
    double suspicious_gap = 0.5;
    // The search for a crossing on the curves ends after this many rounds, or by steps shorter than `settled` gaps
    // between the curves.
    int verifying_rounds = 8;
    double settled = 0.01;
    // It fails where it leads farther than this, or where the gap shrinks to less than `smallest_gap`, in gaps. Larger
    // and smaller: crossings are kept that the curves do not have.
    double farthest_crossing = 0.5;
    double smallest_gap = 0.1;

    // ---- Lines that pass through another item's surface

    // A piece whose ends are both outside the surface's region is halved at most this many times. Larger: a piece that
    // only touches the region is not missed.
    int deepest_outside = 6;
    // A line that is nearer than this to a surface lies in it, in diagonals of the surface's region.
    double in_surface = 1e-7;

    // ---- Counting

    // Cusps that are nearer to each other than this along a line are one group, in pixels; so is a shorter part as the
    // part before it. Larger: small swallowtails, which are seen, count for less.
    double unseen = 0.25;
    // Branches of such a group cross within this many times `unseen`.
    double branches = 8.0;
    // The rays for each line whose outline is wanted.
    int outline_rays = 3;
    // The tolerance of the image in each round, in that of the round before.
    double finer = 0.1;
    // Curves that are made finer are off by at most this many tolerances of the next round's image.
    double off_curve = 0.2;
    // Curves are made finer where at most this many lines contradict themselves. Where more do, the curves' tolerance
    // is not the cause. Larger: more time for torn surfaces.
    std::int64_t most_torn = 50;
    // This many pieces of a curve before and after one with a doubtful crossing are made finer with it.
    int beside_crossing = 2;
};
inline constexpr VisibilityTuning visibility_tuning;

} // namespace hrbfnpr::visibility
