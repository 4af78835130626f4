// SPDX-License-Identifier: MIT
// The tuning constants of feature lines, of sections and borders, and of the mesh on which they are found. A side is
// the longest side of the mesh's cells. A diagonal is the diagonal of the model's bounds.
#pragma once

#include <cstdint>

namespace hrbfnpr::curves {

struct FeatureTuning {
    // ---- Points of feature lines

    // A search for a root ends where |g| is below this share of its values at the ends of the edge. Smaller: more
    // evaluations.
    double small_enough = 1e-4;
    // After the last round, the best place counts as a root if |g| is below this share of its values at the ends of the
    // edge. Larger: lines that cross noise.
    double acceptable = 0.1;
    // Apparent ridges end where n . v is below this, since their curvature is unbounded at the contour. Larger: the
    // ridges end farther from the contour.
    double grazing = 0.02;
    // Chains are refined only if their strength at the vertices reaches this share of `upper`. Larger: less time, but
    // lines are lost whose strength the mesh does not show.
    double promising = 0.7;
    // A ridge or valley keeps its full strength if the drop of its curvature, as measured by weigh_by_drop(), is at
    // least this. Larger: ridges on round tubes are weaker. At the end of the longer axis of an ellipse the drop is 3
    // (1 - (b / a)^2).
    double full_drop = 0.5;
    // The drop is measured at a distance of at least `least_aside` sides, because ripples of a fit would look like
    // ridges if derivatives at a single place were used. The distance is at most `most_aside` diagonals. Larger: small
    // ridges are weaker.
    double least_aside = 2.0;
    double most_aside = 0.1;
    // The sign of the derivative along a line is the sign of its sum over this many crossings on either side. Larger:
    // fewer interruptions, but short extrema are missed.
    std::int64_t crossings_beside = 2;
    // Points of a line that are closer than this count as one, in sides. Larger: fewer points.
    double least_gap = 1e-3;

    // ---- Soft edges

    // The standard deviation of the bell curve over which normals are averaged, in sides, and at least this share of
    // the diagonal. Larger: smoother and fewer lines, and small edges are lost. Set on bunny, skull, falcon and lion.
    double blur_sides = 1.4;
    double blur_diagonals = 0.0042;
    // The turn of the surface is measured up to this distance on both sides, in blurs. Larger: rounder edges are found,
    // and edges that are close together are lost.
    double turn_reach = 2.8;
    // One of this many crossings of a line and the mesh is measured. Larger: less time, less exact strengths.
    std::int64_t crossings_a_turn = 4;
    // The strength is averaged along the line up to this distance on both sides, in reaches of the turn. Larger: fewer
    // gaps, and edges that end softly.
    double strength_reach = 2.0;
    // The integral of the strength above `lower` along a line is at least this, in degrees times diagonals. Larger:
    // only long and strong lines are kept.
    double least_soft_edge = 2.5;

    // ---- The mesh

    // An edge is halved if curvatures do not change along the edge as their derivatives predict, and if this may
    // displace lines by more than this distance, in diagonals. Smaller: more triangles.
    double off_line = 3e-4;
    // Where derivatives of curvature are small, this share of their root mean square is used instead. Larger: flat
    // parts stay coarse.
    double least_change = 0.3;
    // The number of rounds in which edges are halved. More: rough fits are followed more closely, more time.
    int halvings = 3;
    // The middle of a halved edge may move by at most this share of the edge's length. Larger: edges across thin walls
    // are halved.
    double farthest_middle = 0.4;
    std::int64_t most_triangles = 4'000'000;

    // ---- Sections and borders

    // Newton's method for a point of a section ends after a step shorter than this, in diagonals.
    double section_tolerance = 1e-9;
    // The end of a section's line is moved to a crease within this distance, in sides. Larger: ends of other lines
    // move, too.
    double corner_reach = 0.75;
    // Where two lines of a section meet at an angle, this length of each is left out, in sides, so that cubics do not
    // overshoot. Larger: visibly round corners.
    double around_corner = 1e-4;
    // Two lines meet smoothly if the cosine of the angle between their tangents is above this.
    double smooth = 0.9999;
    // Points of a border closer than this to the previous one are dropped, in sides. Smaller: more points.
    double border_gap = 0.1;
    // The border gets another point where it turns by more than 0.1 radians, given as a cosine, or where points are
    // more than `longest_border_piece` apart, in sides. The border is divided more finely than contours, because
    // contours end on it.
    double border_turn = 0.995;
    double longest_border_piece = 0.5;
    double shortest_border_piece = 1e-3;

    // ---- Intersections of two surfaces

    // A surface bulges beyond its triangles by at most this, in sides. Larger: more time; smaller: intersections of
    // surfaces that only touch are missed.
    double crossing_reach = 0.25;
    // Surfaces are taken for touching, and have no intersection, if they meet at a mean angle below this, in degrees.
    // Larger: intersections of nearly parallel surfaces are lost. Smaller: two fits of one face have intersections that
    // are only noise.
    double least_crossing = 2.0;
    // Surfaces that are nearly parallel coincide where they are closer than this, in sides. Larger: a flat bump above a
    // face has no intersection.
    double coincident = 0.1;

    // ---- The set of all lines

    // The number of cells along the mean spacing of the seeds, or along a diagonal if no spacing is known. More: more
    // detail and time.
    double sides_a_spacing = 2.0;
    double sides_a_diagonal = 96.0;
    // Searches for seeds begin at this many points along each axis of the bounds. More: smaller parts are found.
    std::int64_t lattice = 24;
    // The mesh is made again with smaller cells if more than this share of its triangles faces away from the surface,
    // because then walls are thinner than the cells. The limit is `torn_share` if smaller cells would give more than
    // `most_triangles_of_finer` triangles. Smaller: finer meshes.
    double turned_share = 2e-4;
    double torn_share = 2e-2;
    std::int64_t most_triangles_of_finer = 1'200'000;
    // Given triangles are not used if more than this share of their vertices is farther than a side from the surface.
    // Larger: meshes whose solids cross take minutes.
    double vertices_off = 0.01;
    // The width of the strips along the border of given triangles, in least spacings of the samples that end the
    // surface, or else in sides. Larger: the end may be farther from the border of the triangles, but strips of thin
    // walls meet.
    double strip = 1.5;
    // Parts with fewer triangles than this are traced by one thread each. Larger: more threads wait at the end for the
    // last part.
    std::int64_t small_part = 20'000;
    // If the eye is farther away than this, in diagonals, lines of sight count as parallel. The resulting contours are
    // the same to the last digit.
    double parallel_distance = 1e9;
    // A line of the caller is cut where the cosine of its turn is below this (25 degrees), so that corners stay sharp.
    double own_corner = 0.906;
};
inline constexpr FeatureTuning feature_tuning;

} // namespace hrbfnpr::curves
