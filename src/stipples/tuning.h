// SPDX-License-Identifier: MIT
// The tuning constants of the stipples. scripts/bench quality and points measure their effects; docs/quality.md
// tells them.
#pragma once

#include <cstdint>

namespace hrbfnpr::stipples {

struct StippleTuning {
    // ---- The region and its cells (blue_noise.cpp, surface_cells.cpp)

    // Marks lie in the samples' box, grown by the samples' spacing, but by no less and no more than these parts of its
    // diagonal. Larger: open sheets go on farther beyond their samples, and other sheets of the function come in.
    double least_margin = 0.03;
    double most_margin = 0.10;
    // A cell is no wider than the region's diagonal over this. Larger: finer details are found, more cells for few
    // marks.
    double fewest_in_diagonal = 96.0;
    // Nor is it narrower than the diagonal over this. Larger: smaller surfaces are drawn in large boxes, in more
    // memory.
    double most_in_diagonal = 4096.0;
    // Cells are found anew, at most this many times, until those that the marks want are wider than this part of them.
    // Larger: more accurate areas of small surfaces in large boxes, in more time.
    int cover_rounds = 8;
    double fine_enough = 0.9;
    // Where fewer than `fewest_across` cells tell nothing, the next ones are smaller by this factor. Larger: more
    // rounds.
    double blind_step = 0.25;
    // The side of a cell, in spacings of the marks. Larger: fewer cells, and more candidates in each to be looked at.
    double cell_spacings = 2.2;
    // A surface that fewer cells are across is not drawn. Larger: small surfaces in large boxes are refused.
    std::int64_t fewest_across = 8;
    // A cell's plane is right where it differs from the function at a place nearby by less than this, in sides.
    // Larger: fewer evaluations, and sheets close to others are missed.
    double plane_error = 0.1;
    // The flood goes on where a plane passes a neighbour by at up to this distance beyond the band, in sides. Larger:
    // more cells are evaluated that turn out to be away from the surface.
    double flood_slack = 0.3;

    // ---- Candidates (candidates.cpp)

    // Candidates for each mark, and the fewest of all. Larger: more even, in proportionally more time.
    double candidates_per_mark = 3.5;
    std::int64_t fewest_candidates = 6000;
    // Candidates of the layer, for one of the planes: at random they leave gaps. Larger: more even where it bends.
    double layer_density = 1.4;
    // Candidates are drawn in up to this many rounds, until there is this part of the wanted. Larger: closer to the
    // wanted number where the function is no distance.
    int candidate_rounds = 4;
    double enough = 0.85;
    // Trials for each of the wanted candidates. Larger: more time is spent where planes and surface do not agree.
    double most_trials = 256.0;
    // Beside a cell of a plane the normals have at least this cosine with its own. Larger: fewer candidates are drawn
    // by planes, which take no evaluation.
    double flat_cosine = 0.97;
    // A plane that passes a cell by at this distance, in sides, is trusted to. Larger: more evaluations.
    double passes_by = 0.25;
    // Candidates for each evaluated point: its projection, and others around it. Larger: fewer evaluations, less
    // random.
    std::int64_t most_projections = 5;
    // They are at most this far from the projection along two axes, in sides. Larger: they are farther off the surface.
    double stride = 0.55;
    // A projection is on the surface where it is this near, in sides; at most this many steps lead there. Smaller: more
    // steps.
    double near_enough = 0.02;
    int most_steps = 6;
    // Each such projection is looked at again; where more than this share of them is off, all need further steps.
    // Larger share: candidates stay off the surface where the function is no distance.
    std::int64_t every_projection = 67;
    double most_off = 0.02;
    // Where fewer projections come of a trial than this, more trials are no help. Smaller: more trials in vain.
    double least_of_trial = 1.0 / 256.0;

    // ---- The progressive order (progressive_order.cpp)

    // The distance that marks keep, in that of the densest packing of as many. Larger: more even, and more candidates
    // fail.
    double kept_distance = 0.70;
    // Where no place is left the distance is multiplied by this, down to the least one, and below that only where all
    // candidates have been looked at again. Larger: closer to the largest distance possible, in more sweeps.
    double concession = 0.98;
    double least_distance = 0.65;
    // A mark's energy reaches this far, in distances of the densest packing at the end of its stage. Larger: low
    // frequencies are weaker, and each mark is felt by more candidates.
    double energy_reach = 1.8;
    // The cells of the last stage have at least this part of that reach. Larger: wider cells.
    double least_home = 0.85;
    // A step of a sweep is to reach a number of marks that is larger by this factor. Larger: fewer sweeps, less even.
    double step_growth = 1.015;
    // The threshold of energies grows in a step by this factor: by about this power of the number of marks (from 0.06
    // to 2 in a stage, measured). Larger: marks come sooner, at places that are less empty.
    float threshold_growth = 1.038F;
    double threshold_power = 2.5;
    // Below this energy all places count as equally empty. Larger: the first marks of a stage are less even.
    float least_threshold = 0.05F;
    // Where a sweep adds less than this part of the expected marks, the threshold rises above the lowest energy by the
    // first factor, by the second one where the stage is full but for the given part. Larger: fewer sweeps, less even.
    double poor_sweep = 0.25;
    float rise = 1.06F;
    float last_rise = 1.02F;
    double nearly_full = 0.97;
    // From this number of marks on a sweep has many steps: each sweep takes all candidates through the processor's
    // caches. Larger: more sweeps, more even.
    double marks_for_many_steps = 2000.0;
    // A stage of few marks has this many candidates for each to choose from. Larger: more even prefixes, more time.
    double early_candidates = 12.0;
    // A candidate at this part of the kept distance or more may move into its gap. Smaller: more gaps are tried in
    // vain.
    double nearness = 0.8;
    // It aims at a place this much farther than the distance it has to keep. Larger: rounding fails fewer of them.
    double aim = 1.02;
    // It moves no farther than this part of a candidates' cell, within which candidates are true to the surface.
    double farthest_move = 0.25;
    // A gap in which it fails is tried again at this part of the squared distance. Larger: more trials.
    float again = 0.97F;
    // Marks with normals below this cosine keep it from moving: the surface bends. Larger: fewer gaps are filled.
    float bent_cosine = 0.7F;

    // ---- Projection and repair (blue_noise.cpp)

    // A chosen candidate has wandered where its projection is farther from it than this part of the densest packing's
    // distance, or where their normals have a smaller cosine. Smaller: more marks are looked at again.
    double wandered = 0.04;
    double wandered_cosine = 0.95;
    // Marks nearer than this, in distances of the densest packing, are too near to a wandered one. Larger: more gaps.
    double least_apart = 0.66;

    // ---- Density (density.cpp)

    // The mean density is known from this number of marks, up to this factor. More marks: a smaller factor will do.
    std::int64_t probes = 2048;
    double mean_error = 1.06;
    // An even order has at most this many times the marks that remain. Larger: more marks where the density is low on
    // average, in more time.
    double most_excess = 16.0;
};
inline constexpr StippleTuning stipple_tuning;

// Work for one task of a loop on all threads, and for one call of an evaluation.
inline constexpr std::int64_t cells_a_task = 512;
inline constexpr std::int64_t points_a_task = 4096;
inline constexpr std::int64_t points_a_batch = 262144;

} // namespace hrbfnpr::stipples
