// SPDX-License-Identifier: MIT
// The tuning constants of finding normals and of smoothing depth images. A spacing is the median distance between
// nearest points; energies are over the degrees of freedom, in spacings. Set by scripts/bench orient on analytic
// surfaces, thin walls, wires and scans, clean and with noise, and by tests/orient where that is said.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hrbfnpr::orient {

struct OrientTuning {
    // ---- The cloud

    // Points that are nearer to each other than this are one, in spacings. Larger: thin walls may merge.
    double merged = 0.01;
    // Neighbours of each place that are found. Larger: directions are means over more of the surface.
    std::int64_t most_neighbours = 32;
    // Neighbours of this many places connect pieces if they are no farther apart than this, in local spacings. Larger:
    // solids that are close are one piece.
    std::int64_t linked = 8;
    double link_length = 3.0;
    // Points along curves have from this many to twice as many first places that stand all over the surface. Larger:
    // the first level may see single curves.
    std::int64_t fewest_all_over = 64;

    // ---- Effort

    // Clouds of up to this many points get all starts, and are not replaced by means. Larger: more time.
    std::int64_t few_points = 6000;
    // Clouds above this get one start. Larger: more time.
    std::int64_t many_points = 150000;
    // Clouds above this begin with patches. Larger: more time.
    std::int64_t many_places = 100000;
    // Each place is conditioned on this many neighbours, those of fewer than few_places places on more. Larger: the
    // sparse energy is nearer to the true one, and takes more time.
    std::int32_t neighbours = 16;
    std::int32_t neighbours_of_few = 32;
    std::int64_t few_places = 1000;

    // ---- Signs

    // Clusters that are not each other's partner join, too, if their coupling is above this share of the most that it
    // may be; or if one has this many times the members of the other, in clouds above `careful`. Smaller: fewer rounds,
    // more of which must be undone.
    double sure_strength = 0.5;
    std::int64_t large = 4;
    std::int64_t careful = 2000;
    // Levels of clusters are kept that have at most this share of the clusters of the one before. Larger: more levels.
    double kept_share = 0.3;
    // Clusters are turned in this many sweeps at most, and where that gains more than this share of their own energy,
    // which is more than rounding.
    int most_sweeps = 4;
    double least_gain = 1e-6;
    // Patches are made of this many nearest neighbours at most, whose normals have at least this cosine, and which lie
    // within this sine of the surface. Larger sine or smaller cosine: patches may reach over edges.
    std::int64_t patch_neighbours = 8;
    double patch_alike = 0.9;
    double patch_beside = 0.35;

    // ---- Directions

    // The descent remembers this many pairs of steps and changes of the gradient, makes this many steps at most, and
    // ends where looked_back of them gain less than this share of the energy. Larger: more time.
    int curvature_pairs = 6;
    int most_steps = 60;
    int looked_back = 5;
    double enough_gain = 1e-5;
    // A step turns no normal by more than this, in radians; it is halved this often at most, until the energy falls by
    // this share of what its slope promises.
    double longest_turn = 0.5;
    int step_halvings = 12;
    double armijo = 1e-4;

    // ---- Starts

    // Two results are one if their energies are no farther apart than this share. Larger: fewer starts.
    double same_energy = 0.03;
    // The weight of a start in the agreement falls by e with this share of more energy. Larger: starts that failed cost
    // more confidence.
    double unlikely_energy = 0.15;
    // A start is a rival if fewer signs than this share are the same.
    double other_signs = 0.95;

    // ---- Noise

    // Clean clouds have energies of 1e-7 (smooth) to 0.006 (sharp edges), noisy ones above 0.018, points without any
    // order 0.026. Clouds below this are clean.
    double clean_below = 0.012;
    // Clean clouds that are much too sparse for their details may be above this, too. They are told from noisy ones by
    // two signs: another choice of signs has more energy by at least `noisy_rival`, and a ridge leaves more than
    // `same_signs` of the signs as they were. Larger: more clouds count as noisy.
    double no_order_above = 0.02;
    double noisy_rival = 1.05;
    double same_signs = 0.9;
    // Ridges are tried from the first one on, each larger by the same factor, until one brings the energy below
    // `settled_below` or this many were tried. Larger settled_below: less smooth, and nearer to the points.
    double first_ridge = 10.0;
    int most_ridges = 11;
    double settled_below = 0.0025;
    // Fewer points have no noise that could be measured; fewer than few_to_measure get all starts, since a rival may be
    // missed by three. Clouds of more than two patches are measured at three patches of this size.
    std::int64_t fewest_to_measure = 48;
    std::int64_t few_to_measure = 1500;
    std::int64_t patch_size = 2048;

    // ---- A rising ridge

    // Noisy clouds of up to this many points are fitted with a rising ridge. Larger: more time.
    std::int64_t few_for_path = 2000;
    // Below the first energy the ridge is high enough for the signs, below the second for the directions.
    double trusted_below = 0.0095;
    double path_settled = 0.004;
    // A higher ridge is no better if fewer signs than this share stay. Larger: walls stay apart, more noise is left.
    double path_same_signs = 0.97;
    // Directions are then means by a Gaussian of this deviation, in spacings. Larger: smoother, edges are rounder.
    double smoothed_over = 1.5;

    // ---- Means of directions

    // Noisy clouds of fewer points are no larger than what directions would be means over.
    std::int64_t fewest_to_refine = 400;
    // Directions are means over one of these widths, in spacings, of the nearest neighbours.
    std::int64_t mean_direction_neighbours = 60;
    double least_mean_over = 1.0;
    double most_mean_over = 3.0;
    double mean_over_step = 0.5;
    // Chords are between means of this many nearest places at most over this width, for pairs of places from two to
    // four spacings apart whose normals have at least this cosine: they are on one face.
    std::int64_t mean_place_neighbours = 40;
    double mean_place_over = 1.5;
    double chords_from = 2.0;
    double chords_to = 4.0;
    double same_face = 0.5;
    // Means of a smooth surface have 0.43 to 0.93 of the misfit without; a little less have edges and tips, which means
    // round off. Larger: more edges are rounded.
    double plainly_better = 0.95;
    // Points look the way of the nearer face of a wall if means over this many spacings fit best, in this many rounds.
    double smooth_enough = 2.0;
    int face_rounds = 3;
    // The faces are the places within faces_within spacings, by a weight that falls by e in faces_over, whose normals
    // are along the place's own by this cosine; the other face must have this weight.
    double faces_within = 3.0;
    double faces_over = 1.5;
    double along_face = 0.3;
    double least_other_face = 0.5;

    // ---- Means of points

    // Clouds with more noise than this, in spacings, are replaced by means, at most this often. Larger: wrong signs of
    // scans; smaller: less detail.
    double noisiest = 0.55;
    int most_reductions = 3;
    // The means are this many deviations apart: nearer, they would be layers of the noise. There are at least this
    // many.
    double means_apart = 2.0;
    std::int64_t fewest_means = 500;
    // This many nearest means tell the side of a place, and the points of these make its plane, by a Gaussian of this
    // deviation in spacings of the means. Larger: smoother.
    std::size_t blended_means = 4;
    std::size_t gathered_means = 48;
    double means_reach = 2.0;
    // A plane with a smaller cosine to the side stands across it, as a wall's does. Other planes count this much
    // beside the side.
    double plane_across = 0.5;
    double plane_weight = 2.0;

    // ---- Points along curves

    // Without noise twice as many points along curves have 0.8 of the energy and less: a coarser cloud stays if its
    // energy is below this share of that of all points. Larger: detail is lost.
    double falling = 1.2;
    // It may be a finer one of which this share of the signs is the same.
    double signs_of_level = 0.97;

    // ---- Confidence

    // A lower confidence is warned of, and given normals then stay in doubt.
    double doubtful = 0.5;
    // An energy that says that there is no order.
    double no_order = 0.03;
    // Confidence falls by e with this share of signs that change with the ridge.
    double unsteady = 0.03;
    // Signs should stay with a ridge that is smaller by this factor.
    double softer = 0.125;

    // ---- The outside

    // Winding numbers are measured at this many places, this many local spacings along and against the normals: near
    // enough for thin walls not to matter outside, and far enough for dipoles to be a surface.
    std::int64_t probes = 192;
    double probe_step = 1.5;
    // A surface is closed if their mean on one side is below this; some hundred places tell no better than the second.
    double closed_below = 0.035;
    double nearly_closed_below = 0.12;
    // Sides are told apart by a larger difference of winding numbers than this.
    double told_apart = 0.2;
    // A quick look at given normals takes this many points.
    std::int64_t most_compared = 4096;

    // ---- Given normals

    // Half of normals that are some have a cosine above this with those of least energy; of colours half are above 0.5.
    double meaningful = 0.75;
    // No more than this share of them, where those of least energy are sure, has one below 0.5.
    double senseless = 0.2;
    // Signs are all alike if more than this share agrees; between they are mixed.
    double all_alike = 0.99;
    // Signs are no more than a toss if fewer neighbours than this share agree, of this many.
    double tossed = 0.75;
    std::int64_t beside = 8;
    // A patch that is turned has a direction of its own: the mean |cosine| with the least energy is above this.
    double distinct = 0.5;
    // Around patches that were turned the normals of neighbours on a sheet are opposite: -0.97 and below. Around walls
    // too thin for the noise, where the least energy is wrong and the normals right, they are not: -0.2 to -0.8.
    double torn = -0.9;
    // In doubt, neighbours that point opposite ways are the two sides of walls if the share of them that lie at the
    // back of each other differs by more than this from the share of those at the front. Random signs give equal
    // shares. Larger: fewer walls are seen.
    double walls = 0.3;
};
inline constexpr OrientTuning tuning;

struct DepthTuning {
    // An image has at least this many points, and its directions go with the pixels by this correlation.
    std::int64_t least_seen = 64;
    double in_line = 0.99;
    // A disc has this radius, in pixels, where one standard deviation of depth is as wide as a pixel, and grows with
    // its root. Larger: smoother, and flatter where the surface is curved.
    double widening = 12.0;
    // A camera has depth steps if there are at least this many pixels for each value of 1 / z.
    std::int64_t same_steps = 8;
    // The error off a plane at a pixel is at least the first share of 1 / z, as most images come in single precision,
    // and at most the second, if it is not noise. Larger: more is smoothed over an edge.
    double rounding = 1e-6;
    double most_curved = 5e-3;
    // Pixels that are farther off the plane than this lie beyond an edge, in standard deviations of the noise; of a
    // camera with depth steps these are 2.5 of them. Larger: edges are rounder, fewer points are left out.
    double gate = 6.5;
    // A plane is fitted this many times, and only to at least this part of the disc's weight.
    int plane_rounds = 2;
    double least_part = 0.1;
    // Discs of up to this radius, in pixels, have all their pixels. Larger discs have this many rings, the first of 6
    // pixels and each next one of 6 more. Larger: more time.
    std::int32_t all_pixels_up_to = 5;
    int rings = 6;
    // The weight at a disc's rim, of 1 in its middle.
    double least_weight = 0.1;
};
inline constexpr DepthTuning depth_tuning;

} // namespace hrbfnpr::orient
