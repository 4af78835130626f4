// SPDX-License-Identifier: MIT
// Finds which edges of a mesh are sharp according to the normals of its file.
//
// Modelling programs shade edges in this way: along an edge that bends by less than some angle, the two faces share
// normals ("auto smooth", "smoothing groups"). Along any other edge, each face has separate normals.
#pragma once

#include "mesh/plan.h"
#include "picture/shape.h"

namespace hrbfnpr::picture {

// Translates edges of the mesh `of` to edges between other points at the same positions. Edges without such points are
// left out.
[[nodiscard]] Vector<Edge> edges_among(const Points& points, const Vector<Edge>& edges, const Points& of, Pool& pool);

// Returns the meaning of a file's sharp edges for the mesh. `sharp` has the indices of points.
[[nodiscard]] mesh::EdgesInFile said_of_edges(const Points& points, const Vector<Triangle>& triangles,
                                              const Vector<Edge>& sharp, Pool& pool);

} // namespace hrbfnpr::picture
