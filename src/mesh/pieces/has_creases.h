// SPDX-License-Identifier: MIT
// Whether a mesh stands for a shape with edges.
#pragma once

#include "mesh/edges.h"

namespace hrbfnpr::mesh {

struct CreaseEvidence {
    double length = 0.0; // of the edges that bend by more than the angle, in diagonals
    double clear = 0.0;  // share of them beside which, on one side at least, the mesh bends six times less
    double coarse = 0.0; // ... beside which, on both sides, faces would be far off what is round there
    double ratio = 0.0;  // their length, to that of the edges that bend by half the angle at least
    double even = 0.0;   // share of all edges that hardly bend, to those that bend most
    bool creases = false;
    bool polyhedron = false; // it has them as its faces are coarse: all are meant to be flat
};

// Noise and coarse faces bend by any angle, more often less, and beside a bend there is another; edges stand out.  So
// do those of a polyhedron of a few faces: nobody means something round by them.  And where many faces are flat, or
// round in one direction only, the mesh was constructed: edges of such meshes are meant, also beside narrow fillets and
// chamfers.  angle: degrees.
[[nodiscard]] CreaseEvidence look_for_creases(const base::Runtime& runtime, const Mesh& mesh, double angle,
                                              const base::Progress& progress);

// Of each component by itself, in its own diagonals.
[[nodiscard]] base::Array<CreaseEvidence> look_for_creases_of_parts(const base::Runtime& runtime, const Mesh& mesh,
                                                                    double angle, const base::Progress& progress);

} // namespace hrbfnpr::mesh
