// SPDX-License-Identifier: MIT
// Constants of lines, plates and pages that were chosen by looking at results.
#pragma once

namespace hrbfnpr::picture {

struct LinesTuning {
    // The support for finding borders if none is given, as in hrbfnpr_line_set_desc. Larger: wider holes between
    // samples stay closed, and the surface reaches farther beyond its last samples.
    double open_support = 3.0;
    // Creases at most this long on average are the facets of a rounded shape, in diagonals of the shape. Larger: more
    // shapes lose their short creases.
    double mean_facet = 0.05;
    // A rounded shape keeps creases longer than this, in diagonals of the shape. Larger: fewer stay.
    double long_crease = 0.06;
    // Lines may be missing if more than this share of the triangles faces away from the surface. Larger: the warning
    // comes later.
    double turned_share = 2e-3;
    // Faces that meet at more than this angle form a crease in a drawing, in degrees. Larger: fewer creases.
    double crease_angle = 30.0;
};
inline constexpr LinesTuning lines_tuning;

struct CutFacesTuning {
    // Ends of outlines meet if they are this near to each other, in lengths of the outline. Larger: wider gaps are
    // closed, and outlines that only pass each other are joined.
    double closed = 1e-3;
    // Ends always meet if they are this near, in units of the points, which is the rounding of single precision.
    double rounding = 1e-6;
    // A hatching has at most this many lines. Larger: finer hatching is possible, and takes longer.
    double most_lines = 1e6;
};
inline constexpr CutFacesTuning cut_faces_tuning;

// The unit of length on a plate is the pen. A pen is at least one pixel and an 800th of the picture's longer side.
struct PlateTuning {
    // The longer side of a picture, in pens. Larger: a finer scale bar, section and hatching.
    double pens = 800.0;
    // The height of the strip below the drawing, in longer sides of the picture. Larger: more paper below the drawing.
    double strip = 0.09;
    // The least height of the strip, in pens. It leaves room for the bar and its figures. Smaller: figures are cut off.
    double least_strip = 44.0;
    // The length limit of the scale bar, in widths of the picture. Larger: a longer bar.
    double longest_bar = 0.3;
    // The thickness of the bar, in pens. Larger: a heavier bar, whose figures stand lower on a page.
    double bar_thickness = 5.0;
    // The width of the bar's outline, in pens. Larger: smaller white fields.
    double bar_line = 0.8;
    // The height of the capitals in the bar's figures, in pens: on a page, and in an image. Larger: larger figures.
    // Above 15, the figures of an image do not fit into the least strip.
    double page_capitals = 11.0;
    double image_capitals = 11.7;
    // The distance from the upper edge of an image's bar to the baseline of its figures, in pens. Larger: figures stand
    // lower.
    double image_baseline = 24.0;
    // The width of a digit of Helvetica, in heights of its capitals. It centres a page's figures below the ends of the
    // bar. Larger: they begin farther to the left.
    double digit_width = 0.78;
    // The distance between the lines of a section's hatching, in pens. Larger: paler sections.
    double hatch_period = 9.0;
    // The width of the lines of a section's hatching, in pens. Larger: darker sections.
    double hatch_line = 0.7;
    // The width of a section's outline, in pens. Larger: a heavier outline.
    double outline = 2.6;
    // The free space beside a section, in widths of the picture. Larger: more paper on both sides of it.
    double margin = 0.05;
    // Marks nearer than this to the section's plane determine the width of the section, in distances of the farthest
    // mark. Larger: parts of the surface away from the plane count as well.
    double near_plane = 0.02;
    // The distance from the section to its camera, in distances of the farthest mark. It only has to be large enough to
    // see all.
    double camera_reach = 4.0;
    // A pixel of the drawn section belongs to a line if it differs from the paper by more than this, out of 255.
    double line_contrast = 64.0;
};
inline constexpr PlateTuning plate_tuning;

struct LetteringTuning {
    // The width of a letter's strokes, in heights of its capitals. Larger: bolder letters.
    double stroke_width = 0.13;
};
inline constexpr LetteringTuning lettering_tuning;

} // namespace hrbfnpr::picture
