// SPDX-License-Identifier: MIT
// The tuning constants of hatching on the surface. scripts/bench strokes --only=surface measures their effects on bumpy
// surfaces, tori, knots and the models that --models names.
#pragma once

#include <cstdint>

namespace hrbfnpr::hatching {

struct HatchingTuning {
    // ---- Lines and levels

    // The default distance between marks along a line, in separations. Larger: fewer marks.
    double step = 0.4;
    // The coarsest level has about this many lines per square root of the area. Larger: fewer levels.
    double fewest_lines = 6.0;

    // ---- Samples

    // Samples are this far apart, in separations; their number is clamped to the two numbers. Larger: coarser fields
    // and waves.
    double sample_spacing = 1.5;
    std::int64_t fewest_samples = 4096;
    std::int64_t most_samples = 32768;
    // Each sample is linked to this many of its nearest samples, but not to samples farther away than `farthest_link`
    // spacings.
    std::int64_t neighbours = 8;
    double farthest_link = 3.0;
    // Places whose normals have a cosine of at most this are on different sheets. Larger: thin walls are kept apart
    // better, but sharp bends are split.
    double same_sheet_cosine = 0.3;
    // Places are also on different sheets if the vector between them leaves a tangent plane by more than this share of
    // its length.
    double steepest_link = 0.5;   // between samples
    double steepest_offset = 0.6; // from a sample to a vertex of the mesh, and across from a line to the next one

    // ---- The field

    // Curvatures are averaged with those of neighbours in this many rounds. Larger: lines do not follow finer forms.
    int curvature_averages = 48;
    // A curvature counts in full if its radius is below this share of the diagonal. Larger: lines follow flatter forms
    // rather than the axis.
    double full_radius = 0.05;
    // Curvatures below this, over the diagonal, count as 0: a flat face has such curvatures within the tolerance of its
    // fit. Their weight rises to 1 at twice this. Larger: lines do not follow shallow forms.
    double flat_curvature = 0.1;
    // Between creases, where curvature and axis have less confidence than this, as on a flat face across the axis,
    // lines follow another axis with this weight.
    double least_confidence = 1e-3;
    // A named guide has this weight against curvature of full confidence. Larger: it is smoothed less, and hardly
    // turned by the axis.
    double guide_strength = 4.0;
    // How strongly lines are pulled to unit length. Larger: singular points are held more firmly where they are.
    double pull_to_unit = 0.2;

    // ---- Waves

    // The shift and the steps of the inverse iteration for the first wave; the shift is relative to the number of
    // neighbours. A smaller shift or more steps come closer to the eigenvector and take more time.
    double eigen_shift = 0.02;
    int eigen_steps = 12;
    // The shortest wave that samples can represent, in spacings of the samples. The mesh represents shorter waves, down
    // to the size of its cells.
    double finest_period = 1.5;
    // Rounds of plain means after a wave is halved, on samples and on vertices of the mesh; they create forks. Larger:
    // lines are more even, and have more forks.
    int sample_means = 100;
    int vertex_means = 20;
    // After that, waves of unit height are averaged in this many rounds. Larger: fewer bends at forks.
    int unit_averages = 20;
    // Vertices of the mesh take their waves from the samples within this many spacings. Larger: smoother waves.
    double sample_reach = 2.0;

    // ---- The mesh

    // The area of the surface is at most this many squares of a cell's side; each cell has about twelve triangles.
    // Larger: finer lines are possible, with more memory.
    double most_cells = 1e5;

    // ---- Ends that are joined

    // Ends are joined over gaps up to this, in separations; the lengths below are shares of it. Larger: fewer and
    // longer lines, which may bend where they were joined.
    double widest_gap = 2.0;
    // Ends face each other if both end directions have at least this cosine with the gap between them.
    double facing_cosine = 0.95;
    // Over gaps shorter than `touching_gap`, only the angle between the two end directions counts, and it may be
    // larger.
    double touching_gap = 0.2;
    double touching_cosine = 0.8;
    // The direction of an end comes from the part of the line up to this distance from it.
    double end_length = 0.5;

    // ---- Even lines; lengths are in separations

    // The distance between points. Smaller: more time.
    double even_step = 0.5;
    // Shorter lines are left out. Larger: fewer short lines.
    double shortest_line = 3.0;
    // Rounds of smoothing by weights 1/4, 1/2, 1/4 over neighbours along a line.
    int smoothings = 2;
    // Neighbouring lines are searched up to this far across. Larger: lines also move where they have more room.
    double neighbour_reach = 1.75;
    // A line can be its own neighbour, as where it winds round, at points at least this far away along it.
    double least_way_around = 5.0;
    // Two lines are neighbours if the cosine of the angle between them is larger than this.
    double parallel_cosine = 0.7;
    // A point within this many separations of another point's tangent plane is always accepted as its neighbour,
    // however steep the way to it.
    double thickness = 0.1;
    // In each of this many rounds, the neighbouring lines are searched again, and points make `moves` moves, each by
    // the share `move_share` of the way to the middle. Larger: lines are more even, more time.
    int rounds = 2;
    int moves = 12;
    float move_share = 0.8F;
    // Moves are averaged along a line by exponential weights, over about 2.7 separations; the newest value has this
    // share. Larger: lines are more even, and bend more. On a closed line each average begins `run_up_points` points
    // earlier.
    float newest_share = 0.3F;
    std::int64_t run_up_points = 16;
    // A line turns within the surface by at most this on a part of two separations, which has `points_of_kink` points;
    // in radians. Larger: lines are more even, and show kinks.
    float most_turn = 0.4F;
    int points_of_kink = 5;
    // A part that turns by more than this runs around a singular point of the field, and is not straightened.
    float singular_turn = 1.2F;
    // The most rounds in which a line is straightened.
    int straightenings = 40;

    // ---- Marks; lengths are in steps

    // A mark gets the median level over this length of its line, in separations. Larger: lines change their level less
    // often, and later.
    double level_length = 6.0;
    // Consecutive marks stay connected if their distance, in steps, is between these two numbers.
    double least_step = 0.5;
    double most_step = 1.6;
    // A piece of a line has at least this many marks.
    std::int64_t fewest_marks = 3;
    // The end of a line is extended to a crease that is at most this far ahead.
    double farthest_crease = 1.1;
    // A mark is on a sheet if it is at most this far away, in diagonals.
    double sheet_tolerance = 1e-6;
};
inline constexpr HatchingTuning hatching_tuning;

} // namespace hrbfnpr::hatching
