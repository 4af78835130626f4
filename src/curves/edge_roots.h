// SPDX-License-Identifier: MIT
// Where the surface meets edges at whose ends f has different signs.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::curves {

// Corners of cells, f there, and the edges between two of them.
struct CrossedEdges {
    struct Edge {
        std::int32_t from, to;
    };

    const geometry::VecArray& position;
    const base::Array<double>& value;
    const base::Array<Edge>& edge;
};

// A root on each edge: |f| / |grad f| <= tolerance there, for all but as many edges as returned, where position is as
// near as the steps came, and gradient may be zero.  position and gradient: resized.
std::int64_t find_edge_roots(const base::Runtime& runtime, const implicit::Implicit& implicit,
                             const CrossedEdges& edges, double tolerance, geometry::VecArray& position,
                             geometry::VecArray& gradient, const base::Progress& progress);

} // namespace hrbfnpr::curves
