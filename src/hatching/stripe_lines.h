// SPDX-License-Identifier: MIT
// The crests of waves on a mesh as lines: where the phase is a multiple of 2 pi on its edges, linked across triangles.
#pragma once

#include "hatching/stripe_vertices.h"

namespace hrbfnpr::hatching {

// Polylines, each point on an edge of the mesh.
struct StripeLines {
    explicit StripeLines(base::Memory& memory)
        : first(memory), closed(memory), position(memory), normal(memory), level(memory) {
        first.push_back(0);
    }

    [[nodiscard]] std::int64_t count() const noexcept { return closed.size(); }

    base::Array<std::int64_t> first; // of each line's points, and the end
    base::Array<std::uint8_t> closed;
    geometry::VecArray position;
    geometry::VecArray normal;       // of the surface at each point, unit, about
    base::Array<std::uint8_t> level; // of each point: the coarsest wave that has a crest there
};

// Between crests of the finest wave others are put in: 2^halvings lines for each of its periods.  Levels go on by one
// with each halving.
[[nodiscard]] StripeLines find_stripes(const base::Runtime& runtime, const curves::SurfaceMesh& mesh,
                                       const StripeVertices& vertices, double period, int halvings,
                                       const base::Progress& progress);

} // namespace hrbfnpr::hatching
