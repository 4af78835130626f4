// SPDX-License-Identifier: MIT
// The tuning constants of cutting a mesh into patches, of their sheets, and of the cells that join the sheets. A
// diagonal is the diagonal of the mesh's bounds.
#pragma once

#include <cstdint>

namespace hrbfnpr::mesh {

// All values were set on the models of `scripts/bench edges --only=verdict`, and on scans of 17 000 to 80 000 faces.
struct HasCreasesTuning {
    // How far beside an edge the mesh is examined, in heights of the face there. Beyond 1 this reaches the edges of the
    // next faces, however quads are cut. Larger: edges beside narrow faces stand out less.
    double reach = 1.5;
    // An edge stands out if it bends by this many times the angle by which the mesh turns beside it. Larger: fewer
    // edges stand out.
    double stands_out = 4.0;
    // Two faces belong to one flat polygon if the edge between them bends by less than this, in degrees. Larger:
    // coordinates of fewer digits are enough, and more bent quads are taken for flat ones.
    double flat = 0.2;
    // Edges that bend by more than this many degrees are not round: a ring of six sides does not approximate a circle.
    // Such edges stand out if they bound a flat polygon. Larger: fewer edges between narrow walls are sharp.
    double surely_sharp = 60.0;
    // Faces farther than this from a round surface are flat, in diagonals. A ball of 80 faces is off by 0.009, an
    // icosahedron by 0.03. Larger: fewer rocks have edges.
    double far_off = 0.02;
    // An edge of a polyhedron is sharp if one of its faces is farther than this from a round surface, in diagonals.
    // Larger: blunter edges and smaller faces stay smooth.
    double near_enough = 0.002;
    // The walk beside an edge ends after this many faces. Larger: fans of very many needles are passed.
    std::int64_t most_faces = 256;
};
inline constexpr HasCreasesTuning has_creases_tuning;

// The constants of creases and of the patches between them. Set by scripts/bench edges on its models of parts and
// machines.
struct CreaseTuning {
    // A crease that ends is extended along edges that bend by at least this, in degrees. Larger: fading creases end
    // sooner.
    double least_bend = 8.0;
    // A crease that ends is extended only if the cosine of its turn is at least this. Larger: creases stop at turns.
    double aligned = 0.6;
    // A crease that separates no patches is noise if it is shorter than this, in diagonals, or has fewer edges. Larger:
    // fewer short creases.
    double shortest_fading = 0.03;
    std::int64_t fewest_fading = 4;
    // A patch of fewer faces than this, whose area is less than the square of `scrap_size` diagonals, joins a
    // neighbouring patch. Larger: fewer tiny sheets.
    std::int64_t scrap_faces = 10;
    double scrap_size = 0.002;
    // Each sheet at a smooth cut is also fitted to the faces beyond the cut, within this many diagonals and within the
    // second share of the distance from the crease. Larger: the sheets agree better at the cut, and have more centres.
    double widest_band = 0.04;
    double band_share = 0.4;
    // A patch ends in a tip between two sides of another patch if its angle there is at most this, in radians. Larger:
    // more patches are cut at tips.
    double widest_tip = 1.0;
};
inline constexpr CreaseTuning crease_tuning;

// The constants of the fit of one sheet. Set by scripts/bench edges, in which most sheets are planes, parts of
// cylinders and fillets: few centres are enough for them, and each round is short.
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

// The constants of patches, their normals and their samples. Set by scripts/bench edges --only=pieces, and on CAD files
// and low-poly meshes.
struct PatchTuning {
    // ---- Normals

    // A vertex with more corners than this has one normal for each patch, and no flats or tips are looked for there.
    // Larger: slow on fans.
    std::int64_t most_corners = 1024;
    // The normals of the faces of one flat have at least this cosine: one degree, because files round normals. Larger:
    // flats end early.
    double flat_cosine = 0.99985;
    // A flat keeps its normal if its area is this many times that of any other flat at the vertex. Larger: fewer stay
    // flat. At 0 the base of a cone of 24 sides is off by half as much again.
    double much_larger = 3.0;
    // At the tip of a cone the mean normal differs from the face normals by at least this on average, in radians.
    // Larger: blunt tips are rounded.
    double least_turn = 0.05;
    // A tip is straight if the normals at the far side of its faces differ by at most this share of the difference at
    // the tip. Larger: bumps are taken for tips.
    double straight = 0.25;
    // From one face at the tip to the next the normal turns by at most this share of the whole turn. Larger: corners
    // are taken for tips.
    double small_step = 0.3;

    // ---- Places

    // A patch has about this many places. Larger: slower fits, finer details.
    double wanted_places = 3000.0;
    // No two places are in one grid cell, whose side is this many spacings. The second number holds along creases.
    double thinned = 0.7;
    double thinned_crease = 0.35;
    // A side of a face is cut into at most this many pieces.
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
    // Two places belong to different turns of a patch if they are closer to each other than this, in diagonals. Larger:
    // wider coils are cut.
    double layers_apart = 0.2;
    // The normals of two such places have at least this cosine.
    double same_way = 0.3;
    // The way between them on the patch is at least this many times their distance, and at least this many diagonals.
    // Larger: fewer patches are cut.
    double way_around = 5.0;
    double least_way = 0.3;
    // A patch is flat if all its normals have at least this cosine with the first. The turns of a flat patch lie above
    // each other: at least the second share of their distance is along the normal.
    double flat = 0.9;
    double along_normal = 0.5;
    // To find whether a patch winds around beside itself, this many of its faces are probed. The patch is cut if at
    // least half of them lie beside another turn. That turn is looked for among the second number of faces.
    std::int64_t probes = 256;
    std::int64_t known = 4096;
    // A patch is cut into at most this many parts, each at most this share of a turn long.
    double most_parts = 256.0;
    double part_of_turn = 0.5;
};
inline constexpr WindingTuning winding_tuning;

struct CellTuning {
    // ---- The side of the mesh that a place lies on

    // Two faces are folded upon each other if the sum of their normals is shorter than this: the angle between the
    // faces is then less than 23 degrees.
    double folded = 0.4;
    // The two sides of a face are tested at this distance from it, in diagonals.
    double off_face = 1e-4;
    // To find whether a mesh with gaps is solid, this many of its faces are probed. It is solid if rays agree with the
    // orientation of at least the second share of them. Larger: fewer meshes are solid.
    std::int64_t probes = 128;
    double solid_share = 0.95;

    // ---- Cells

    // The side of the root cell, in reaches of the model (SheetTreeData::reach diagonals). Larger: larger cells.
    double root_side = 1.02;
    // The least level of cells with surface, the least level of cells without, and the largest level of all. Larger:
    // more cells, better corners.
    std::int32_t least_level = 4;
    std::int32_t least_plain_level = 3;
    std::int32_t most_level = 9;
    // Cells are split only while there are fewer than this. Larger: more memory, fewer poor cells.
    std::int64_t most_cells = 60'000;
    // Within this distance from the surface signs may be wrong, in diagonals. Larger: fewer cells, rougher edges.
    double near = 2e-4;
    // In a cell without surface, a linear function replaces f. It falls by at most this share of its value within the
    // cell.
    double plain_fall = 0.8;

    // ---- Tests of a cell's tree

    // The number of test places along each axis of a cell. Larger: slower, fewer wrong trees.
    std::int64_t along = 5;
    // Signs are tested at these two distances from the surface, in half sides of the cell.
    double beside_step = 0.12;
    double finer_step = 0.03;
    // About this many faces of a cell are tested, in their middles and near their sides.
    std::int64_t faces_looked_at = 24;
};
inline constexpr CellTuning cell_tuning;

struct PiecesTuning {
    // The tolerance of sheets, as a share of the fit's tolerance: at creases, where an error shows as a wave in a
    // straight line, and from `ramp` diagonals off creases on. Larger: fewer centres, wavier edges.
    double at_crease = 0.025;
    double far_from_crease = 0.25;
    double ramp = 0.05;
    // Each sheet may have at least this many centres, and the model at least the second number times its sheets.
    std::int64_t fewest = 8;
    std::int64_t room_a_sheet = 32;
    // The model keeps this many places all over the mesh, at which searches for its surface begin.
    std::int64_t even_places = 2000;
    // Contacts of parts are searched for at as many places as the mesh has faces, within these bounds. Larger: fewer
    // contacts are missed.
    std::int64_t fewest_on_parts = 4000;
    std::int64_t most_on_parts = 100000;
    // Parts closer to each other than this touch, and grow by this much, in diagonals.
    double contact = 1e-4;
    // The surface is measured at this many places, in this many cells along a diagonal. On a mesh with borders it
    // counts where its support by dense samples is within the limit.
    std::int64_t measured_places = 10000;
    double cells_a_diagonal = 72.0;
    double support_limit = 3.0;
    // A patch is unsettled if more than this share of its samples is outside their tolerance. Larger: fewer are
    // divided.
    double settled = 0.02;
    // Unsettled patches are divided along edges that bend by more than these angles, in degrees.
    double smaller_angles[2] = {20.0, 10.0};
    // The cells of a division are made only if it reduces the unsettled area below the first share. It is kept if it
    // also reduces the share outside the tolerance or the farthest distance below the second share, and raises neither
    // above the third. Patches that are curved at random do not improve.
    double promised = 0.8;
    double nearer = 0.8;
    double no_worse = 1.1;
};
inline constexpr PiecesTuning pieces_tuning;

} // namespace hrbfnpr::mesh
