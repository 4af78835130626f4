// SPDX-License-Identifier: MIT
// Constants of technical drawings that were chosen by looking at results, and those that standards give.
#pragma once

#include <cstdint>

namespace hrbfnpr::picture {

// Which lines a view has.  Set on bracket, a flanged bush, lamp, gargoyle.
struct ViewLinesTuning {
    // Millimetres of a pixel of the drawings that lines come from, which are exact to a twentieth of it.  Larger:
    // faster, with rougher lines.
    double pixel = 0.1;
    // Parts of a line are joined if their ends are this near, in mm.  Larger: lines that only pass each other are
    // joined.
    double meet = 0.05;
    // Rays are cast from places of a line that are this far apart, in mm.  Larger: faster, and short hidden parts are
    // missed.
    double asked = 0.5;
    // Halvings of the way between two such places, one hidden and one not.  Larger: hidden parts end more exactly.
    int halvings = 4;
    // A ray from an edge of a mesh begins this far outside the surface, in diagonals: the fit may be as far from the
    // edge.  Larger: edges in narrow grooves look visible.  Less: edges hide themselves.
    double off_edge = 0.006;
    // The same for lines that lie on the surface itself.
    double off_surface = 5e-4;
    // Of a model with sharp edges, contours that are not larger than this are ripples of the fit, in mm.  Larger: more
    // contours are left out.
    double smallest_contour = 4.0;
    // Edges with a free end that are not longer than this are facets of a rounded shape, in diagonals.  Larger: more
    // edges are left out.
    double shortest_edge = 0.06;
    // Contours beside an edge that are nearer than this are its rounding by the fit, in diagonals.  Larger: more
    // contours are left out.
    double near_edge = 0.005;
    // Where the camera stands and how far it sees, in diagonals: all of the model lies between.
    double eye = 2.0;
    double nearest = 0.01;
    double farthest = 4.0;
    // Side of the picture, in diagonals.
    double picture = 1.1;
    // The least side of the picture, in pixels.
    double least_picture = 16.0;
};
inline constexpr ViewLinesTuning view_lines_tuning;

// Rays that tell whether something lies between a place and the eye.
struct SightTuning {
    // Steps of a ray across the model.  Larger: slower, and thinner walls are seen.
    std::int64_t steps = 128;
    // Parts of a step where the surface comes near.  Walls thinner than 1 / (steps * finer) diagonals may be missed.
    std::int64_t finer = 12;
    // The surface is near if f is less than this, in steps.  Larger: slower, and fewer walls are missed.
    double near = 1.5;
    // Rays that are asked for at a time: memory against speed.
    std::int64_t at_once = 2000;
    // A surface of which more than this share is left out is open; else what is left out is of a solid's surface.
    double open = 0.01;
    // What lies farther than this behind a cut face is hidden by it, in diagonals.
    double behind = 1e-3;
    // A hit is looked for in this part of a step, so that one at its end is found.
    double step_room = 1.001;
};
inline constexpr SightTuning sight_tuning;

// Which of the lines that coincide is drawn.  Lengths are mm on the paper.
struct ViewOrderTuning {
    // Lines that are as good as parallel and nearer than this are one line.  Larger: fewer double lines, and
    // narrow gaps close.
    double reach = 0.35;
    // The same for lines that are not sharp.
    double smooth_reach = 0.8;
    // Distance of the places of a line that are compared.  Larger: faster, with rougher ends.
    double step = 0.15;
    // Pieces that are left between other lines and shorter are not drawn.
    double shortest_rest = 0.5;
    // A line runs on beside another for at most this before they meet.  Larger: fewer gaps, more double lines.
    double joining = 5.0;
    // Pieces that go on as one after a shorter gap become one, if the cosine of their directions is above `straight`.
    double bridged = 2.0;
    double straight = 0.99;
    // Directions count as one if they differ by less than this, in degrees.
    double alike_degrees = 25.0;
    // Parts that are hidden, or not, for less than this are as the line is before and after them, unless they get on by
    // less than `onward` of their length: a line that turns back at a cusp goes on as another line does.
    double flicker = 2.0;
    double onward = 0.7;
    // A line may come near to itself beyond this distance along it, in reaches.
    double own_part = 4.0;
    // The shortest parts that are drawn: of outlines, of hidden lines, of lines that are not sharp.
    double shortest_outline = 0.8;
    double shortest_hidden = 1.2;
    double shortest_smooth = 3.0;
    // A line's end has the direction of its last millimetres, so many of them.
    double end = 1.0;
};
inline constexpr ViewOrderTuning view_order_tuning;

// Places on the sheet, in mm.
struct ViewLayoutTuning {
    double left = 20.0;   // beside the frame, for filing [ISO 5457]
    double margin = 10.0; // on its other sides [ISO 5457]
    // Free inside the frame, at least.
    double pad = 6.0;
    double block_width = 180.0; // of the title block [ISO 7200]
    double block_height = 24.0;
    double bar_width = 80.0; // kept free for the scale bar
    double bar_height = 16.0;
    // Height of a view's name, with the distance to it.
    double label = 9.0;
    // Width of the arrows and letters of a cutting plane, beside a view.
    double cutting = 17.0;
    // A cutting plane needs this room on a side that its normal is nearer to than this cosine.
    double cutting_side = 0.3;
    // Cosine of directions that are at right angles, and 1 less it of those that are parallel.
    double along = 1e-6;
};
inline constexpr ViewLayoutTuning view_layout_tuning;

// What stands beside the views, in mm.
struct ViewMarksTuning {
    double capitals = 3.5; // [ISO 3098]
    double large_capitals = 5.0;
    double small_capitals = 1.8;
    double bar_capitals = 2.5;
    // A cutting plane reaches this far beyond the drawing, and its ends are thick for `thick_end`.
    double beyond = 6.0;
    double thick_end = 5.0;
    double arrow = 7.0;
    double arrow_head = 3.0;
    double arrow_side = 0.8;
    // A centre line reaches this far beyond the drawing.
    double centre_beyond = 3.0;
    // The longest scale bar, as a share of the room for it.
    double longest_bar = 0.75;
    // Height of capitals of Helvetica, as a share of its size.
    double capital_share = 0.716;
};
inline constexpr ViewMarksTuning view_marks_tuning;

struct ViewsTuning {
    // Outlines of a cut that are not closed and shorter than this are ripples of the tracing, and not warned of; in mm.
    double least_outline = 2.0;
    // A plane is one of symmetry if nine of ten mirrored samples are this near to the surface, in diagonals.
    double symmetric = 0.004;
    double symmetric_percent = 90.0;
    // Samples that are mirrored.  Larger: slower, and surer.
    std::int64_t mirrored = 1000;
    // Marks that are placed for a frame, which has to have some: none is drawn.
    std::int64_t marks = 20;
    // Between what is drawn and what is written where the caller gives no page, in mm.
    double tolerance = 0.02;
    // Planes this near to the middle are in the middle, in diagonals.
    double in_middle = 1e-6;
};
inline constexpr ViewsTuning views_tuning;

} // namespace hrbfnpr::picture
