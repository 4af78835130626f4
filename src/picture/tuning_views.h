// SPDX-License-Identifier: MIT
// Constants for technical drawings. They come from standards, or were chosen by looking at results.
#pragma once

#include <cstdint>

namespace hrbfnpr::picture {

// The lines of a view. Tuned on the models bracket, lamp and gargoyle, and on a flanged bush.
struct ViewLinesTuning {
    // The size in mm of a pixel of the drawing from which lines are taken. The lines are exact to a twentieth of a
    // pixel. Larger: faster, with rougher lines.
    double pixel = 0.1;
    // Two parts of a line are joined if the distance of their ends is at most this, in mm. Larger: lines that only pass
    // each other are joined.
    double meet = 0.05;
    // The distance, in mm, between the places on a line from which rays are cast. Larger: faster, and short hidden
    // parts are missed.
    double asked = 0.5;
    // The interval between a hidden place and a visible one is halved this many times. Larger: hidden parts end more
    // exactly.
    int halvings = 4;
    // A ray from an edge of a mesh begins this far outside the surface, in diagonals. The fit may be that far from the
    // edge. Larger: edges in narrow grooves look visible. Smaller: the surface at an edge hides the edge.
    double off_edge = 0.006;
    // A ray from a line on the surface begins this far outside the surface, in diagonals.
    double off_surface = 5e-4;
    // If the model has sharp edges, contours up to this size, in mm, are ripples of the fit. Larger: more contours are
    // left out.
    double smallest_contour = 4.0;
    // Edges with a free end are facets of a rounded shape if their length is at most this, in diagonals. Larger: more
    // edges are left out.
    double shortest_edge = 0.06;
    // Contours closer to an edge than this, in diagonals, exist only because the fit rounds the edge. Larger: more
    // contours are left out.
    double near_edge = 0.005;
    // The distance of the camera from the middle of the model, and its near and far planes, in diagonals. The whole
    // model is between the planes.
    double eye = 2.0;
    double nearest = 0.01;
    double farthest = 4.0;
    // The side of the picture, in diagonals.
    double picture = 1.1;
    // The least side of the picture, in pixels.
    double least_picture = 16.0;
};
inline constexpr ViewLinesTuning view_lines_tuning;

// Rays that show whether the surface is between a place and the eye.
struct SightTuning {
    // The number of steps of a ray across the model. Larger: slower, and thinner walls are seen.
    std::int64_t steps = 128;
    // Where the surface is near, a step is divided into this many parts. Walls thinner than 1 / (steps * finer)
    // diagonals may be missed.
    std::int64_t finer = 12;
    // The surface is near if |f| is less than this, in steps. Larger: slower, and fewer walls are missed.
    double near = 1.5;
    // The number of rays that are cast together. Larger: faster, with more memory.
    std::int64_t at_once = 2000;
    // A surface is open if more than this share of it is removed by trimming. Otherwise it is the surface of a solid.
    double open = 0.01;
    // A surface is a shell if more than this share of it is removed by trimming. Cuts of a shell are lines, and cuts of
    // other surfaces are faces. Larger: cuts of helmets are hatched as if they were solid; smaller: cuts of scans with
    // a hole at the base are not hatched. Set on helmets, car panels, cloth and busts.
    double shell = 0.15;
    // A cut face hides places that are more than this behind it, in diagonals.
    double behind = 1e-3;
    // The last step of a search for a hit is longer by this factor, so that a hit at its end is found.
    double step_room = 1.001;
};
inline constexpr SightTuning sight_tuning;

// Rays that prove which pieces of a view's lines are visible. Lengths are in mm on the paper.
struct ViewProofTuning {
    // A ray is decided if it is farther than this from the outlines of surfaces. Larger: more pieces are undecided.
    // Smaller: the errors of lines, which are up to 0.01 mm, look like wrong pieces.
    double margin = 0.05;
    // Rays go to places at least this far from the ends of a piece, and at most `step` apart. Larger: faster, and short
    // wrong pieces are missed.
    double from_end = 0.15;
    double step = 0.75;
    // The way between two places that differ is halved this many times. Larger: repaired pieces end more exactly.
    int halvings = 7;
    // Repaired pieces are looked at again at most this many times.
    int rounds = 3;
};
inline constexpr ViewProofTuning view_proof_tuning;

// The priority of lines that coincide. Lengths are in mm on the paper.
struct ViewOrderTuning {
    // Nearly parallel lines closer than this are drawn as one line. Larger: fewer double lines, and narrow gaps close.
    double reach = 0.35;
    // Nearly parallel lines that are not sharp edges are drawn as one line if they are closer than this.
    double smooth_reach = 0.8;
    // The distance between places where lines are compared. Larger: faster, with rougher ends.
    double step = 0.15;
    // Pieces that remain between other lines are not drawn if they are shorter than this.
    double shortest_rest = 0.5;
    // Before two lines meet, one may run beside the other for at most this length. Larger: fewer gaps, more double
    // lines.
    double joining = 5.0;
    // Two pieces of a line are joined if the gap is shorter than this, and the cosine of their directions is above
    // `straight`.
    double bridged = 2.0;
    double straight = 0.99;
    // Two directions are the same if they differ by less than this, in degrees.
    double alike_degrees = 25.0;
    // If a part is hidden or visible for less than this length, it takes the state of its neighbours, provided that its
    // ends are farther apart than `onward` times its length. A part that turns back at a cusp keeps its state, because
    // the line continues there like another line.
    double flicker = 2.0;
    double onward = 0.7;
    // Two places of one line count as different lines if their distance along the line is more than this many times the
    // reach.
    double own_part = 4.0;
    // The least lengths that are drawn: of outlines, of hidden lines, and of lines that are not sharp edges.
    double shortest_outline = 0.8;
    double shortest_hidden = 1.2;
    double shortest_smooth = 3.0;
    // The length over which the direction of a line's end is measured.
    double end = 1.0;
};
inline constexpr ViewOrderTuning view_order_tuning;

// Positions on the sheet, in mm.
struct ViewLayoutTuning {
    double left = 20.0;   // The left margin, which is for filing [ISO 5457].
    double margin = 10.0; // the other three margins [ISO 5457]
    // The least free space inside the frame.
    double pad = 6.0;
    double block_width = 180.0; // The size of the title block [ISO 7200].
    double block_height = 24.0;
    double bar_width = 80.0; // The space reserved for the scale bar.
    double bar_height = 16.0;
    // The height of a view's name, including its distance from the view.
    double label = 9.0;
    // The space beside a view for the arrows and letters of a cutting plane.
    double cutting = 17.0;
    // A cutting plane needs space on a side of the view if the cosine between its normal and the direction of the side
    // is above this.
    double cutting_side = 0.3;
    // Two directions are perpendicular if their cosine is below this, and parallel if it is above 1 minus this.
    double along = 1e-6;
};
inline constexpr ViewLayoutTuning view_layout_tuning;

// Marks beside the views, in mm.
struct ViewMarksTuning {
    double capitals = 3.5; // the height of capital letters [ISO 3098]
    double large_capitals = 5.0;
    double small_capitals = 1.8;
    double bar_capitals = 2.5;
    // A cutting plane extends this far beyond the drawing. Its ends are thick over the length `thick_end`.
    double beyond = 6.0;
    double thick_end = 5.0;
    double arrow = 7.0;
    double arrow_head = 3.0;
    double arrow_side = 0.8;
    // A centre line extends this far beyond the drawing.
    double centre_beyond = 3.0;
    // The scale bar fills at most this share of the space reserved for it.
    double longest_bar = 0.75;
    // The height of the capitals of Helvetica, as a share of the font size.
    double capital_share = 0.716;
};
inline constexpr ViewMarksTuning view_marks_tuning;

struct ViewsTuning {
    // Ends of outlines of a cut are the ends of a wall if they are nearer to each other than this share of an outline's
    // length. Larger: outlines of open sheets are closed.
    double wall = 0.03;
    // An open outline of a cut that is shorter than this, in mm, is a ripple of the tracing, and causes no warning.
    double least_outline = 2.0;
    // A plane is a plane of symmetry if nine of ten mirrored samples are at most this far from the surface, in
    // diagonals.
    double symmetric = 0.004;
    double symmetric_percent = 90.0;
    // The number of samples to mirror. Larger: slower, and more reliable.
    std::int64_t mirrored = 1000;
    // The number of marks that are placed only because a frame must have marks. They are not drawn.
    std::int64_t marks = 20;
    // The tolerance between computed and written lines in mm, if the caller gives no page.
    double tolerance = 0.02;
    // Tangent edges end this many widths of an outline before the lines that they would touch. Larger: shorter lines.
    double tangent_gap = 3.0;
    // Planes closer to the middle than this count as in the middle, in diagonals.
    double in_middle = 1e-6;
};
inline constexpr ViewsTuning views_tuning;

} // namespace hrbfnpr::picture
