// SPDX-License-Identifier: MIT
// The tuning constants of generating point sets, and of finding where a surface ends.
#pragma once

#include <cstdint>

namespace hrbfnpr::generate {

struct GenerateTuning {
    // ---- Layers (settings.cpp)

    // The levels of the published recursions if the caller gives none. Each level multiplies the number of stipples by
    // five, and the number of marks of strokes by three.
    std::int32_t stipple_levels = 4;
    std::int32_t stroke_levels = 3;
    // The length over which normals are averaged for the tone of hatching, in diagonals. The width of a line shows
    // every bump of the surface, whereas the tone of stipples is an average over many bumps. Larger: calmer lines, less
    // detail.
    double hatching_tone_smoothing = 0.006;
    // The smallest and largest length that a caller may give, in the model's diagonals. Other lengths are regarded as
    // mistakes.
    double shortest_length = 1e-12;
    double longest_length = 1e9;
    // The expected number of evaluations for each mark. It decides whether a function is prepared. The three values are
    // for the published recursions with curvatures and without, and for BLUE_NOISE including its candidates. Larger:
    // functions are prepared for fewer marks.
    double evaluations_with_curvature = 8.0;
    double evaluations_of_mark = 3.0;
    double evaluations_of_even_mark = 15.0;

    // ---- Seeds (seeds.cpp)

    // Samples become seeds of the published recursions if the standard deviation of their distances to nearest
    // neighbours is below this share of the mean. The ratio of deviation to mean is 0.2 to 0.4 for vertices of meshes,
    // and 0.52 for random points. Larger: less even seeds.
    double well_spread_variation = 0.5;
    // The least resolution of the box for BLUE_NOISE, which needs one seed on each sheet of the surface. Larger: fewer
    // sheets are missed, but more time.
    std::int32_t automatic_box_resolution = 16;
    // The greatest distance of a seed from the bounds, in diagonals. At a larger distance, floats could not distinguish
    // the marks of the model.
    double farthest_seed = 1e4;
    double step_of_one_seed = 0.1; // the step for a single seed, in diagonals; larger: fewer steps across the model

    // ---- The end of a surface (find_trim.cpp)

    // The surface is followed on cells whose side is the spacing of the samples divided by this. The number of cells
    // along the region's diagonal is kept between the two bounds below. Larger: sharper ends, but more time and memory.
    double cells_a_spacing = 2.0;
    double coarsest_cells = 32.0; // these two bounds include cells in the margin
    double finest_cells = 256.0;
    // The first look is cautious: it uses cells with a side of one spacing, and multiplies the limits for holes by this
    // factor. Larger: the first look finds fewer parts to leave out.
    double caution_factor = 0.7;
    // Samples count as on the surface if they are closer to it than this, in spacings. Larger: the first look also
    // decides about noisier samples.
    double on_surface = 0.25;
    // If s reaches this value, a place is certainly unsupported. Let d be the distance of a sample to its sixth nearest
    // neighbour. Outside a border, s reaches this value about 0.8 d from the samples; in the middle of a hole, about
    // 1.7 d from them. Larger: more holes stay closed.
    double unsupported_limit = 6.0;
    // The expected number of evaluations for the whole surface, and for each sample at which the first look begins.
    // Both are guesses. Larger: functions are prepared more often.
    double evaluations_of_surface = 2e5;
    double evaluations_of_sample = 30.0;

    // ---- The box of few points, and of points along curves (find_trim.cpp)

    // Closed boxes are computed for at most this many samples along curves, and for at most `few_samples` others. For
    // more samples along curves this would take longer than the fit. Between more other samples, a surface bulges by
    // less than the margin of the search box. Larger: more time. Set on tori of 25 to 400 samples.
    std::int64_t most_samples_along_curves = 20000;
    std::int64_t few_samples = 100;
    // The greatest distance from the samples' box within which a surface may close, in diagonals. Larger: larger boxes.
    double closing_distance = 1.0 / 3.0;
    // The number of cells along a diagonal when the box of a closed surface is found. Larger: more accurate boxes, but
    // more time.
    double cells_of_bounds = 64.0;
};
inline constexpr GenerateTuning generate_tuning;

} // namespace hrbfnpr::generate
