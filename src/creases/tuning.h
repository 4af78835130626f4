// SPDX-License-Identifier: MIT
// The tuning constants of creases. A side is the longest side of the mesh's cells. scripts/bench edges measures their
// effects on trees of solids and on fitted patches.
#pragma once

namespace hrbfnpr::curves {

struct CreaseTuning {
    // ---- The mesh that is cut at creases

    // A place counts as a place of the whole surface if its distance from the surface is at most this, in sides.
    // Larger: creases continue beyond corners.
    double on_surface = 1e-3;
    // A crease continues through a seam between two patches, where the surface blends the patches, if the sheets meet
    // within this distance of the surface, in sides. Larger: creases appear that another sheet covers.
    double beside_surface = 0.02;
    // Sheets nearly coincide if both their distance, in sides, and the angle between their normals, in radians, are at
    // most this. Edges between such sheets are not halved to find hidden creases. Larger: shallow creases are coarse.
    double alike = 0.02;
    // Sheets coincide if both their distance, in sides, and the angle between their normals, in radians, are at most
    // this. Larger: sheets that cross are merged.
    double equal = 1e-7;
    // The place where two sheets meet is searched for within this many sides of an edge, or this many times twice the
    // edge's length if that is less. Larger: nodes are placed on creases that do not belong to the edge.
    double farthest_meeting = 1.5;
    // Sheets are not tested for a fold if the sine of half the angle between them is below this, because the curvature
    // of the sheets may exceed the angle. Larger: creases continue behind other sheets.
    double least_sine = 0.02;
    // A crease continues through a seam only if the sine of half the angle between its sheets is above this, so the
    // angle is above 11 degrees. Smaller: creases of screw threads leave the threads.
    double sharp_sine = 0.1;
    // Edges shorter than this are not halved, in sides. Smaller: more triangles at corners.
    double shortest_edge = 0.01;
    // The greatest number of rounds in which edges are halved, and of rounds in which sheets are merged. More: finer
    // corners, more time.
    int rounds = 6;
    int settlings = 20;

    // ---- Creases as curves

    // Nodes closer than this to the previous node, in sides, are dropped. If a gap of inexact nodes is wider than this,
    // the crease ends. Larger: fewer points, and more gaps are bridged.
    double nearest_node = 0.1;
    // A piece is halved if it is longer than `longest_piece`, in sides. It is also halved if it is longer than
    // `shortest_piece` and turns by more than 0.1 radians, given as a cosine. Creases shorter than `shortest_piece` are
    // dropped.
    double longest_piece = 1.0;
    double shortest_piece = 1e-3;
    double straight_turn = 0.995;
    // The next point lies forwards or backwards along a crease if the cosine between the step and the crease exceeds
    // this in magnitude. Smaller: more points are dropped near corners.
    double returns = 0.7;
    // If the sine of the angle between sheets is below this, the direction of a crease is computed from its points
    // instead of the normals.
    double least_crease_sine = 1e-3;
    // A place is on a crease only if it is within this distance of the crease, in sides.
    double farthest_beside = 0.5;
};
inline constexpr CreaseTuning crease_tuning;

} // namespace hrbfnpr::curves
