// SPDX-License-Identifier: MIT
// Constants for choosing the pen, the number of marks, and the width of lines.
#pragma once

#include <cstdint>

namespace hrbfnpr::picture {

struct PlanTuning {
    // The pen's radius, in pixels, is the picture's longer side divided by this. Named styles are made for a radius of
    // 1 pixel and a side of 800. Larger: finer and more marks.
    double sides_of_pen = 800.0;
    // The least radius of the pen, in pixels. Smaller: small pictures become grey instead of coarse.
    double least_pen = 0.75;
    // Stipples cover this share of the paper at the darkest tone. Larger: darker, and more marks.
    double stipple_coverage = 0.8;
    // The distance between hatching lines of all levels is the square root of the surface's area, divided by this.
    // Larger: hatching stays even in larger pictures, and needs more marks.
    double hatch_lines = 300.0;
    // The largest number of marks in a layer, unless the caller gives a budget. Each mark takes about 500 bytes while
    // it is placed and drawn. Larger: large pictures reach their darkest tone, and need more memory.
    std::int64_t most_marks = 2'000'000;
    // The largest number of refinement steps of the published recursion, unless the caller gives a budget. Each step
    // multiplies the marks by 3 or 5. Larger: darker tones, more memory.
    int most_levels = 6;
    // The limits of hrbfnpr_layer_desc. Notes advise no larger numbers.
    double largest_budget = 1e8;
    double largest_levels = 12.0;
    // The radius of the dots that draw published strokes, in pens. Larger: darker tones.
    float published_dot = 1.1F;
    // The share of published strokes that the style "full" draws together with its stipples. Larger: more strokes in
    // light tones.
    float published_share_of_full = 0.6F;
    // The number of marks in a layer that a style does not show because it draws only lines. Larger: the end of the
    // surface is known better, in more time.
    std::int64_t unseen_marks = 4000;
    // The number of rays by which a mark sees the sky. Larger: less noise in hollows, in more time.
    std::int32_t sky_rays = 32;
    // The intensity of the second and further lights of "style.light", if it is not given. Larger: flatter forms.
    float second_light = 0.5F;
};
inline constexpr PlanTuning plan_tuning;

struct LineStyleTuning {
    // The width of a contour, in pens, if the style sets none. Larger: wider lines.
    float contour_width = 2.2F;
    // The width of lines other than contours, borders and creases, in widths of the contour. Larger: these lines stand
    // out more.
    double fine_width = 0.6;
    // The width of a line varies by the caller's `wobble` times this, but by at most 1. Larger: more uneven lines.
    double width_of_wobble = 0.5;
};
inline constexpr LineStyleTuning line_style_tuning;

// Inks that are chosen from the colours of marks.
struct PaletteTuning {
    // The largest number of inks. Larger: colours are shown more faithfully, by more pens.
    std::size_t inks = 3;
    // The largest number of hues that each get an ink. Larger: more pens for coloured parts; at most the inks of a
    // style.
    std::size_t few_inks = 8;
    // Hues nearer than this in Oklab are the same hue. Larger: many hues pass for a few. Set on colours that rounding
    // changes.
    double same_hue = 0.005;
    // The least difference between the hues of two inks, in Oklab. Larger: fewer inks.
    double least_difference = 0.04;
    // The number of times that groups of colours are formed anew. Larger: slower, and after some rounds no difference.
    int rounds = 12;
    // The lightness of all inks, and the factor of the chroma of colours. Larger: paler inks; brighter inks.
    double lightness = 0.5;
    double chroma = 1.15;
    // About the largest number of marks of a part whose colours are looked at. Larger: slower.
    std::int64_t most_colours = 8000;
};
inline constexpr PaletteTuning palette_tuning;

// Numbers of a source that become 0 and 1, if no range is given. Set on intensities of laser scans, on ground and in
// the air.
struct RangeTuning {
    // The inner numbers are those without this share of the least and of the greatest ones. Larger: more outliers may
    // be at an end, but rare values that matter are cut off.
    double outer_share = 0.02;
    // Numbers are outliers if they are farther than this from the inner numbers, in ranges of these. Larger: more
    // numbers differ, but with less contrast.
    double reach = 0.25;
};
inline constexpr RangeTuning range_tuning;

} // namespace hrbfnpr::picture
