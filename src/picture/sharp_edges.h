// SPDX-License-Identifier: MIT
// Finds which edges of a mesh are sharp according to the normals of its file.
//
// Modelling programs shade edges this way: faces share normals along edges that bend by up to some angle ("auto
// smooth", "smoothing groups"), and have their own normals along other edges.
#pragma once

#include "mesh/plan.h"
#include "picture/shape.h"

namespace hrbfnpr::picture {

// Renames edges by the numbers of other points at the same places. Edges without such points are left out. The numbers
// of `edges` refer to `of`.
[[nodiscard]] Vector<Edge> edges_among(const Points& points, const Vector<Edge>& edges, const Points& of, Pool& pool);

// Interprets the sharp edges of a file. `sharp` has numbers of the points.
[[nodiscard]] mesh::EdgesInFile said_of_edges(const Points& points, const Vector<Triangle>& triangles,
                                              const Vector<Edge>& sharp, Pool& pool);

} // namespace hrbfnpr::picture
