// SPDX-License-Identifier: MIT
// The tuning constants of generating point sets, and of finding where a surface ends.
#pragma once

#include <cstdint>

namespace hrbfnpr::generate {

struct GenerateTuning {
    // ---- Layers (settings.cpp)

    // The levels of the published recursions if the caller gives none. Each further level makes five times as many
    // stipples, or three times as many marks of strokes.
    std::int32_t stipple_levels = 4;
    std::int32_t stroke_levels = 3;
    // The normals for the tone of hatching are averaged over this length, in diagonals. A line shows each turn of its
    // surface by its width, whereas stipples average over many turns. Larger: calmer lines, less of small forms.
    double hatching_tone_smoothing = 0.006;
    // The least and the largest length that a caller may give, in the model's diagonals. Other lengths are taken for
    // mistakes.
    double shortest_length = 1e-12;
    double longest_length = 1e9;
    // The expected number of evaluations for each mark, which decides whether a function is prepared: in the published
    // recursions with curvatures and without, and in BLUE_NOISE with its candidates. Larger: functions are prepared for
    // fewer marks.
    double evaluations_with_curvature = 8.0;
    double evaluations_of_mark = 3.0;
    double evaluations_of_even_mark = 15.0;

    // ---- Seeds (seeds.cpp)

    // Samples are seeds of the published recursions if the distances to their nearest neighbours vary by less than this
    // part of the mean. Vertices of meshes vary by 0.2 to 0.4, random points by 0.52. Larger: less even seeds.
    double well_spread_variation = 0.5;
    // The least resolution of the box for BLUE_NOISE, whose marks are found from any seed on each sheet. Larger: fewer
    // sheets are missed, in more time.
    std::int32_t automatic_box_resolution = 16;
    // Seeds are at most this far from the bounds, in diagonals. From farther seeds, floats could not tell the model's
    // marks apart.
    double farthest_seed = 1e4;
    double step_of_one_seed = 0.1; // in diagonals; larger: fewer steps across

    // ---- The end of a surface (find_trim.cpp)

    // The surface is followed on cells of which this many fit into a spacing of the samples. The number of cells in the
    // region's diagonal is between the two bounds. Larger: sharper ends, in more time and memory.
    double cells_a_spacing = 2.0;
    double coarsest_cells = 32.0; // includes the cells in the margin
    double finest_cells = 256.0;
    // The first look uses cells as wide as a spacing, and multiplies all limits by this factor to be cautious. Larger:
    // it finds less.
    double caution_factor = 0.7;
    // Samples count as on the surface if they are off it by less than this, in spacings. Larger: the first look decides
    // about noisier samples, too.
    double on_surface = 0.25;
    // From this s on a place is certainly unsupported. s reaches it beyond a border at some 0.8 times the distance of
    // sixth neighbours, and in the middle of a hole at 1.7 times. Larger: more holes stay closed.
    double unsupported_limit = 6.0;
    // The expected number of evaluations for all of the surface, and for each sample at which the first look begins:
    // guesses. Larger: functions are prepared more often.
    double evaluations_of_surface = 2e5;
    double evaluations_of_sample = 30.0;

    // ---- The box of points along curves (find_trim.cpp)

    // Boxes of surfaces along curves are found for at most this many samples. With more, finding the box takes longer
    // than the fit.
    std::int64_t most_samples_along_curves = 20000;
    // The surface must close within this part of a diagonal around the samples. Larger: wider boxes.
    double closing_distance = 1.0 / 3.0;
    // The number of cells in a diagonal. Larger: more accurate boxes, in more time.
    double cells_of_bounds = 64.0;
};
inline constexpr GenerateTuning generate_tuning;

} // namespace hrbfnpr::generate
