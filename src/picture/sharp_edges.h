// SPDX-License-Identifier: MIT
// Which edges of a mesh are meant to be sharp by the normals of its file.
//
// Programs that make models shade them so: faces share normals along edges that bend by up to some angle ("auto
// smooth", "smoothing groups"), and have their own along others.
#pragma once

#include "picture/shape.h"

namespace hrbfnpr::picture {

// What the normals of a file say of the edges that bend at all.
enum class SaidOfEdges {
    nothing, // or that all are smooth, which normals are as well that a program made up
    some_are_sharp,
    all_are_sharp,
};

// Names the edges by the numbers of other points at the same places.  Edges without such points are left out.
// of: the points that the edges are named by.
[[nodiscard]] Vector<Edge> edges_among(const Points& points, const Vector<Edge>& edges, const Points& of, Pool& pool);

// sharp: numbers of the points.
[[nodiscard]] SaidOfEdges said_of_edges(const Points& points, const Vector<Triangle>& triangles,
                                        const Vector<Edge>& sharp, Pool& pool);

} // namespace hrbfnpr::picture
