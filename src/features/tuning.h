// SPDX-License-Identifier: MIT
// The tuning constants of feature lines, of sections and borders, and of the mesh that they are found on. "Sides" are
// those of the mesh's cells, "diagonals" those of the model's bounds.
#pragma once

#include <cstdint>

namespace hrbfnpr::curves {

struct FeatureTuning {
    // ---- Points of feature lines

    // A root is found where g is this much smaller than at the ends of its edge. Smaller: more evaluations.
    double small_enough = 1e-4;
    // The best place is a root after the last round if g is this much smaller there. Larger: lines that cross noise.
    double acceptable = 0.1;
    // Apparent ridges end where n . v is below this, since their curvature grows without bound at the contour. Larger:
    // they end farther from it.
    double grazing = 0.02;
    // Chains whose strength at the vertices stays below this share of `upper` are not refined. Larger: less time, but
    // lines are lost whose strength the mesh does not see.
    double promising = 0.7;
    // A ridge or valley is as strong as its curvature where the curvature drops by this, as weigh_by_drop() measures.
    // Larger: weaker ridges on round tubes. An ellipse has 3 (1 - (b / a)^2) at the end of its longer axis.
    double full_drop = 0.5;
    // That drop is measured this many sides away at least, since derivatives at one place would take the ripple of a
    // fit for ridges, and this many diagonals at most. Larger: small ridges are weaker.
    double least_aside = 2.0;
    double most_aside = 0.1;
    // The sign of the derivative along a line is taken of its mean over this many crossings to either side. Larger:
    // fewer interruptions, and short extrema are missed.
    std::int64_t crossings_beside = 2;
    // Points of a line that are nearer to each other are one, in sides. Larger: fewer points.
    double least_gap = 1e-3;

    // ---- The mesh

    // An edge is halved if a line may be off by this where a curvature does not change as its derivatives say, in
    // diagonals. Smaller: more triangles.
    double off_line = 3e-4;
    // Derivatives of curvature count as at least this part of their root mean square. Larger: flat parts stay coarse.
    double least_change = 0.3;
    // Edges are halved this many times. More: rough fits are followed more closely, at a cost.
    int halvings = 3;
    // The middle of an edge stays within this part of its length from the surface. Larger: edges across thin walls are
    // halved.
    double farthest_middle = 0.4;
    std::int64_t most_triangles = 4'000'000;

    // ---- Sections and borders

    // Newton's steps to a point of a section end when they are this short, in diagonals.
    double section_tolerance = 1e-9;
    // The end of a section's line moves to a crease within this many sides. Larger: ends of other lines move, too.
    double corner_reach = 0.75;
    // Where two lines of a section meet at an angle, this many sides of each are left out, so that cubics do not
    // overshoot. Larger: visibly round corners.
    double around_corner = 1e-4;
    // Tangents whose angle has a larger cosine meet smoothly.
    double smooth = 0.9999;
    // Points of a border are left out that are nearer to the one before, in sides. Smaller: more points.
    double border_gap = 0.1;
    // The border has a point more where it turns by more than 0.1 radians, as a cosine, or where points are farther
    // apart than this, in sides. It is finer than contours, which end on it.
    double border_turn = 0.995;
    double longest_border_piece = 0.5;
    double shortest_border_piece = 1e-3;

    // ---- The set of all lines

    // Cells of the mesh are this many a mean spacing of the seeds, or a diagonal if no spacing is known. More: more
    // detail and time.
    double sides_a_spacing = 2.0;
    double sides_a_diagonal = 96.0;
    // Seeds are looked for from this many points of the bounds along each axis. More: smaller parts are found.
    std::int64_t lattice = 24;
    // The mesh is made again with smaller cells if more than this share of its triangles looks away from the surface,
    // since walls are thinner than the cells; or more than `torn_share` if smaller cells cost much. Smaller: finer
    // meshes.
    double turned_share = 2e-4;
    double torn_share = 2e-2;
    std::int64_t most_triangles_of_finer = 1'200'000;
    // A line of the caller's is cut where it turns by more than this cosine, 25 degrees, so that corners stay sharp.
    double own_corner = 0.906;
};
inline constexpr FeatureTuning feature_tuning;

} // namespace hrbfnpr::curves
