// SPDX-License-Identifier: MIT
// The tuning constants for hatching on the surface. scripts/bench strokes --only=surface measures their effects on
// bumpy surfaces, tori, knots and the models that --models names.
#pragma once

#include <cstdint>

namespace hrbfnpr::hatching {

struct HatchingTuning {
    // ---- Lines and levels

    // The default distance between marks along a line, in separations. Larger: fewer marks.
    double step = 0.4;
    // The least number of lines of the coarsest level across a square with the area of the surface. Larger: fewer
    // levels.
    double fewest_lines = 6.0;

    // ---- Samples

    // The distance between samples, in separations. The number of samples is limited by the two constants below.
    // Larger: coarser fields and waves.
    double sample_spacing = 1.5;
    std::int64_t fewest_samples = 4096;
    std::int64_t most_samples = 32768;
    // Each sample is linked to this many of its nearest samples, if they are within `farthest_link` spacings.
    std::int64_t neighbours = 8;
    double farthest_link = 3.0;
    // A part of the samples is never smaller than this, where there are as many. Larger: more time.
    std::int64_t fewest_coarse = 1024;
    // Numbers that only a part of the samples has are filled in by this many rounds of means. Each round reaches the
    // neighbours, so this must be at least the largest ratio of two spacings. Larger: more time.
    int fill_rounds = 12;
    // Two places are on different sheets if the cosine of their normals is at most this. Larger: thin walls are kept
    // apart better, but sharp bends are split.
    double same_sheet_cosine = 0.3;
    // Two places are also on different sheets if one is higher above the tangent plane of the other than this share of
    // their distance.
    double steepest_link = 0.5;   // the limit for two samples
    double steepest_offset = 0.6; // the limit for a sample and a vertex of the mesh, and for two neighbouring lines

    // ---- The field

    // The number of rounds that average curvatures with those of neighbours. Larger: lines follow only larger forms.
    int curvature_averages = 48;
    // A curvature has full weight if its radius is below this share of the diagonal. Larger: lines follow flatter forms
    // rather than the axis.
    double full_radius = 0.05;
    // Curvatures below this number divided by the diagonal get the weight 0, because the tolerance of a fit allows them
    // even on flat faces. Above this limit, the weight grows, up to 1 at twice the limit. Larger: lines do not follow
    // shallow forms.
    double flat_curvature = 0.1;
    // Where curvature and axis have less confidence than this, as on a flat face perpendicular to the axis, lines
    // follow another axis with this weight. This is done only on surfaces with creases.
    double least_confidence = 1e-3;
    // The weight of a named guide. A curvature of full confidence has the weight 1. Larger: neighbours and the axis
    // change the direction of the guide less.
    double guide_strength = 4.0;
    // The spacing of the samples whose lines are solved for, in smoothing lengths. Larger: less time, less exact.
    double field_spacing = 0.25;
    // The strength of the term that pulls the complex numbers of lines to unit magnitude. Larger: singular points move
    // less.
    double pull_to_unit = 0.2;

    // ---- Waves

    // The spacing of the samples on which the first wave is found, in periods. Larger: less time, less exact.
    double first_spacing = 0.16;
    // The shift of the inverse iteration for the first wave, and the number of steps of the iteration. The shift is
    // added to the diagonal of the matrix, where each node has the number of its neighbours. A smaller shift or more
    // steps give a better eigenvector and take more time.
    double eigen_shift = 0.02;
    int eigen_steps = 12;
    // The shortest period of a wave on samples, in spacings. The mesh represents shorter waves, down to the size of its
    // cells.
    double finest_period = 1.5;
    // The numbers of rounds of plain means after a wave is halved: on samples, and on vertices of the mesh. The means
    // create forks. Larger: lines are more even, and have more forks.
    int sample_means = 100;
    int vertex_means = 9;
    // A power of the means is computed from as many terms as this many standard deviations of a random walk have steps.
    // Larger: more exact, more time. With 3, the terms that are left out have 0.3 % of the weight.
    double walk_deviations = 3.0;
    // After the plain means, waves are averaged and scaled to unit magnitude in this many rounds: on samples, and on
    // vertices. Larger: fewer bends at forks.
    int unit_averages = 20;
    int vertex_averages = 9;
    // A vertex of the mesh takes its waves from the samples within this many spacings. Larger: smoother waves.
    double sample_reach = 2.0;

    // ---- The mesh

    // The side of a cell, in separations, and the shortest period of a wave on the vertices, in sides. Larger sides:
    // less time, and more ends of lines and kinks.
    double mesh_side = 1.5;
    double finest_on_mesh = 0.65;
    // The largest distance of vertices from the surface, in separations. Larger: fewer evaluations. Marks are projected
    // later, so only their way along the surface changes.
    double vertex_tolerance = 0.01;
    // The area of the surface divided by the area of a cell's face is at most this. A cell has about twelve triangles.
    // Larger: finer lines are possible, with more memory.
    double most_cells = 1e5;

    // ---- A still picture

    // Lines end about this many separations beyond the places that a still picture may show. Smaller: less time, and
    // lines near these ends lie elsewhere than in a set for all cameras.
    double beyond_shown = 4.0;
    // The mesh covers blocks of this many cells along each side that have a needed place near them. Larger: fewer
    // tests, and more cells that are not needed.
    std::int64_t needed_block = 2;

    // ---- Ends that are joined

    // Ends are joined over gaps of at most this, in separations. The lengths below are shares of this gap. Larger:
    // fewer and longer lines, which may bend where they are joined.
    double widest_gap = 2.0;
    // Two ends face each other if the cosine of the angle by which the joined line would turn is above this, and if the
    // gap leads to the side by at most `farthest_aside`. Larger offset: lines of neighbouring rows are joined, too.
    double facing_cosine = 0.8;
    double farthest_aside = 0.35;
    // The direction of an end is measured over this length of the line, as a share of `widest_gap`.
    double end_length = 0.5;

    // ---- Even lines; lengths are in separations

    // The distance between points. Smaller: more time.
    double even_step = 0.5;
    // Shorter lines are left out. Larger: fewer short lines.
    double shortest_line = 3.0;
    // The number of rounds of smoothing with weights 1/4, 1/2, 1/4 along a line.
    int smoothings = 2;
    // Neighbouring lines are searched for up to this distance across a line. Larger: lines with more space beside them
    // move, too.
    double neighbour_reach = 1.75;
    // Neighbours are searched for at every `searched_points`-th point of a line, and followed along their lines
    // in between, by at most `followed_points` points at a time. Larger searched_points: less time; short lines may be
    // missed.
    std::int64_t searched_points = 4;
    int followed_points = 4;
    // If a line winds around, it can be its own neighbour: at points whose distance along it is at least this.
    double least_way_around = 5.0;
    // Two lines are neighbours only if the cosine between their directions is larger than this.
    double parallel_cosine = 0.7;
    // A point is accepted as a neighbour if it is within this many separations of the tangent plane, even if the way to
    // it is steep.
    double thickness = 0.1;
    // In each of this many rounds, neighbouring lines are searched for again, and points make `moves` moves. Each move
    // is the share `move_share` of the distance to the middle. Larger: lines are more even, more time.
    int rounds = 2;
    int moves = 12;
    float move_share = 0.8F;
    // Moves are averaged along a line with exponential weights, over about 2.7 separations. This is the weight of the
    // newest value. Larger: lines are more even, and bend more. On a closed line, each average begins `run_up_points`
    // points earlier.
    float newest_share = 0.3F;
    std::int64_t run_up_points = 16;
    // A part of a line, two separations long and with `points_of_kink` points, is straightened if it turns by more than
    // this within the surface, in radians. Larger: lines are more even, and show kinks.
    float most_turn = 0.4F;
    int points_of_kink = 5;
    // A part that turns by more than this, in radians, is around a singular point of the field. It is not straightened.
    float singular_turn = 1.2F;
    // The largest number of rounds in which a line is straightened.
    int straightenings = 40;

    // ---- Narrow faces and forks; lengths are in separations

    // A line shorter than `shortest_line` that crosses a narrow face is left out if another line is nearer than this.
    // Larger: gaps between lines across narrow faces. Smaller: dots at cracks of the mesh.
    float nearest_across_face = 0.6F;
    // At a fork, a line is continued while the lines beside it are farther apart than `least_room`, by at most
    // `longest_fork`. Larger least_room: forks leave larger white spots. Smaller: they leave dark spots.
    double least_room = 1.1;
    double longest_fork = 4.0;
    // If the lines beside it are farther apart than this, they are not those of a fork.
    double most_room = 3.0;

    // ---- Marks; lengths are in steps

    // Each mark gets the median level over this length of its line, in separations. Larger: the level of a line changes
    // less often, and later.
    double level_length = 6.0;
    // Two consecutive marks stay connected if their distance is between these two numbers, in steps.
    double least_step = 0.5;
    double most_step = 1.6;
    // The smallest number of marks in a piece of a line.
    std::int64_t fewest_marks = 3;
    // The end of a line is extended to a crease if the crease is at most this far ahead, in steps.
    double farthest_crease = 1.1;
    // A mark is on a sheet if its distance from the sheet is at most this, in diagonals.
    double sheet_tolerance = 1e-6;
};
inline constexpr HatchingTuning hatching_tuning;

} // namespace hrbfnpr::hatching
