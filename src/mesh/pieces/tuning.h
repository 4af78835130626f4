// SPDX-License-Identifier: MIT
// The tuning constants for cutting a mesh into patches, for fitting their sheets, and for the cells that join the
// sheets. A diagonal is the diagonal of the mesh's bounds.
#pragma once

#include <cstdint>

namespace hrbfnpr::mesh {

// Set on the models of `scripts/bench edges --only=verdict`, and on scans of 17 000 to 80 000 faces.
struct HasCreasesTuning {
    // The mesh is examined beside an edge up to this distance, in heights of the face there. Above 1, the distance
    // includes the edges of the next faces, however quads are cut. Larger: edges beside narrow faces stand out less.
    double reach = 1.5;
    // An edge stands out if its bend is at least this many times the angle by which the mesh turns beside it. Larger:
    // fewer edges stand out.
    double stands_out = 4.0;
    // Two faces belong to one flat polygon if the edge between them bends by less than this, in degrees. Larger:
    // coordinates may have fewer digits, and more bent quads count as flat.
    double flat = 0.2;
    // Edges that bend by more than this, in degrees, are not round: a ring of six sides does not approximate a circle.
    // Such an edge stands out if one of its faces belongs to a flat polygon. Larger: fewer edges between narrow walls
    // are sharp.
    double surely_sharp = 60.0;
    // Faces farther from a round surface than this are flat, in diagonals. The faces of a ball of 80 faces are 0.009
    // away, those of an icosahedron 0.03. Larger: fewer rocks have edges.
    double far_off = 0.02;
    // An edge of a polyhedron is sharp if one of its faces is farther from a round surface than this, in diagonals.
    // Larger: blunter edges and smaller faces stay smooth.
    double near_enough = 0.002;
    // The walk beside an edge ends after this many faces. Larger: longer fans of needles are crossed.
    std::int64_t most_faces = 256;
};
inline constexpr HasCreasesTuning has_creases_tuning;

// The constants of tangent edges. Set on brackets, rounded boxes, run-outs of cylinders and capsules of 3 to 40 faces
// in a quarter circle, and on scans and subdivided meshes, which have none.
struct TangentTuning {
    double degrees = 57.29577951308232; // degrees in a radian
    // Faces lie in one plane if they bend by less than this, in degrees, and what rounding may add. Larger: finer
    // fillets count as flat.
    double flat = 0.01;
    // The rounding error of coordinates, in diagonals. Larger: narrow faces of exact meshes count as flat.
    double rounding = 2.5e-7;
    // The curvature beside an edge is measured up to this distance, in heights of the face there. Larger: fillets of
    // few faces are measured across their whole width.
    double reach = 1.9;
    // The relative difference up to which two curvatures, or two bends, count as equal where both sides of an edge
    // bend. Larger: surfaces whose curvature varies have tangent edges.
    double steady = 0.12;
    // Two curvatures are different if they differ by this share of the larger one. Larger: fewer tangent edges.
    double change = 0.4;
    // The relative difference between the bend at an edge and the expected one, for a candidate and for a whole line.
    // In a round wall of equal faces it is 1. Larger: more irregular meshes have tangent edges, and so have walls whose
    // curvature varies.
    double off_of_edge = 0.6;
    double off_of_line = 0.3;
    // Beyond its first face, the flat side may have at most this share of the curvature of the other side. Larger: more
    // edges beside a change of curvature count, too.
    double stays_flat = 0.35;
    // A single triangle is flat if it is this many times as wide as the faces beyond the edge. Larger: cones have fewer
    // tangent edges.
    double surely_wide = 3.0;
    // The cosine of the largest turn between two edges of a line. Larger: lines end at smaller turns.
    double aligned = 0.64;
    // The least length of a line, in widths of the faces beside it, also if its bends are on average as expected up to
    // the relative difference `off_of_exact`. Larger: fewer short lines.
    double shortest = 8.0;
    double shortest_exact = 2.5;
    double off_of_exact = 0.1;
    // A component has tangent edges if candidates that form no line are at most this many times as long as those that
    // do. Larger: noise has tangent edges.
    double most_rejected = 0.5;
    // A walk ends after this many faces. Larger: wider triangulated planes are crossed.
    std::int64_t most_faces = 256;
};
inline constexpr TangentTuning tangent_tuning;

// The constants of creases and of the patches between them. Set by scripts/bench edges on its models of machine parts.
struct CreaseTuning {
    // A crease with a free end is extended along edges that bend by at least this, in degrees. Larger: fading creases
    // end sooner.
    double least_bend = 8.0;
    // A crease with a free end is extended only where the cosine of its turn is at least this. Larger: creases stop at
    // turns.
    double aligned = 0.6;
    // A crease that separates no patches is dropped if it is shorter than this, in diagonals, or has fewer than
    // `fewest_fading` edges. Larger: fewer short creases.
    double shortest_fading = 0.03;
    std::int64_t fewest_fading = 4;
    // A patch joins a neighbour if it has fewer faces than this and its area is less than the square of `scrap_size`
    // diagonals. Larger: fewer tiny sheets.
    std::int64_t scrap_faces = 10;
    double scrap_size = 0.002;
    // A patch is a crumb if it has at most this many faces, its area is less than the square of `crumb_size` diagonals
    // of its component, and the cosine between two of its normals is below `crumb_cosine`. A single small face is a
    // crumb, too. Larger: more patches are crumbs.
    std::int64_t crumb_faces = 40;
    double crumb_size = 0.06;
    double crumb_cosine = 0.99985;
    // At a smooth cut, each sheet is also fitted to faces beyond the cut. Their distance from the cut is at most this
    // many diagonals, and at most `band_share` times their distance from the nearest crease. Larger: the sheets agree
    // better at the cut, and have more centres.
    double widest_band = 0.04;
    double band_share = 0.4;
    // The end of a patch between two parts of another patch is a tip if its angle is at most this, in radians. Larger:
    // more patches are cut at tips.
    double widest_tip = 1.0;
};
inline constexpr CreaseTuning crease_tuning;

// The constants of the fit of one sheet. Set by scripts/bench edges. Most sheets there are planes, parts of cylinders
// and fillets, which need few centres and short rounds.
struct SheetTuning {
    // The number of evenly spread samples that a fit begins with: for patches in a plane, and for others. Larger:
    // slower fits and evaluations.
    std::int64_t centres_in_plane = 3;
    std::int64_t first_centres = 8;
    std::int32_t most_rounds = 12;
    // A round adds at most this share of the existing number of centres, but may always add `smallest_batch`. Larger:
    // fewer rounds, and more centres that were not needed.
    double batch = 0.7;
    std::int64_t smallest_batch = 12;
    // Centres are at least this many tolerances apart. Larger: fewer centres along creases, which are less exact.
    double apart = 4.0;
    // Sheets of patches with fewer faces than `large` are fitted at the same time, each on one thread, `at_once` at a
    // time. Sheets of larger patches use all threads, one after the other, unless at least `many_large` are left.
    // Larger: more memory, and threads that wait for the last sheet. The sheets are the same.
    std::int64_t large = 512;
    std::int64_t many_large = 8;
    std::int64_t at_once = 64;
};
inline constexpr SheetTuning sheet_tuning;

// The constants of patches, their normals and their samples. Set by scripts/bench edges --only=pieces, and on CAD files
// and low-poly meshes.
struct PatchTuning {
    // ---- Normals

    // At a vertex with more corners than this, each patch has one normal, and flats and tips are not looked for.
    // Larger: slow on fans.
    std::int64_t most_corners = 1024;
    // The cosine between the normals of faces of one flat is at least this. It allows for one degree, because files
    // round normals. Larger: flats end early.
    double flat_cosine = 0.99985;
    // A flat region keeps its normal at a vertex if its area is at least this many times the area of every other flat
    // region there. Larger: fewer regions stay flat. At 0 the base of a cone with 24 sides has 1.5 times the error.
    double much_larger = 3.0;
    // At the tip of a cone, the mean normal and the face normals differ by at least this on average, in radians.
    // Larger: blunt tips are rounded.
    double least_turn = 0.05;
    // The cone at a tip is straight if, at the far side of its faces, the vertex normals differ from the face normals
    // by at most this share of the difference at the tip. Larger: bumps count as tips.
    double straight = 0.25;
    // From one face at the tip to the next, the normal turns by at most this share of the whole turn. Larger: corners
    // count as tips.
    double small_step = 0.3;

    // ---- Places

    // About this many places are sampled on a patch, but at most `places_a_face` on each face on average, because a
    // curved face is a cubic. Larger: slower fits, finer details.
    double wanted_places = 3000.0;
    double places_a_face = 250.0;
    // About this many places are sampled on a patch that lies in a plane, besides its vertices. A patch lies in a plane
    // if its faces and their curved surfaces are at most this share of the least tolerance away from it. Larger: slower
    // fits; more patches count as flat.
    double places_in_plane = 100.0;
    double in_plane = 0.1;
    // A cell of a grid contains at most one place. The cell's side is `thinned` spacings, or `thinned_crease` spacings
    // for places on creases.
    double thinned = 0.7;
    double thinned_crease = 0.35;
    // A side of a face is divided into at most this many pieces.
    double most_cuts = 64.0;
    // The radius of the smallest ring of places around the tip of a cone, in diagonals. Larger: rounder tips, fewer
    // centres.
    double tip_ring = 5e-4;
    // Within this many smallest rings of a tip, the error of a sheet may be this many tolerances. Larger: rounder tips,
    // fewer centres.
    double around_tip = 3.0;
    double tip_tolerance = 4.0;

    // The tolerance of places rises with the distance from creases over at most this share of the patch's diagonal.
    // Larger: more centres in small patches.
    double ramp_share = 0.1;

    // ---- Contacts

    // Two faces lie against each other if the cosine of their normals is at most this.
    double most_opposite = -0.95;
};
inline constexpr PatchTuning patch_tuning;

struct WindingTuning {
    // Two places belong to different turns of a patch only if they are closer than this, in diagonals. Larger: wider
    // coils are cut.
    double layers_apart = 0.2;
    // Two places belong to different turns of a patch only if the cosine of their normals is at least this.
    double same_way = 0.3;
    // The path on the patch between places of different turns is at least this many times their distance, and at least
    // this many diagonals long. Larger: fewer patches are cut.
    double way_around = 5.0;
    double least_way = 0.3;
    // A patch is flat if the cosine between each of its normals and the first is at least this. The turns of a flat
    // patch lie above each other: the distance of two places along the normal is at least `along_normal` times their
    // distance.
    double flat = 0.9;
    double along_normal = 0.5;
    // The number of faces that are tested for a winding patch. The patch is cut if at least half of them are beside
    // another turn. Other turns are searched for among `known` faces of the patch.
    std::int64_t probes = 256;
    std::int64_t known = 4096;
    // A patch is cut into at most this many parts. Each part is at most `part_of_turn` turns long.
    double most_parts = 256.0;
    double part_of_turn = 0.5;
};
inline constexpr WindingTuning winding_tuning;

struct CellTuning {
    // ---- The side of the mesh on which a place lies

    // Two faces are folded upon each other if the sum of their normals is shorter than this: the angle between the
    // faces is then less than 23 degrees.
    double folded = 0.4;
    // A face is tested on both sides at this distance from it, in diagonals.
    double off_face = 1e-4;
    // The number of faces that are tested to find whether a mesh with gaps is solid. The mesh is solid if rays agree
    // with the orientation of at least the share `solid_share` of these faces. Larger: fewer meshes are solid.
    std::int64_t probes = 128;
    double solid_share = 0.95;

    // ---- Cells

    // The side of the root cell, in units of the model's reach (PiecesData::reach diagonals). Larger: larger cells.
    double root_side = 1.02;
    // The lowest level of cells with surface, the lowest level of cells without surface, and the highest level of all
    // cells. Larger: more cells, better corners.
    std::int32_t least_level = 4;
    std::int32_t least_plain_level = 3;
    std::int32_t most_level = 9;
    // A cell is split only if there are fewer cells than this. Larger: more memory, fewer poor cells.
    std::int64_t most_cells = 60'000;
    // Signs may be wrong within this distance from the surface, in diagonals. Larger: fewer cells, rougher edges.
    double near = 2e-4;
    // In a cell without surface, a linear function replaces f. Inside the cell it falls by at most this share of its
    // value in the middle.
    double plain_fall = 0.8;

    // ---- Tests of a cell's tree

    // The number of test places along each axis of a cell. Larger: slower, fewer wrong trees.
    std::int64_t along = 5;
    // Signs are tested at these two distances from the surface, in half sides of the cell.
    double beside_step = 0.12;
    double finer_step = 0.03;
    // About this many faces of a cell are tested, in the middle and near the sides.
    std::int64_t faces_looked_at = 24;
};
inline constexpr CellTuning cell_tuning;

struct PiecesTuning {
    // The tolerance of sheets, as a share of the tolerance of the fit. The first constant is for creases, where an
    // error makes a straight line wavy. The second is for places at least `ramp` diagonals from creases. Larger: fewer
    // centres, wavier edges.
    double at_crease = 0.025;
    double far_from_crease = 0.25;
    double ramp = 0.05;
    // Each sheet may have at least this many centres. The whole model may have at least `room_a_sheet` centres for each
    // of its sheets.
    std::int64_t fewest = 8;
    std::int64_t room_a_sheet = 32;
    // The number of places on the mesh that the model keeps, at which searches for its surface begin.
    std::int64_t even_places = 2000;
    // Contacts of parts are searched for at as many places as the mesh has faces, but at least at `fewest_on_parts`
    // places and at most at `most_on_parts`. Larger: fewer contacts are missed.
    std::int64_t fewest_on_parts = 4000;
    std::int64_t most_on_parts = 100000;
    // Parts closer than this touch, in diagonals. Their sheets are moved outward by this distance.
    double contact = 1e-4;
    // The distance between the surface and the mesh is measured at this many places of the surface. They are found with
    // a grid of `cells_a_diagonal` cells along a diagonal. If the mesh has borders, a place counts only if its support
    // by dense samples is within `support_limit`.
    std::int64_t measured_places = 10000;
    double cells_a_diagonal = 72.0;
    double support_limit = 3.0;
    // A patch is unsettled if more than this share of its samples exceeds its tolerance. Larger: fewer patches are
    // divided.
    double settled = 0.02;
    // Unsettled patches are divided along edges that bend by more than these angles, in degrees.
    double smaller_angles[2] = {20.0, 10.0};
    // The conditions for dividing patches. The cells of the new model are made only if the unsettled area falls below
    // `promised` times its former value. The new model is kept if the share of places outside the tolerance, or the
    // farthest distance, falls below `nearer` times its former value, and neither rises above `no_worse` times its
    // former value. Patches with random curvature do not improve.
    double promised = 0.8;
    double nearer = 0.8;
    double no_worse = 1.1;
};
inline constexpr PiecesTuning pieces_tuning;

} // namespace hrbfnpr::mesh
