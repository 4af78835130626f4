// SPDX-License-Identifier: MIT
// Constants of technical drawings, chosen by looking at results or given by standards.
#pragma once

#include <cstdint>

namespace hrbfnpr::picture {

// The lines of a view. Tuned on bracket, a flanged bush, lamp, gargoyle.
struct ViewLinesTuning {
    // The size in mm of a pixel of the drawings that supply the lines, which are exact to a twentieth of it. Larger:
    // faster, with rougher lines.
    double pixel = 0.1;
    // Parts of a line are joined if their ends are this near, in mm. Larger: lines that only pass each other are
    // joined.
    double meet = 0.05;
    // Rays are cast from places on a line this far apart, in mm. Larger: faster, and short hidden parts are missed.
    double asked = 0.5;
    // The interval between a hidden place and a visible one is halved this many times. Larger: hidden parts end more
    // exactly.
    int halvings = 4;
    // A ray from an edge of a mesh begins this far outside the surface, in diagonals, because the fit may be that far
    // from the edge. Larger: edges in narrow grooves look visible. Smaller: edges hide themselves.
    double off_edge = 0.006;
    // A ray from a line on the surface itself begins this far outside the surface, in diagonals.
    double off_surface = 5e-4;
    // Contours up to this size, in mm, are ripples of the fit if the model has sharp edges. Larger: more contours are
    // left out.
    double smallest_contour = 4.0;
    // Edges with a free end are facets of a rounded shape up to this length, in diagonals. Larger: more edges are left
    // out.
    double shortest_edge = 0.06;
    // Contours nearer to an edge than this are its rounding by the fit, in diagonals. Larger: more contours are left
    // out.
    double near_edge = 0.005;
    // The distance of the camera, and the depths between which it sees, in diagonals. The whole model lies between
    // them.
    double eye = 2.0;
    double nearest = 0.01;
    double farthest = 4.0;
    // The side of the picture, in diagonals.
    double picture = 1.1;
    // The least side of the picture, in pixels.
    double least_picture = 16.0;
};
inline constexpr ViewLinesTuning view_lines_tuning;

// Rays that tell whether something lies between a place and the eye.
struct SightTuning {
    // A ray crosses the model in this many steps. Larger: slower, and thinner walls are seen.
    std::int64_t steps = 128;
    // A step where the surface comes near is divided into this many parts. Walls thinner than 1 / (steps * finer)
    // diagonals may be missed.
    std::int64_t finer = 12;
    // The surface is near if f is less than this, in steps. Larger: slower, and fewer walls are missed.
    double near = 1.5;
    // This many rays are cast at a time. Larger: faster, with more memory.
    std::int64_t at_once = 2000;
    // A surface is open if more than this share of it is removed. Otherwise the removed surface belongs to a solid.
    double open = 0.01;
    // A cut face hides places that lie farther than this beyond it, in diagonals.
    double behind = 1e-3;
    // A hit is searched for in this multiple of a step, so that a hit at its end is found.
    double step_room = 1.001;
};
inline constexpr SightTuning sight_tuning;

// Priority among coinciding lines. Lengths are mm on the paper.
struct ViewOrderTuning {
    // Nearly parallel lines nearer than this are one line. Larger: fewer double lines, and narrow gaps close.
    double reach = 0.35;
    // Nearly parallel lines that are not sharp are one line if they are nearer than this.
    double smooth_reach = 0.8;
    // The distance between the places of a line that are compared. Larger: faster, with rougher ends.
    double step = 0.15;
    // Pieces between other lines that are shorter than this are not drawn.
    double shortest_rest = 0.5;
    // A line runs beside another for at most this length before they meet. Larger: fewer gaps, more double lines.
    double joining = 5.0;
    // Pieces that continue each other are joined over a shorter gap than this, if the cosine of their directions is
    // above `straight`.
    double bridged = 2.0;
    double straight = 0.99;
    // Directions are the same if they differ by less than this, in degrees.
    double alike_degrees = 25.0;
    // A part that is hidden or visible for less than this length takes the state of its neighbours, if its ends are
    // farther apart than `onward` of its length. A part that turns back at a cusp keeps its state, because the line
    // continues like another line.
    double flicker = 2.0;
    double onward = 0.7;
    // Places of one line count as different lines if they are farther apart than this along it, in reaches.
    double own_part = 4.0;
    // The shortest parts that are drawn: of outlines, of hidden lines, of lines that are not sharp.
    double shortest_outline = 0.8;
    double shortest_hidden = 1.2;
    double shortest_smooth = 3.0;
    // The direction of a line's end is measured over this length.
    double end = 1.0;
};
inline constexpr ViewOrderTuning view_order_tuning;

// Places on the sheet, in mm.
struct ViewLayoutTuning {
    double left = 20.0;   // the margin on the left, for filing [ISO 5457]
    double margin = 10.0; // the margin on the other sides [ISO 5457]
    // The least free space inside the frame.
    double pad = 6.0;
    double block_width = 180.0; // The size of the title block [ISO 7200].
    double block_height = 24.0;
    double bar_width = 80.0; // The space that is kept free for the scale bar.
    double bar_height = 16.0;
    // The height of a view's name, including the distance to it.
    double label = 9.0;
    // The width of the arrows and letters of a cutting plane, beside a view.
    double cutting = 17.0;
    // A cutting plane needs this room on a side if the cosine between its normal and that side is above this.
    double cutting_side = 0.3;
    // Directions are perpendicular if their cosine is below this, and parallel if it is above 1 minus this.
    double along = 1e-6;
};
inline constexpr ViewLayoutTuning view_layout_tuning;

// Marks beside the views, in mm.
struct ViewMarksTuning {
    double capitals = 3.5; // [ISO 3098]
    double large_capitals = 5.0;
    double small_capitals = 1.8;
    double bar_capitals = 2.5;
    // A cutting plane reaches this far beyond the drawing. Its ends are thick over the length `thick_end`.
    double beyond = 6.0;
    double thick_end = 5.0;
    double arrow = 7.0;
    double arrow_head = 3.0;
    double arrow_side = 0.8;
    // A centre line reaches this far beyond the drawing.
    double centre_beyond = 3.0;
    // The scale bar takes at most this share of its room.
    double longest_bar = 0.75;
    // The height of the capitals of Helvetica, as a share of the font size.
    double capital_share = 0.716;
};
inline constexpr ViewMarksTuning view_marks_tuning;

struct ViewsTuning {
    // Open outlines of a cut shorter than this, in mm, are ripples of the tracing, and cause no warning.
    double least_outline = 2.0;
    // A plane is one of symmetry if nine of ten mirrored samples are this near to the surface, in diagonals.
    double symmetric = 0.004;
    double symmetric_percent = 90.0;
    // This many samples are mirrored. Larger: slower, and more reliable.
    std::int64_t mirrored = 1000;
    // A frame must have some marks. This many are placed, but none is drawn.
    std::int64_t marks = 20;
    // The tolerance between drawn and written lines if the caller gives no page, in mm.
    double tolerance = 0.02;
    // Planes this near to the middle count as in the middle, in diagonals.
    double in_middle = 1e-6;
};
inline constexpr ViewsTuning views_tuning;

} // namespace hrbfnpr::picture
