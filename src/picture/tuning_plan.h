// SPDX-License-Identifier: MIT
// Numbers that choose the pen, how many marks there are, and how lines are sized.
#pragma once

#include <cstdint>

namespace hrbfnpr::picture {

struct PlanTuning {
    // The radius of the pen is the picture's longer side divided by this, in pixels.  Larger: finer marks, and more of
    // them.  The named styles were made for a radius of 1 pixel at a side of 800.
    double sides_of_pen = 800.0;
    // The radius of the pen is at least this, in pixels.  Smaller: small pictures become grey instead of coarse.
    double least_pen = 0.75;
    // Share of the paper that stipples cover at the darkest tone.  Larger: darker, and more marks.
    double stipple_coverage = 0.8;
    // The same for strokes of one direction.  Larger: less paper between lines where both directions cross.
    double stroke_coverage = 0.55;
    // Distance of the marks of a stroke, in radii of a mark.  Larger: fewer marks, until strokes fall apart into dots.
    double stroke_spacing = 1.25;
    // Lines of hatching, all levels together, along the root of the area.  Larger: hatching that stays even in larger
    // pictures, and more marks.
    double hatch_lines = 300.0;
    // The most marks that a layer gets unless the caller says more.  Each takes about 500 bytes while it is placed and
    // drawn.  Larger: large pictures reach their darkest tone, and need more memory.
    std::int64_t most_marks = 2'000'000;
    // The most refinement steps of the published recursion unless the caller says more; each multiplies the marks by 3
    // or 5.  Larger: darker tones, more memory.
    int most_levels = 6;
    // Radius of the marks of combing that the recursion draws as dots, in pens.  Larger: darker tones.
    float published_dot = 1.1F;
    // Marks of a layer that is not shown, in a style that draws lines.  Larger: the end of the surface is known better,
    // at more time.
    std::int64_t unseen_marks = 4000;
};
inline constexpr PlanTuning plan_tuning;

struct LineStyleTuning {
    // Width of a contour, in pens, in a style that has none of its own.  Larger: wider lines.
    float contour_width = 2.2F;
    // Width of lines other than contours, borders and creases, in widths of the contour.  Larger: they stand out more.
    double fine_width = 0.6;
    // What the width of a line varies by, in `wobble`s that the caller asks for; 1 is the most.  Larger: more uneven
    // lines.
    double width_of_wobble = 0.5;
};
inline constexpr LineStyleTuning line_style_tuning;

} // namespace hrbfnpr::picture
