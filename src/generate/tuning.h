// SPDX-License-Identifier: MIT
// The tuning constants of generating point sets, and of finding where a surface ends.
#pragma once

#include <cstdint>

namespace hrbfnpr::generate {

struct GenerateTuning {
    // ---- Layers (settings.cpp)

    // Levels of the published recursions where the caller does not say. Larger: five times as many stipples for each,
    // three times as many marks of strokes.
    std::int32_t stipple_levels = 4;
    std::int32_t stroke_levels = 3;
    // The normals that the tone of hatching goes by are averaged over this way, in diagonals. A line shows each turn of
    // its surface by its width, whereas stipples average over many turns. Larger: calmer lines, less of small forms.
    double hatching_tone_smoothing = 0.006;
    // Lengths of a caller, in the model's diagonals: others are mistakes.
    double shortest_length = 1e-12;
    double longest_length = 1e9;
    // Evaluations that a mark is expected to take, for the choice of a prepared function: of the published recursions
    // with curvatures and without, and of BLUE_NOISE with its candidates. Larger: functions are prepared for fewer
    // marks.
    double evaluations_with_curvature = 8.0;
    double evaluations_of_mark = 3.0;
    double evaluations_of_even_mark = 15.0;

    // ---- Seeds (make_seeds.cpp)

    // Samples are seeds of the published recursions where the distances to their nearest neighbours vary by less than
    // this part of the mean. Vertices of meshes vary by 0.2 to 0.4, random points by 0.52. Larger: less even seeds.
    double well_spread_variation = 0.5;
    // The box of BLUE_NOISE has at least this resolution: its marks are found from any point of each sheet. Larger:
    // fewer sheets are missed, in more time.
    std::int32_t automatic_box_resolution = 16;
    // Seeds are at most this far from the bounds, in diagonals: beyond, floats would not tell the model's marks apart.
    double farthest_seed = 1e4;
    double step_of_one_seed = 0.1; // in diagonals; larger: fewer steps across

    // ---- The end of a surface (find_trim.cpp)

    // The surface is followed on this number of cells in a spacing of the samples, and in the region's diagonal on a
    // number between these. Larger: sharper ends, in more time and memory.
    double cells_a_spacing = 2.0;
    double coarsest_cells = 32.0; // some are in the margin
    double finest_cells = 256.0;
    // The first look has a cell a spacing, and is wary instead: this part of all limits is enough. Larger: it finds
    // less.
    double wary = 0.7;
    // Samples are on the surface where they are off it by less than this, in spacings. Larger: the first look decides
    // about noisier samples, too.
    double on_surface = 0.25;
    // From this s on a place is surely not borne out: some 0.8 times as far beyond a border as sixth neighbours
    // are, 1.7 times in the middle of a hole. Larger: more holes stay closed.
    double doubtless = 6.0;
    // Evaluations of all of the surface, and of each sample that the first look begins at: guesses. Larger: functions
    // are prepared more often.
    double evaluations_of_surface = 2e5;
    double evaluations_of_sample = 30.0;

    // ---- The box of points along curves (find_trim.cpp)

    // Such boxes are found for this number of samples at most: with more, it takes longer than the fit.
    std::int64_t most_samples_along_curves = 20000;
    // The surface has to close within this part of a diagonal around the samples. Larger: wider boxes.
    double bulge = 1.0 / 3.0;
    // Cells in a diagonal. Larger: more accurate boxes, in more time.
    double cells_of_bounds = 64.0;
};
inline constexpr GenerateTuning generate_tuning;

} // namespace hrbfnpr::generate
