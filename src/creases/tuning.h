// SPDX-License-Identifier: MIT
// The tuning constants of creases. "Sides" are those of the mesh's cells. scripts/bench edges measures
// their effects on trees of solids and on fitted patches.
#pragma once

namespace hrbfnpr::curves {

struct CreaseTuning {
    // ---- The mesh that is cut at creases

    // A place is on the whole surface if it is within this of it, in sides. Larger: creases go on beyond corners.
    double on_surface = 1e-3;
    // Where sheets meet this near to the surface, in sides, a crease goes on through a seam between two patches, which
    // blends them. Larger: creases appear that are covered by another sheet.
    double beside_surface = 0.02;
    // Sheets that are no farther apart than this, in sides, and as parallel, in radians, are nearly one: no crease is
    // looked for beyond others. Larger: shallow creases are coarse.
    double alike = 0.02;
    // The same for sheets that are one. Larger: sheets are merged that cross.
    double equal = 1e-7;
    // Sheets may meet as far as this from an edge, in sides, or twice the edge's length if that is less. Larger:
    // creases of other places are found.
    double farthest_meeting = 1.5;
    // Below this sine of half their angle, sheets are not tested for a fold, since their curvature may be more than the
    // angle. Larger: creases pass other sheets.
    double least_sine = 0.02;
    // No crease goes on through a seam where that sine is smaller: 11 degrees. Smaller: creases of winding threads
    // leave them, as a screw's do.
    double sharp_sine = 0.1;
    // Edges shorter than this are not halved, in sides. Smaller: more triangles at corners.
    double shortest_edge = 0.01;
    // Edges are halved in this many rounds at most, and sheets merged in this many. More: finer corners, more time.
    int rounds = 6;
    int settlings = 20;

    // ---- Creases as curves

    // Nodes nearer than this to the one before say nothing more, in sides; wider gaps of inexact nodes end a crease.
    // Larger: fewer points, and more gaps are bridged.
    double nearest_node = 0.1;
    // A piece is halved if it is longer than the first, in sides, or if it turns by more than 0.1 radians, as a cosine,
    // and is longer than the second. Creases shorter than the second are dropped.
    double longest_piece = 1.0;
    double shortest_piece = 1e-3;
    double straight_turn = 0.995;
    // Steps along a crease are forth or back if the cosine of the angle to it is larger. Smaller: more points are
    // dropped beside corners.
    double returns = 0.7;
    // Below this sine of the angle between sheets, a crease runs as its points say, not as both normals do.
    double least_crease_sine = 1e-3;
    // A place is on a crease if it is within this of it at most, in sides.
    double farthest_beside = 0.5;
};
inline constexpr CreaseTuning crease_tuning;

} // namespace hrbfnpr::curves
