// SPDX-License-Identifier: MIT
// Tuning constants for finding normals and for smoothing depth images. A spacing is the median distance to the nearest
// other point. Energies are divided by the degrees of freedom, with lengths in spacings. The values were set with
// scripts/bench orient on analytic surfaces, thin walls, wires and scans, clean and with noise, and with tests/orient
// where a comment says so.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hrbfnpr::orient {

struct OrientTuning {
    // ---- The cloud

    // Points closer to each other than this are merged, in spacings. Larger: thin walls may merge.
    double merged = 0.01;
    // Number of neighbours found for each place. Larger: directions are means over more of the surface.
    std::int64_t most_neighbours = 32;
    // Two places are connected if one is among the `linked` nearest neighbours of the other and at most `link_length`
    // local spacings away. Larger: solids close to each other count as one component.
    std::int64_t linked = 8;
    double link_length = 3.0;
    // The first level of points along curves has at least this many points, spread over the whole surface, and fewer
    // than twice as many. Larger: the level may show single curves.
    std::int64_t fewest_all_over = 64;

    // ---- Effort

    // Clouds of at most this many points get all starts and are not replaced by means. Larger: more time.
    std::int64_t few_points = 6000;
    // Clouds with more points than this get one start. Larger: more time.
    std::int64_t many_points = 150000;
    // In clouds with more points than this, the search for signs starts from patches. Larger: more time.
    std::int64_t many_places = 100000;
    // In the sparse energy, each place depends on `neighbours` others, or on `neighbours_of_few` if there are fewer
    // than `few_places` places. Larger: the sparse energy is nearer to the true one, and takes more time.
    std::int32_t neighbours = 16;
    std::int32_t neighbours_of_few = 32;
    std::int64_t few_places = 1000;

    // ---- Signs

    // Clusters that are not each other's partner join, too, if their coupling is above `sure_strength` times its upper
    // bound. In clouds of more than `careful` places, a cluster also joins one with more than `large` times its number
    // of members. Smaller: fewer rounds, but more joins must be undone.
    double sure_strength = 0.5;
    std::int64_t large = 4;
    std::int64_t careful = 2000;
    // A level of clusters is kept if it has at most this share of the clusters of the last level that was kept. Larger:
    // more levels.
    double kept_share = 0.3;
    // At most `most_sweeps` sweeps turn clusters. A cluster is turned if the energy falls by more than `least_gain`
    // times the energy of the cluster alone. Smaller changes may be rounding.
    int most_sweeps = 4;
    double least_gain = 1e-6;
    // A patch is a place with some of its `patch_neighbours` nearest neighbours. A neighbour belongs to the patch under
    // two conditions. The |cosine| of the two normals is at least `patch_alike`. The sine of the angle between the
    // chord and each tangent plane is at most `patch_beside`. Larger sine or smaller cosine: patches may reach over
    // edges.
    std::int64_t patch_neighbours = 8;
    double patch_alike = 0.9;
    double patch_beside = 0.35;

    // ---- Directions

    // The descent remembers the last `curvature_pairs` pairs of a step and the change of the gradient in it. It makes
    // at most `most_steps` steps. It ends when the last `looked_back` steps together lower the energy by less than the
    // share `enough_gain`. More pairs, more steps or a smaller `enough_gain`: more time.
    int curvature_pairs = 6;
    int most_steps = 60;
    int looked_back = 5;
    double enough_gain = 1e-5;
    // A step turns no normal by more than `longest_turn` radians. At most `step_halvings` step lengths are tried, each
    // half of the previous length, until Armijo's rule holds with the share `armijo`.
    double longest_turn = 0.5;
    int step_halvings = 12;
    double armijo = 1e-4;

    // ---- Starts

    // No more starts are made after two starts reach the same result, unless another result has an energy lower by more
    // than this share. Larger: fewer starts.
    double same_energy = 0.03;
    // In the agreement, the weight of a result is exp(-d / unlikely_energy). d is the share by which its energy exceeds
    // the energy of the chosen result. Larger: bad results cost more confidence.
    double unlikely_energy = 0.15;
    // A result is a rival of the chosen result if less than this share of their signs is equal.
    double other_signs = 0.95;

    // ---- Noise

    // Clean clouds have energies of 1e-7 (smooth) to 0.006 (sharp edges), noisy clouds above 0.018, points without any
    // order 0.026. Clouds below this energy are clean.
    double clean_below = 0.012;
    // Clean clouds that are too sparse for their details may have a higher energy. Such a cloud still counts as clean
    // under two conditions. First, every other choice of signs has an energy higher by the factor `noisy_rival`.
    // Second, the energy is above `no_order_above`, or regularization leaves less than the share `same_signs` of the
    // signs unchanged. Larger: more clouds count as noisy.
    double no_order_above = 0.02;
    double noisy_rival = 1.05;
    double same_signs = 0.9;
    // The regularization starts at `first_ridge` and is multiplied by a constant factor until the energy is below
    // `settled_below`. Fewer than `most_ridges` values are tried. Larger settled_below: less smooth, and nearer to the
    // points.
    double first_ridge = 10.0;
    int most_ridges = 11;
    double settled_below = 0.0025;
    // Clouds of fewer than `fewest_to_measure` points count as clean, because their noise cannot be measured. Clouds of
    // fewer than `few_to_measure` points get all starts, because three starts may miss a rival. Clouds of more than two
    // patches are measured at three patches of `patch_size` places.
    std::int64_t fewest_to_measure = 48;
    std::int64_t few_to_measure = 1500;
    std::int64_t patch_size = 2048;

    // ---- A rising ridge

    // Noisy clouds of at most this many points are fitted with rising regularization. Larger: more time.
    std::int64_t few_for_path = 2000;
    // The regularization is high enough for the signs if the energy is below `trusted_below`, and high enough for the
    // directions if the energy is below `path_settled`.
    double trusted_below = 0.0095;
    double path_settled = 0.004;
    // A higher regularization is rejected if at most this share of the signs stays the same. Larger: walls stay apart,
    // more noise is left.
    double path_same_signs = 0.97;
    // After the fit, directions are averaged by a Gaussian of this standard deviation, in spacings. Larger: smoother,
    // rounder edges.
    double smoothed_over = 1.5;

    // ---- Means of directions

    // Smaller noisy clouds are not refined, because one mean would cover all of their area.
    std::int64_t fewest_to_refine = 400;
    // A mean direction uses at most this many nearest neighbours. Its width is from `least_mean_over` to
    // `most_mean_over` spacings, in steps of `mean_over_step`.
    std::int64_t mean_direction_neighbours = 60;
    double least_mean_over = 1.0;
    double most_mean_over = 3.0;
    double mean_over_step = 0.5;
    // The ends of a chord are means of at most `mean_place_neighbours` nearest places, with the width
    // `mean_place_over`. The ends are `chords_from` to `chords_to` spacings apart. The cosine of their normals is at
    // least `same_face`, so both are on one face.
    std::int64_t mean_place_neighbours = 40;
    double mean_place_over = 1.5;
    double chords_from = 2.0;
    double chords_to = 4.0;
    double same_face = 0.5;
    // Means are used if their misfit is below this share of the misfit without means. On smooth surfaces the share is
    // 0.43 to 0.93; at edges and tips, which means round off, it is nearly 1. Larger: more edges are rounded.
    double plainly_better = 0.95;
    // If the best width is at least `smooth_enough` spacings, places of a wall get the direction of the nearer face, in
    // `face_rounds` rounds.
    double smooth_enough = 2.0;
    int face_rounds = 3;
    // The face of a place consists of the places within `faces_within` spacings whose normals have at least the
    // |cosine| `along_face` with its normal. Weights fall by a factor of e over `faces_over` spacings. The weights of
    // the other face must sum to more than `least_other_face`.
    double faces_within = 3.0;
    double faces_over = 1.5;
    double along_face = 0.3;
    double least_other_face = 0.5;

    // ---- Means of points

    // Clouds with more noise than this, in spacings, are replaced by means of points, at most `most_reductions` times.
    // Larger: wrong signs of scans; smaller: less detail.
    double noisiest = 0.55;
    int most_reductions = 3;
    // The means are this many standard deviations of the noise apart, because noise would spread denser means over
    // several layers. There are at least `fewest_means` of them.
    double means_apart = 2.0;
    std::int64_t fewest_means = 500;
    // The normals of the `blended_means` nearest means decide on which side a place's normal points. The plane of the
    // place comes from the points of the `gathered_means` nearest means, weighted by a Gaussian of the standard
    // deviation `means_reach`, in spacings of the means. Larger: smoother.
    std::size_t blended_means = 4;
    std::size_t gathered_means = 48;
    double means_reach = 2.0;
    // A plane is left out if the |cosine| of its normal and the mean normal of the place is below `plane_across`,
    // because it belongs to another face. Other planes add their normals to the mean normal with the weight
    // `plane_weight`.
    double plane_across = 0.5;
    double plane_weight = 2.0;

    // ---- Points along curves

    // The normals of a coarser cloud stay if its energy is below this multiple of the energy of all points. Without
    // noise, the energy of points along curves falls to at most 0.8 when their number doubles. Larger: detail is lost.
    double falling = 1.2;
    // A level with less energy than that cloud replaces it if more than this share of their signs is equal.
    double signs_of_level = 0.97;

    // ---- Confidence

    // Below this confidence a warning is logged, and given normals stay unless they look wrong without the least
    // energy.
    double doubtful = 0.5;
    // At this energy the points have no order, and the confidence is 0.
    double no_order = 0.03;
    // The confidence falls by a factor of e if this share of the signs changes with the regularization.
    double unsteady = 0.03;
    // To test the confidence, the regularization is multiplied by this factor. The signs should not change.
    double softer = 0.125;

    // ---- The outside

    // Winding numbers are measured at `probes` places, `probe_step` local spacings along and against the normals. The
    // step is short enough for thin walls, and long enough for dipoles to look like a surface.
    std::int64_t probes = 192;
    double probe_step = 1.5;
    // A surface is closed if the mean |winding number| on one side is below `closed_below`. The few hundred first
    // places of a cloud of curves are less exact, so their limit is `nearly_closed_below`.
    double closed_below = 0.035;
    double nearly_closed_below = 0.12;
    // The sides differ clearly if their mean |winding numbers| differ by more than this.
    double told_apart = 0.2;
    // plainly_inward() uses at most this many points.
    std::int64_t most_compared = 4096;

    // ---- Given normals

    // Given vectors are normals if the median |cosine| with the normals of least energy is at least this. For colours,
    // the median is about 0.5.
    double meaningful = 0.75;
    // If the least energy is certain, at most this share of correct normals has a |cosine| below 0.5 with the normals
    // of least energy.
    double senseless = 0.2;
    // The signs count as uniform if at least this share agrees, or disagrees, with the least energy. Otherwise they are
    // mixed.
    double all_alike = 0.99;
    // The signs are random if less than this share of pairs agrees. Each place forms pairs with its `beside` nearest
    // neighbours.
    double tossed = 0.75;
    std::int64_t beside = 8;
    // Normals with random signs mostly come from planes through neighbours, which are wrong where both sides of a thin
    // wall or a tip are among these. If such a normal is off the normal of least energy by more than this, in degrees,
    // and nearer to the plane through its neighbours, it is made anew. Larger: more wrong directions stay.
    double off_least_energy = 10.0;
    std::int64_t plane_neighbours = 16;
    // A patch is turned only if its mean |cosine| with the normals of least energy is above this.
    double distinct = 0.5;
    // Around patches that were turned, the mean cosine of neighbouring normals on a sheet is below this: they are
    // opposite. Where the least energy is wrong, because walls are too thin for the noise, the mean is only -0.2 to
    // -0.8.
    double torn = -0.9;
    // If the least energy is doubtful, neighbours with opposite normals may lie on the two sides of a wall. Then most
    // of them lie on one side of a place: at its back, as seen along its normal, or at its front. They count as walls
    // if the shares of these neighbours at the back and at the front differ by more than this. Random signs give equal
    // shares. Larger: fewer walls are found.
    double walls = 0.3;
};
inline constexpr OrientTuning tuning;

struct DepthTuning {
    // The input is a depth image if at least `least_seen` pixels have a point, and the correlations of x / z with the
    // column and of y / z with the row exceed `in_line`.
    std::int64_t least_seen = 64;
    double in_line = 0.99;
    // The radius of a disc, in pixels, for which one standard deviation of depth equals the width of a pixel on the
    // surface. The radius grows with the square root of the deviation. Larger: smoother, and flatter where the surface
    // is curved.
    double widening = 12.0;
    // A camera has depth steps if, on average, at least this many pixels share each value of 1 / z.
    std::int64_t same_steps = 8;
    // The error of a small plane is raised to at least `rounding` times 1 / z, because most images are in single
    // precision. It is limited to `most_curved` times 1 / z, or to the noise if that is larger. Larger: more is
    // smoothed over an edge.
    double rounding = 1e-6;
    double most_curved = 5e-3;
    // Pixels farther off the plane than this, in standard deviations of the noise, lie beyond an edge. For a camera
    // with depth steps, this is 2.5 steps. Larger: edges are rounder, fewer points are left out.
    double gate = 6.5;
    // A plane is fitted `plane_rounds` times. A fit fails if the remaining pixels have less than the share `least_part`
    // of the disc's weight.
    int plane_rounds = 2;
    double least_part = 0.1;
    // Discs of up to this radius, in pixels, use all their pixels. Larger discs use `rings` rings: the first has 6
    // pixels, and each further ring 6 more. Larger: more time.
    std::int32_t all_pixels_up_to = 5;
    int rings = 6;
    // The weight of a pixel at a disc's rim; it is 1 in the middle.
    double least_weight = 0.1;
};
inline constexpr DepthTuning depth_tuning;

} // namespace hrbfnpr::orient
