// SPDX-License-Identifier: MIT
// The tuning constants of how a mesh is cut into patches, of their sheets, and of the cells that join these. A diagonal
// is that of the mesh's bounds.
#pragma once

#include <cstdint>

namespace hrbfnpr::mesh {

// All values were set on the models of `scripts/bench edges --only=verdict`, and on scans of 17 000 to 80 000 faces.
struct HasCreasesTuning {
    // The reach of the look beside an edge, in heights of the face there. Beyond 1 it meets the edges of the next
    // faces, however quads are cut. Larger: edges beside narrow faces stand out less.
    double reach = 1.5;
    // An edge stands out if it bends by this many times as much as the mesh turns beside it. Larger: fewer do.
    double stands_out = 4.0;
    // Faces beyond an edge that bends by less belong to one polygon, in degrees. Larger: coordinates of fewer digits
    // are enough, and more bent quads are taken for flat ones.
    double flat = 0.2;
    // Edges that bend by more than this are not round, in degrees: a ring of six sides is not meant as a circle. Those
    // of flat polygons stand out. Larger: fewer edges between narrow walls are sharp.
    double surely_sharp = 60.0;
    // Faces that a round surface would leave by more than this are meant to be flat, in diagonals. A ball of 80 faces
    // is off by 0.009, an icosahedron by 0.03. Larger: fewer rocks have edges.
    double far_off = 0.02;
    // Edges of a polyhedron are sharp if something round would leave a face there by more than this, in diagonals.
    // Larger: blunter edges and smaller faces stay smooth.
    double near_enough = 0.002;
    // A look beside an edge ends after this many faces. Larger: fans of very many needles are passed.
    std::int64_t most_faces = 256;
};
inline constexpr HasCreasesTuning has_creases_tuning;

// Creases and the patches between them. Set by scripts/bench edges on its models of parts and machines.
struct CreaseTuning {
    // A crease that ends goes on along edges that bend by at least this, in degrees. Larger: fading creases end sooner.
    double least_bend = 8.0;
    // It goes on only if the cosine of its turn is at least this. Larger: creases stop at turns.
    double aligned = 0.6;
    // A crease that parts nothing is noise if it is shorter than this, in diagonals, or has fewer edges. Larger: fewer
    // short creases.
    double shortest_fading = 0.03;
    std::int64_t fewest_fading = 4;
    // A patch of fewer faces than this, whose area is less than the square of `scrap_size` diagonals, joins the patch
    // beside. Larger: fewer tiny sheets.
    std::int64_t scrap_faces = 10;
    double scrap_size = 0.002;
    // Beyond a smooth cut the sheets of both sides are fitted to the faces within this many diagonals, and within the
    // second share of the distance from the crease. Larger: the sheets agree better at the cut, and have more centres.
    double widest_band = 0.04;
    double band_share = 0.4;
    // A patch ends in a tip between two sides of another one if its angle there is at most this, in radians. Larger:
    // more patches are cut at tips.
    double widest_tip = 1.0;
};
inline constexpr CreaseTuning crease_tuning;

// The fit of one sheet. Set by scripts/bench edges, in which most sheets are planes, parts of cylinders and fillets:
// few centres are enough for them, and each round is short.
struct SheetTuning {
    // The number of even samples that a fit begins with. Larger: planes take longer.
    std::int64_t first_centres = 8;
    std::int32_t most_rounds = 12;
    // A round adds at most this share of the centres, but may add `smallest_batch`. Larger: fewer rounds, and more
    // centres that were not needed.
    double batch = 0.7;
    std::int64_t smallest_batch = 12;
    // Centres are at least this many tolerances apart. Larger: fewer centres along creases, which are less exact.
    double apart = 4.0;
};
inline constexpr SheetTuning sheet_tuning;

// Patches, and the cells that join their sheets. Set by scripts/bench edges --only=pieces, and on CAD files and
// low-poly meshes.
struct PatchTuning {
    // ---- Normals

    // A vertex with more corners has a normal for each patch, and neither flats nor tips. Larger: slow on fans.
    std::int64_t most_corners = 1024;
    // Faces of one flat have normals with at least this cosine, a degree, as files have them. Larger: flats end early.
    double flat_cosine = 0.99985;
    // A flat keeps its normal if its area is this many times that of any other flat at the vertex. Larger: fewer stay
    // flat. At 0 the base of a cone of 24 sides is off by half as much again.
    double much_larger = 3.0;
    // A tip of a cone turns by at least this on average, in radians. Larger: blunt tips are rounded.
    double least_turn = 0.05;
    // At the far side of its faces it turns by at most this share. Larger: bumps are taken for tips.
    double straight = 0.25;
    // From face to face it turns by at most this share of the whole turn. Larger: corners are taken for tips.
    double small_step = 0.3;

    // ---- Places

    // A patch has about this many places. Larger: slower fits, finer details.
    double wanted_places = 3000.0;
    // No two places are in one cell of this many spacings; the second number holds along creases.
    double thinned = 0.7;
    double thinned_crease = 0.35;
    // A side is cut into at most this many pieces.
    double most_cuts = 64.0;
    // Within this many spacings of a tip a sheet may be off by this many tolerances. Larger: rounder tips, fewer
    // centres.
    double around_tip = 3.0;
    double tip_tolerance = 4.0;

    // ---- Contacts

    // Faces that lie against each other have normals with at most this cosine.
    double most_opposite = -0.95;
};
inline constexpr PatchTuning patch_tuning;

struct WindingTuning {
    // Two places are of two turns if they are this near to each other, in diagonals. Larger: wider coils are cut.
    double layers_apart = 0.2;
    // Their normals have at least this cosine.
    double same_way = 0.3;
    // They are this many times as far apart on the patch, and at least this many diagonals. Larger: fewer are cut.
    double way_around = 5.0;
    double least_way = 0.3;
    // All normals of a flat patch have at least this cosine with each other. Its turns lie above each other: this share
    // of their distance is along the normal.
    double flat = 0.9;
    double along_normal = 0.5;
    // This many faces of a patch are looked at, and it is cut if half of them are of turns. Others are looked for among
    // the second number of faces.
    std::int64_t probes = 256;
    std::int64_t known = 4096;
    // A patch is cut into at most this many parts, each at most this share of a turn long.
    double most_parts = 256.0;
    double part_of_turn = 0.5;
};
inline constexpr WindingTuning winding_tuning;

struct CellTuning {
    // ---- The side of the mesh that a place lies on

    // Two faces are folded upon each other if the sum of their normals is shorter than this: less than 23 degrees.
    double folded = 0.4;
    // The side of a face is asked at this distance from it, in diagonals.
    double off_face = 1e-4;
    // A mesh with gaps is solid if rays agree with at least this share of this many faces. Larger: fewer are solid.
    std::int64_t probes = 128;
    double solid_share = 0.95;

    // ---- Cells

    // The root cell has this many sides of the reach of a model, PiecesData::reach diagonals. Larger: larger cells.
    double root_side = 1.02;
    // The least levels of cells with surface and without, and the largest of all. Larger: more cells, better corners.
    std::int32_t least_level = 4;
    std::int32_t least_plain_level = 3;
    std::int32_t most_level = 9;
    // Beyond this many cells none is split. Larger: more memory, fewer poor cells.
    std::int64_t most_cells = 60'000;
    // Within this distance from the surface signs may be wrong, in diagonals. Larger: fewer cells, rougher edges.
    double near = 2e-4;
    // The function of a cell without surface falls by at most this share of its value in the cell.
    double plain_fall = 0.8;

    // ---- Tests of a cell's tree

    // Places in a cell, along each axis. Larger: slower, fewer wrong trees.
    std::int64_t along = 5;
    // Signs are asked for this far off the surface, in half sides of the cell: first the one, then the other.
    double beside_step = 0.12;
    double finer_step = 0.03;
    // About this many faces are looked at in their middles and at their sides.
    std::int64_t faces_looked_at = 24;
};
inline constexpr CellTuning cell_tuning;

struct PiecesTuning {
    // Sheets are held to this share of the fit's tolerance at creases, where an error shows as a wave in a straight
    // line, and to the second from `ramp` diagonals off them. Larger: fewer centres, wavier edges.
    double at_crease = 0.025;
    double far_from_crease = 0.25;
    double ramp = 0.05;
    // Each sheet may have this many centres, and the model the second number for each sheet.
    std::int64_t fewest = 8;
    std::int64_t room_a_sheet = 32;
    // The model keeps this many places all over the mesh, at which searches for its surface begin.
    std::int64_t even_places = 2000;
    // Contacts of parts are looked for at a place a face, within these bounds. Larger: fewer are missed.
    std::int64_t fewest_on_parts = 4000;
    std::int64_t most_on_parts = 100000;
    // Parts that are this near to each other touch, and grow by as much, in diagonals.
    double contact = 1e-4;
    // The surface is measured at this many places, in this many cells a diagonal, and counts as far as dense samples
    // bear it out.
    std::int64_t measured_places = 10000;
    double cells_a_diagonal = 72.0;
    double support_limit = 3.0;
    // A patch is unsettled if more than this share of its samples is outside their tolerance. Larger: fewer are parted.
    double settled = 0.02;
    // Unsettled patches are parted along edges that bend by more than these angles, in degrees.
    double smaller_angles[2] = {20.0, 10.0};
    // Parting is kept if it leaves at most this share of what is outside, before all is made, and if the whole is
    // nearer by the second share and nothing is worse by the third. What is curved at random does not become better by
    // it.
    double promised = 0.8;
    double nearer = 0.8;
    double no_worse = 1.1;
};
inline constexpr PiecesTuning pieces_tuning;

} // namespace hrbfnpr::mesh
