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
    // The least share of the edges beyond the angle that stands out on a shape with edges, by length. Larger: more
    // meshes are smooth.
    double enough = 0.5;
    // The least length of the edges beyond the angle, in diagonals. Larger: shapes with a short edge are smooth.
    double shortest = 0.05;
    // Faces that a round surface would leave by more than this are meant to be flat, in diagonals. A ball of 80 faces
    // is off by 0.009, an icosahedron by 0.03. Larger: fewer rocks have edges.
    double far_off = 0.02;
    // Edges of a polyhedron are sharp if something round would leave a face there by more than this, in diagonals.
    // Larger: blunter edges and smaller faces stay smooth.
    double near_enough = 0.002;
    // The least share of edges between faces that are far off, of a shape whose faces are all meant to be flat, by
    // length. Larger: fewer rocks have edges.
    double enough_far_off = 0.25;
    // The least share of the area that is of components with creases, if the whole has. It keeps crumbs of a scan from
    // giving it edges. Larger: smooth figures on blocks need larger blocks.
    double enough_area = 0.1;
    // A look beside an edge ends after this many faces. Larger: fans of very many needles are passed.
    std::int64_t most_faces = 256;
};
inline constexpr HasCreasesTuning has_creases_tuning;

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
