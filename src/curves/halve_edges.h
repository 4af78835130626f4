// SPDX-License-Identifier: MIT
// Makes a mesh of a surface finer along some of its edges.
#pragma once

#include "base/operation.h"
#include "curves/clip_mesh.h"

namespace hrbfnpr::curves {

// Halves edges, each told by one of its two sides: brings their middles onto the surface, and cuts the triangles there.
// An edge stays whole if its middle has no place on the surface within `farthest` of its length, or, where the surface
// is smooth, one whose gradient turns away from those at its ends, as across a thin wall. Returns whether any was
// halved.
bool halve_edges(const base::Runtime& runtime, const implicit::Implicit& implicit,
                 const base::Array<std::int64_t>& edges, double farthest, bool smooth, SurfaceMesh& mesh,
                 const base::Progress& progress);

} // namespace hrbfnpr::curves
