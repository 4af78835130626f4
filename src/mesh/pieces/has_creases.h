// SPDX-License-Identifier: MIT
// Measures whether a mesh approximates a shape with edges. plan.h judges the result.
//
// Any mesh bends at its edges. A mesh of a smooth surface turns beside an edge about as much as at the edge, however
// finely it is divided. At an edge of the shape, however, the mesh turns little beside the edge, and the edge goes on
// at both ends. The mesh is examined beside an edge up to 1.5 times the height of the face there, so the result does
// not depend on how quads are cut into triangles. Two more kinds of faces show that the shape has edges: flat polygons,
// because meshes of smooth surfaces have bent quads instead, and faces too coarse for a round surface.
#pragma once

#include "mesh/edges.h"
#include "mesh/plan.h"

namespace hrbfnpr::mesh {

struct CreaseEvidenceOfParts {
    base::Array<CreaseEvidence> part; // the evidence of each component, in diagonals of the component
    // For each side 3 face + k: 1 if the mesh bends there by more than the angle, else 0. It is also 0 on fillets and
    // other round walls, where the mesh continues to turn in the same sense on both sides of the edge. On a polyhedron
    // it is 1 if a face at the side is too coarse to be round.
    base::Array<std::uint8_t> sharp;
    CreaseEvidence whole; // Evidence for the whole mesh. It has creases if parts with creases have enough of its area.
};

// Looks for creases among edges that bend by more than an angle, in degrees. Each component is judged separately, so
// that a smooth statue on a block with edges stays smooth.
[[nodiscard]] CreaseEvidenceOfParts look_for_creases_of_parts(const base::Work& work, const Mesh& mesh, double angle);

// Returns the evidence for the whole mesh.
[[nodiscard]] CreaseEvidence look_for_creases(const base::Work& work, const Mesh& mesh, double angle);

} // namespace hrbfnpr::mesh
