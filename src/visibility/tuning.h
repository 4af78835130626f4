// SPDX-License-Identifier: MIT
// The tuning constants for the visibility of lines. `scripts/bench lines --only=truth,views,flicker` measures their
// effects.
#pragma once

#include <cstdint>

namespace hrbfnpr::visibility {

struct VisibilityTuning {
    // ---- Surfaces and their own lines, in sides of the mesh

    // A surface does not hide its own contour if it is less than this before the contour, in mesh sides. Larger: a
    // surface just before a line does not hide the line.
    double clearance = 0.02;
    // A surface does not hide a crease if it is less than this before the crease, in mesh sides. This is smaller than
    // `clearance`, because creases are as exact as the sheets, and because a crease may be close to the sheet that
    // hides the crease near its end.
    double crease_clearance = 1e-3;

    // ---- Polylines in the image

    // A cubic is halved at most this many times. Larger: finer polylines near the eye.
    int most_halvings = 8;
    // Places farther from the image's corner than this, in pixels, are left out, because they are too near to the plane
    // through the eye. Larger: coordinates lose digits.
    double farthest_place = 1.0e9;

    // ---- Crossings

    // The least side of a cell of the grid, in pixels. Larger: fewer cells, and more pairs of segments in each.
    double cell_side = 4.0;
    // The grid has at most this many cells. Larger: more memory for large images.
    double most_cells = 1.0e6;
    // Segments farther outside the image than this, in pixels, are put into the outermost cells of the grid.
    double grid_end = 1.0e4;
    // A cell with more crossings per segment than this is a tangle, and its crossings are ignored. In a tangle, lines
    // run back and forth over one another within a pixel, for example contours on a flat face that is seen edge-on.
    int most_crossings_per_segment = 16;
    // A cell with more segments than this is a tangle, too. Larger: more time for tangles.
    int most_segments = 4096;
    // Newton's method takes at most this many steps. It ends when a step is shorter than `newton_tolerance`, in lengths
    // of the piece.
    int newton_steps = 20;
    double newton_tolerance = 1e-10;
    // Two crossings of the same pieces are merged if they are closer than this, in lengths of the piece.
    double same_place = 1e-7;
    // A place may be beyond the end of its piece by this much, in lengths of the piece.
    double end_slack = 1e-8;
    // Two curves that are closer than this at a crossing are the same curve, in mesh sides. Larger: crossings of
    // surfaces that nearly touch are lost.
    double least_gap = 1e-5;
    // If a line crosses itself with a gap smaller than this, in mesh sides, the place is not a crossing but a cusp,
    // where the line turns back. Larger: small loops are lost.
    double least_loop = 0.02;
    // Contours do not cross a border or other line of their surface if the gap is smaller than this, in mesh sides,
    // because their images touch. Larger: crossings are lost.
    double touching_gap = 0.05;

    // ---- Verification of crossings

    // A crossing is verified if the distance of its curves is below this, in mesh sides. Larger: more time.
    double suspicious_gap = 0.5;
    // The search for a crossing on the curves ends after this many rounds, or when a step is shorter than
    // `settled_step` times the gap between the curves.
    int verifying_rounds = 8;
    double settled_step = 0.01;
    // The search fails if it moves a place farther than `farthest_crossing`, or if the gap becomes smaller than
    // `smallest_gap`, both relative to the gap before the search. Larger `farthest_crossing` or smaller `smallest_gap`:
    // crossings that the curves do not have are kept.
    double farthest_crossing = 0.5;
    double smallest_gap = 0.1;

    // ---- Lines that pass through another item's surface

    // If both ends of a piece are outside the region of the surface, it is halved at most this many times. Larger:
    // pieces that only touch the region are found.
    int most_halvings_outside = 6;
    // A line closer to a surface than this lies in the surface, in diagonals of the surface's region.
    double in_surface_distance = 1e-7;

    // ---- Counting

    // Cusps closer than this along a line, in pixels, form a group. On a contradictory line, a part shorter than this
    // gets the sheet count of the part before it. Larger: small swallowtails that can be seen are ignored.
    double unseen_length = 0.25;
    // The branches of a group of cusps cross at most this far from it, in units of `unseen_length`.
    double branch_reach = 8.0;
    // The largest number of rays for each line that is tested for being part of the outline of the drawing.
    int outline_rays = 3;
    // From round to round, the tolerance of the image is multiplied by this.
    double round_factor = 0.1;
    // Curves are refined until they are within this share of the next round's tolerance.
    double refined_tolerance_share = 0.2;
    // Curves are refined only if at most this many lines are contradictory. If there are more, the tolerance of the
    // curves is not the cause. Larger: more time for torn surfaces.
    std::int64_t most_refined_lines = 50;
    // At a doubtful crossing, this many pieces before and after it are also refined, on both curves.
    int pieces_beside_crossing = 2;
};
inline constexpr VisibilityTuning visibility_tuning;

// Rays that prove which places are visible. `scripts/bench technical` measures their effects.
struct SightTuning {
    // A step of a ray is this share of the distance from the surface, as |f| / |grad f| estimates it. Larger: fewer
    // evaluations, and surfaces between two steps may be missed.
    double step_share = 0.6;
    // The shortest and the longest step, in diagonals of the surface. Larger `least_step`: fewer evaluations beside a
    // surface. Larger `longest_step`: thin parts may be missed where |grad f| is small.
    double least_step = 1.0 / 4096.0;
    double longest_step = 1.0 / 48.0;
    // A ray with more steps than this is undecided.
    int most_steps = 2000;
    // A bracket is narrowed until it is shorter than this, in diagonals, and at most this many times.
    double root_tolerance = 1e-6;
    int most_halvings = 40;
    // A ray is in contact with the surface at its place up to this distance from it, in margins. Larger: places may be
    // farther off their surface. Smaller: their own surface may hide them.
    double contact = 0.25;
    // A ray grazes its own solid if it is inside by more than `grazing` while it is in contact, and is doubtful if it
    // is inside by more than `deep`, in distances of contact. Larger `grazing`: ends of hidden lines at contours look
    // visible. Larger `deep`: contours count as visible that are drawn beside their place.
    double grazing = 0.01;
    double deep = 0.25;
    // A place is moved out of its own solid by at most this many steps.
    int most_lifts = 4;
    // A contact that is longer than `long_contact`, in margins, is doubtful if the ray then leaves the surface so
    // steeply that the sine of the angle times the length of the contact is above `sudden`, in distances of contact. On
    // a smooth surface this is 2. Larger: places on faces that are seen edge-on are decided.
    double long_contact = 4.0;
    double sudden = 12.0;
    // Two roots are those of a wall if the cosine of the normals is below `opposite` and the sines of the angles
    // between ray and surface are above `steep`. Then the ray passes through it, even if the wall is thinner than the
    // margin.
    double opposite = -0.7;
    double steep = 0.25;
    // The number of rays that are cast together.
    std::int64_t rays_a_task = 64;
};
inline constexpr SightTuning sight_tuning;

} // namespace hrbfnpr::visibility
