// SPDX-License-Identifier: MIT
// The tuning constants of stipples. `scripts/bench quality` and `scripts/bench points` measure their effects;
// docs/measurements.md has the results.
#pragma once

#include <cstdint>

namespace hrbfnpr::stipples {

struct StippleTuning {
    // ---- The region and its cells (blue_noise.cpp, surface_cells.cpp)

    // Marks lie in the bounding box of the samples, enlarged by the spacing of the samples. The two constants bound the
    // enlargement, as shares of the box's diagonal. Larger: open sheets extend farther beyond their samples, and other
    // sheets of the function get into the box.
    double least_margin = 0.03;
    double most_margin = 0.10;
    // The largest side of a cell is the region's diagonal divided by this. Larger: finer details are found, and there
    // are more cells if there are few marks.
    double fewest_in_diagonal = 96.0;
    // The smallest side of a cell is the diagonal divided by this. Larger: smaller surfaces can be drawn in large
    // boxes, with more memory.
    double most_in_diagonal = 4096.0;
    // The cells are found again, at most `cover_rounds` times, as long as the marks need cells whose side is below
    // `fine_side_share` times the present side. Larger: the areas of small surfaces in large boxes are more accurate,
    // in more time.
    int cover_rounds = 8;
    double fine_side_share = 0.9;
    // If the surface is fewer than `fewest_across` cells wide, the next round multiplies the cell side by this. Larger:
    // more rounds.
    double missed_surface_step = 0.25;
    // The side of a cell, in spacings of the marks. Larger: fewer cells, with more candidates in each.
    double cell_spacings = 2.2;
    // A surface fewer than this many cells wide is refused. Larger: small surfaces in large boxes are refused.
    std::int64_t fewest_across = 8;
    // The plane of a cell is accepted if its error at a nearby place is below this, in sides. Larger: fewer
    // evaluations, but sheets close to others are missed.
    double plane_error = 0.1;
    // The flood enters a neighbour if the plane is at most this far outside the band there, in sides. Larger: more
    // cells are evaluated that are not on the surface.
    double flood_slack = 0.3;

    // ---- Candidates (candidates.cpp)

    // The number of candidates for each mark, and the least number of candidates. Larger: more even, in proportionally
    // more time.
    double candidates_per_mark = 3.5;
    std::int64_t fewest_candidates = 6000;
    // The density of layer candidates divided by that of plane candidates. Layer candidates are random, so they leave
    // gaps. Larger: more even where the surface bends.
    double layer_density = 1.4;
    // The largest number of rounds that generate candidates. Rounds end earlier if there are `candidates_share` times
    // the wanted number of candidates. Larger: the number is closer to the wanted one if f is not like a distance.
    int candidate_rounds = 4;
    double candidates_share = 0.85;
    // The largest number of trials for each wanted candidate. Larger: more time is spent where planes and surface
    // disagree.
    double most_trials = 256.0;
    // The cosine between the normal of a flat cell and the normals of the cells beside it is at least this. Larger:
    // fewer candidates come from planes, which need no evaluation.
    double flat_cosine = 0.97;
    // If the plane is at least this far from a cell, in sides, the surface does not pass through the cell. Larger: more
    // evaluations.
    double miss_distance = 0.25;
    // The largest number of candidates from one evaluated point: its projection, and others around the projection.
    // Larger: fewer evaluations, less random.
    std::int64_t most_projections = 5;
    // Candidates around a projection are at most this far from it along two axes, in sides. Larger: they are farther
    // off the surface.
    double projection_stride = 0.55;
    // A projection is on the surface if its distance is below this, in sides. At most `most_steps` steps are made.
    // Smaller: more steps.
    double surface_tolerance = 0.02;
    int most_steps = 6;
    // One in `every_projection` projections is evaluated again. If more than the share `most_off_surface` of these is
    // off the surface, all projections make further steps. Larger share: candidates stay off the surface if f is not
    // like a distance.
    std::int64_t every_projection = 67;
    double most_off_surface = 0.02;
    // The least number of projections that a trial is assumed to give. It limits the number of trials. Smaller: more
    // trials in vain.
    double least_projections_per_trial = 1.0 / 256.0;

    // ---- The needs of a still picture (needed_cells.cpp)

    // The first marks of an order are placed on the whole surface, even if the picture shows none of them. Larger: the
    // box around the marks is closer to the box around the surface, in more time.
    double needed_everywhere = 256.0;
    // Candidates are drawn for a stage in a cell if the cell needs more than this share of the marks with which the
    // stage begins. Smaller: fewer cells lack candidates if the area of the surface was estimated badly.
    double early_share = 0.8;
    // Each cell has at least this share of its candidates, and the whole surface has at least `fewest_for_area`. The
    // area of the surface is measured by these candidates. Larger: a more accurate area, in more time.
    double least_candidate_share = 1.0 / 32.0;
    double fewest_for_area = 20000.0;

    // ---- The progressive order (progressive_order.cpp)

    // The least distance between marks, in distances of the densest packing of the same number of marks. Larger: more
    // even, and more candidates fail.
    double kept_distance = 0.70;
    // If no place is left, the least distance is multiplied by this, but it stays above `least_distance`. Before each
    // further reduction, all candidates are examined again. Larger: closer to the largest possible distance, in more
    // sweeps.
    double distance_factor = 0.98;
    double least_distance = 0.65;
    // The distance up to which a mark has energy, in distances of the densest packing at the end of its stage. Larger:
    // low frequencies are weaker, and each mark changes more candidates.
    double energy_reach = 1.8;
    // The least side of the cells of the last stage, as a share of the reach of a mark's energy. Larger: wider cells.
    double least_side_share = 0.85;
    // From step to step in a sweep, the intended number of marks grows by this factor. Larger: fewer sweeps, less even.
    double step_growth = 1.015;
    // In sweeps of many steps, the energy threshold grows by `threshold_growth` from step to step. It grows about with
    // the power `threshold_power` of the number of marks; in a stage, it was measured to grow from 0.06 to 2. Larger:
    // marks are placed sooner, in fuller places.
    float threshold_growth = 1.038F;
    double threshold_power = 2.5;
    // All places with less energy than this count as equally empty. Larger: the first marks of a stage are less even.
    float least_threshold = 0.05F;
    // If a sweep adds less than the share `poor_sweep` of the expected marks, the threshold rises to the lowest energy
    // times `threshold_rise`. If the stage has more than the share `nearly_full` of its marks, it rises to the lowest
    // energy times `last_threshold_rise`. Larger: fewer sweeps, less even.
    double poor_sweep = 0.25;
    float threshold_rise = 1.06F;
    float last_threshold_rise = 1.02F;
    double nearly_full = 0.97;
    // From this number of marks on, a sweep has many steps, because each sweep loads all candidates into the
    // processor's caches. Larger: more sweeps, more even.
    double marks_for_many_steps = 2000.0;
    // A stage with few marks has this many candidates for each mark. Larger: more even prefixes, more time.
    double early_candidates = 12.0;
    // A candidate may move into its gap if its distance from marks is at least this share of the least distance.
    // Smaller: more gaps are tried in vain.
    double move_clearance = 0.8;
    // A candidate that moves into its gap aims at the least distance times this factor. Larger: fewer moves fail by
    // rounding.
    double gap_aim = 1.02;
    // A candidate moves by at most this share of a side of its cell, because places farther away may be off the
    // surface. Larger: more gaps are filled.
    double farthest_move = 0.25;
    // After a failed move, the stored clearance of the candidate (its squared distance from marks) is set to at most
    // this share of the clearance that a move needs. So the candidate is tried again only when the least distance has
    // become smaller. Larger: more trials.
    float retry_clearance = 0.97F;
    // A candidate does not move if the cosine between its normal and the normal of a mark nearby is below this, because
    // the surface bends. Larger: fewer gaps are filled.
    float bent_cosine = 0.7F;

    // ---- Projection and repair (blue_noise.cpp)

    // A chosen candidate has wandered if its projection is farther away than this, in distances of the densest packing,
    // or if the cosine between their normals is below `wandered_cosine`. Smaller: more marks are examined again.
    double wandered_distance = 0.04;
    double wandered_cosine = 0.95;
    // A mark is too close to a wandered mark if their distance is below this, in distances of the densest packing.
    // Larger: more gaps.
    double least_apart = 0.66;

    // ---- Density (blue_noise.cpp)

    // The number of marks from which the mean density is estimated, with an error of up to the factor `mean_error`.
    // With more marks a smaller factor is enough.
    std::int64_t probes = 2048;
    double mean_error = 1.06;
    // The number of marks of the even order is at most this multiple of the number of marks that are kept. Larger: more
    // marks where the mean density is low, in more time.
    double most_excess = 16.0;
};
inline constexpr StippleTuning stipple_tuning;

// The number of cells, and the number of points, for a task of a parallel loop; and the number of points for a call
// that evaluates f.
inline constexpr std::int64_t cells_a_task = 512;
inline constexpr std::int64_t points_a_task = 4096;
inline constexpr std::int64_t points_a_batch = 262144;

} // namespace hrbfnpr::stipples
