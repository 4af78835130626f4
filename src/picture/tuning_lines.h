// SPDX-License-Identifier: MIT
// Constants for lines, plates and pages. They were chosen by looking at results.
#pragma once

namespace hrbfnpr::picture {

struct LinesTuning {
    // The support at which a border is found, if the caller gives none, as in hrbfnpr_line_set_desc. Larger: wider
    // holes between samples stay closed, and the surface reaches farther beyond its last samples.
    double open_support = 3.0;
    // If the mean length of a shape's creases is at most this, in diagonals of the shape, they are only the facets of a
    // rounded shape. Larger: more shapes lose their short creases.
    double mean_facet = 0.05;
    // Creases longer than this, in diagonals of the shape, are kept even on a rounded shape. Larger: fewer are kept.
    double long_crease = 0.06;
    // If more than this share of the triangles faces away from the surface, a warning says that lines may be missing.
    // Larger: fewer warnings.
    double turned_share = 2e-3;
    // A drawing has a crease where faces meet at more than this angle, in degrees. Larger: fewer creases.
    double crease_angle = 30.0;
    // A piece of a tangent edge is a chord of an arc if the edge turns by less than `arc_turn` degrees at its ends, and
    // the shorter of two pieces is longer than this share of the longer one. Larger turns: coarser circles become
    // round, and so do the corners of blunt polygons. Larger share: fewer uneven arcs become round.
    double arc_turn = 31.0;
    double arc_pieces = 0.5;
    // Each round halves the chords. Larger: smoother arcs of more points.
    int arc_rounds = 2;
};
inline constexpr LinesTuning lines_tuning;

struct CutFacesTuning {
    // Two ends of outlines are joined if their distance is at most this share of the outline's length. Larger: wider
    // gaps are closed, and outlines that only pass each other are joined.
    double closed = 1e-3;
    // Two ends of outlines are always joined if their distance is at most this, in units of the points. It allows for
    // rounding in single precision.
    double rounding = 1e-6;
    // A cut face has at most this many hatch lines. Larger: finer hatching is possible, and takes longer.
    double most_lines = 1e6;
};
inline constexpr CutFacesTuning cut_faces_tuning;

// Lengths on a plate are in pens. A pen is an 800th of the picture's longer side, but at least one pixel.
struct PlateTuning {
    // The number of pens in the longer side of a picture. Larger: a finer scale bar, section and hatching.
    double pens = 800.0;
    // The height of the strip below the drawing, as a share of the picture's longer side. Larger: more paper below the
    // drawing.
    double strip = 0.09;
    // The least height of the strip, in pens. The bar and its figures need it. Smaller: figures are cut off.
    double least_strip = 44.0;
    // The largest length of the scale bar, in widths of the picture. Larger: a longer bar.
    double longest_bar = 0.3;
    // The thickness of the bar, in pens. Larger: a heavier bar, with its figures lower on a page.
    double bar_thickness = 5.0;
    // The width of the bar's outline, in pens. Larger: smaller white fields.
    double bar_line = 0.8;
    // The height of the figures at the bar, in pens: on a page, and in an image. Larger: larger figures. Above 15, an
    // image's figures do not fit into the least strip.
    double page_capitals = 11.0;
    double image_capitals = 11.7;
    // In an image, the distance from the upper edge of the bar to the baseline of its figures, in pens. Larger: lower
    // figures.
    double image_baseline = 24.0;
    // The width of a Helvetica digit, in heights of capitals. It is used to centre a page's figures below the ends of
    // the bar. Larger: the figures move to the left.
    double digit_width = 0.78;
    // The distance between the lines of a section's hatching, in pens. Larger: paler sections.
    double hatch_period = 9.0;
    // The width of the lines of a section's hatching, in pens. Larger: darker sections.
    double hatch_line = 0.7;
    // The width of a section's outline, in pens. Larger: a heavier outline.
    double outline = 2.6;
    // The empty space on each side of a section, in widths of the picture. Larger: more empty paper.
    double margin = 0.05;
    // The section is as wide as the marks near its plane. A mark is near if its distance from the plane is less than
    // this share of the distance of the mark farthest from the plane. Larger: parts of the surface away from the plane
    // widen the section.
    double near_plane = 0.02;
    // The distance from the section to its camera, divided by the distance of the farthest mark from the model's
    // middle. It must be large enough for the camera to see all marks.
    double camera_reach = 4.0;
    // A pixel of the drawn section is on a line if it differs from the paper by more than this, of 255.
    double line_contrast = 64.0;
};
inline constexpr PlateTuning plate_tuning;

struct LetteringTuning {
    // The width of a letter's strokes, in heights of its capitals. Larger: bolder letters.
    double stroke_width = 0.13;
};
inline constexpr LetteringTuning lettering_tuning;

} // namespace hrbfnpr::picture
