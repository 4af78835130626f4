// SPDX-License-Identifier: MIT
// Constants of lines, plates and pages that were chosen by looking at results.
#pragma once

namespace hrbfnpr::picture {

struct LinesTuning {
    // The support with which a border is looked for where nobody gives one, as of hrbfnpr_line_set_desc.  Larger: wider
    // holes between samples stay closed, and the surface reaches farther beyond its last samples.
    double open_support = 3.0;
    // Creases are the facets of a rounded shape if they are this long on average, in diagonals of the shape.  Larger:
    // more shapes lose their short creases.
    double mean_facet = 0.05;
    // Such a shape keeps the creases that are longer than this, in diagonals of the shape.  Larger: fewer stay.
    double long_crease = 0.06;
    // Lines may be missing if a larger share of the triangles than this looks away from the surface.  Larger: the
    // warning comes later.
    double turned_share = 2e-3;
    // Faces that meet at more than this are a crease in a drawing, in degrees.  Larger: fewer creases.
    double crease_angle = 30.0;
};
inline constexpr LinesTuning lines_tuning;

struct CutFacesTuning {
    // Ends of outlines meet if they are this near to each other, in lengths of the outline.  Larger: wider gaps are
    // closed, and outlines that only pass each other are joined.
    double closed = 1e-3;
    // And they meet if they are this near in any case, in units of the points: the rounding of single precision.
    double rounding = 1e-6;
    // The most lines of one hatching.  Larger: finer hatching is made, and takes longer.
    double most_lines = 1e6;
};
inline constexpr CutFacesTuning cut_faces_tuning;

// Lengths of a plate are in pens, and a pen is at least one pixel and an 800th of the picture's longer side.
struct PlateTuning {
    // The longer side of a picture in pens.  Larger: a finer scale bar, section and hatching.
    double pens = 800.0;
    // Height of the strip below the drawing, in longer sides of the picture.  Larger: more paper below it.
    double strip = 0.09;
    // The least height of the strip, in pens: room for the bar and its figures.  Less: figures are cut off.
    double least_strip = 44.0;
    // The longest scale bar, in widths of the picture.  Larger: a longer bar.
    double longest_bar = 0.3;
    // Thickness of the bar, in pens.  Larger: a heavier bar, whose figures stand lower on a page.
    double bar_thickness = 5.0;
    // Width of the bar's outline, in pens.  Larger: smaller white fields.
    double bar_line = 0.8;
    // Height of the capitals of its figures, in pens: on a page, and of an image.  Larger: larger figures; those of an
    // image leave the least strip above 15.
    double page_capitals = 11.0;
    double image_capitals = 11.7;
    // From the upper edge of an image's bar to the baseline of its figures, in pens.  Larger: figures stand lower.
    double image_baseline = 24.0;
    // Width of a digit of Helvetica, in heights of its capitals: by it a page's figures stand below the bar's
    // ends.  Larger: they begin farther to the left.
    double digit_width = 0.78;
    // From line to line of a section's hatching, in pens.  Larger: paler sections.
    double hatch_period = 9.0;
    // Width of these lines, in pens.  Larger: darker sections.
    double hatch_line = 0.7;
    // Width of a section's outline, in pens.  Larger: a heavier outline.
    double outline = 2.6;
    // Free beside a section, in widths of the picture.  Larger: more paper on both sides of it.
    double margin = 0.05;
    // Marks are near the section's plane if they are nearer than this, in distances of the farthest.  The section's
    // width is theirs.  Larger: a width that the surface has elsewhere only counts as well.
    double near_plane = 0.02;
    // From the section to its camera, in distances of the farthest mark.  Nothing depends on it but that all is seen.
    double camera_reach = 4.0;
    // A pixel of the drawn section belongs to a line if it differs by more than this from the paper, of 255.
    double line_contrast = 64.0;
};
inline constexpr PlateTuning plate_tuning;

struct LetteringTuning {
    // Width of a letter's strokes, in heights of its capitals.  Larger: bolder letters.
    double stroke_width = 0.13;
};
inline constexpr LetteringTuning lettering_tuning;

} // namespace hrbfnpr::picture
