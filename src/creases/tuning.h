// SPDX-License-Identifier: MIT
// The tuning constants of creases. A side is the longest side of the mesh's cells. scripts/bench edges measures their
// effects on trees of solids and on fitted patches.
#pragma once

namespace hrbfnpr::curves {

struct CreaseTuning {
    // ---- The mesh that is cut at creases

    // A place is on the whole surface if it is within this distance of it, in sides. Larger: creases continue beyond
    // corners.
    double on_surface = 1e-3;
    // If sheets meet this near to the surface, in sides, a crease continues through a seam between two patches, where
    // the surface blends them. Larger: creases appear that another sheet covers.
    double beside_surface = 0.02;
    // Sheets nearly coincide if they are closer than this, in sides, and if their normals differ by less than the
    // second number, in radians. Edges between them are not halved to find hidden creases. Larger: shallow creases are
    // coarse.
    double alike = 0.02;
    // The same two limits for sheets that coincide. Larger: sheets that cross are merged.
    double equal = 1e-7;
    // Sheets may meet at most this far from an edge, in sides, or within twice the edge's length if that is less.
    // Larger: creases of other places are found.
    double farthest_meeting = 1.5;
    // If the sine of half the angle between sheets is below this, they are not tested for a fold, since their curvature
    // may exceed the angle. Larger: creases pass other sheets.
    double least_sine = 0.02;
    // A crease continues through a seam only if the sine of half the angle between its sheets is above this: 11
    // degrees. Smaller: creases of winding threads, such as a screw's, leave the threads.
    double sharp_sine = 0.1;
    // Edges shorter than this are not halved, in sides. Smaller: more triangles at corners.
    double shortest_edge = 0.01;
    // The greatest number of rounds of halving edges, and of rounds of merging sheets. More: finer corners, more time.
    int rounds = 6;
    int settlings = 20;

    // ---- Creases as curves

    // Nodes nearer than this to the previous one are dropped, in sides; wider gaps of inexact nodes end a crease.
    // Larger: fewer points, and more gaps are bridged.
    double nearest_node = 0.1;
    // A piece is halved if it is longer than `longest_piece`, in sides. It is also halved if it is longer than
    // `shortest_piece` and turns by more than 0.1 radians, given as a cosine. Creases shorter than `shortest_piece` are
    // dropped.
    double longest_piece = 1.0;
    double shortest_piece = 1e-3;
    double straight_turn = 0.995;
    // A step goes along a crease, forwards or backwards, if the cosine of its angle to the crease exceeds this in
    // magnitude. Smaller: more points are dropped near corners.
    double returns = 0.7;
    // If the sine of the angle between sheets is below this, the direction of a crease comes from its points, not from
    // the normals.
    double least_crease_sine = 1e-3;
    // A place is on a crease only if it is within this distance of it, in sides.
    double farthest_beside = 0.5;
};
inline constexpr CreaseTuning crease_tuning;

} // namespace hrbfnpr::curves
