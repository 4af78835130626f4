// SPDX-License-Identifier: MIT
// The tuning constants of hatching on the surface. scripts/bench strokes --only=surface measures their
// effects on bumpy surfaces, tori, knots and the models that --models names.
#pragma once

#include <cstdint>

namespace hrbfnpr::hatching {

struct HatchingTuning {
    // ---- Lines and levels

    // The distance between marks along a line, in separations, where none is set. Larger: fewer marks.
    double step = 0.4;
    // The coarsest level has about this many lines in the root of the area. Larger: fewer levels.
    double fewest_lines = 6.0;

    // ---- Samples

    // Samples are this far apart, in separations, and between these two numbers. Larger: coarser fields and waves.
    double sample_spacing = 1.5;
    std::int64_t fewest_samples = 4096;
    std::int64_t most_samples = 32768;
    // Each sample is linked to this many of the nearest ones, but to none farther away, in spacings.
    std::int64_t neighbours = 8;
    double farthest_link = 3.0;
    // Places whose normals have no larger cosine are on different sheets. Larger: thin walls are kept apart better,
    // and sharp bends fall apart.
    double same_sheet_cosine = 0.3;
    // So are places whose way leaves a tangent plane by more than this part of its length.
    double steepest_link = 0.5; // between samples
    double steepest = 0.6;      // from a sample to a vertex of the mesh, and across from a line to the next one

    // ---- The field

    // Rounds in which curvatures are averaged with those of the neighbours. Larger: finer forms are not followed.
    int bend_averages = 48;
    // A curvature counts in full where its radius is below this part of the diagonal. Larger: flatter forms are
    // followed rather than the axis.
    double full_radius = 0.05;
    // Smaller curvatures, over the diagonal, are those of a flat face as a fit within its tolerance has it; from twice
    // as much on they count. Larger: shallow forms are not followed.
    double flat_bend = 0.1;
    // Lines that are less sure, from 0 to 1, say nothing on a sheet of its own, as a flat face across the axis is.
    double unsure = 1e-3;
    // A guide with a name counts this much against sure curvature. Larger: it is smoothed less, and hardly turned by
    // the axis.
    double guide_strength = 4.0;
    // How strongly lines are pulled to unit length. Larger: singular points are more firmly held where they are.
    double pull_to_unit = 0.2;

    // ---- Waves

    // Inverse iteration for the first wave: its shift, against the number of neighbours, and its steps. A smaller shift
    // or more steps come nearer to the eigenvector and take more time.
    double eigen_shift = 0.02;
    int eigen_steps = 12;
    // The shortest wave that samples can tell, in their spacings. Shorter ones are told by the mesh down to its cells.
    double finest_period = 1.5;
    // Rounds of plain means after a wave is halved, on samples and on vertices of the mesh: forks are born in them.
    // Larger: lines are more even, and have more forks.
    int sample_means = 100;
    int vertex_means = 20;
    // Rounds in which waves of one height are averaged thereafter. Larger: fewer bends at forks.
    int unit_averages = 20;
    // Vertices of the mesh hear the samples within this many spacings. Larger: smoother waves.
    double influence = 2.0;

    // ---- The mesh

    // The area of the surface in cells of the mesh, of some twelve triangles each. Larger: finer lines are possible, in
    // more memory.
    double most_cells = 1e5;

    // ---- Ends that are joined

    // Ends are joined over gaps up to this, in separations; lengths here are parts of it. Larger: fewer and longer
    // lines, which may bend where they were joined.
    double widest_gap = 2.0;
    // Ends face each other where the angles between each one's way and the way across have at least this cosine.
    double facing_cosine = 0.95;
    // Over a shorter gap only the angle between the ends' ways counts, which may be larger.
    double touching = 0.2;
    double touching_cosine = 0.8;
    // The way of an end is told by the line up to this distance from it.
    double end_length = 0.5;

    // ---- Even lines; lengths are in separations

    // The distance between points. Smaller: more time.
    double even_step = 0.5;
    // Shorter lines are left out. Larger: fewer short lines.
    double shortest = 3.0;
    // Rounds of 1/4, 1/2, 1/4 over neighbours along a line.
    int smoothings = 2;
    // Other lines are looked for up to this far across. Larger: lines move where they have more room, too.
    double beside = 1.75;
    // A line is beside itself, as where it winds round, at points at least this far away along it.
    double winding = 5.0;
    // Two lines are beside each other where the angle between their ways has a larger cosine.
    double parallel_cosine = 0.7;
    // Places this far off the tangent plane are no steeper than any others.
    double thickness = 0.1;
    // Rounds, for each of which the lines beside are looked for anew; in each this many moves, of this share of the way
    // to the middle. Larger: lines are more even, more time.
    int rounds = 2;
    int moves = 12;
    float move_share = 0.8F;
    // Moves are averaged along a line by exponential weights, of which the newest has this share: over some 2.7
    // separations. Larger: lines are more even, and bend more. On a closed line each average begins this many points
    // before.
    float newest = 0.3F;
    std::int64_t run_up = 16;
    // No line turns within its surface by more than this on a part of two separations, which has this many points; in
    // radians. Larger: lines are more even, and show kinks.
    float most_turn = 0.4F;
    int points_of_kink = 5;
    // A part that turns by more than this does so around a singular point of the field.
    float singular_turn = 1.2F;
    // The most rounds in which a line is straightened.
    int straightenings = 40;

    // ---- Marks; lengths are in steps

    // A mark gets the median level over this part of its line, in separations. Larger: lines change their level less
    // often, and later.
    double level_length = 6.0;
    // Marks next to each other belong together where their distance is between these.
    double least_step = 0.5;
    double most_step = 1.6;
    // A piece of a line has at least this many marks.
    std::int64_t fewest_marks = 3;
    // An end is drawn up to a crease that is no farther ahead.
    double crease_ahead = 1.1;
    // A mark is on a sheet that is no farther away, in diagonals.
    double on_sheet = 1e-6;
};
inline constexpr HatchingTuning hatching_tuning;

} // namespace hrbfnpr::hatching
