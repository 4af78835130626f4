// SPDX-License-Identifier: MIT
// Tuning of how a mesh is cut into patches.
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

} // namespace hrbfnpr::mesh
