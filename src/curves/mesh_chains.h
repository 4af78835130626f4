// SPDX-License-Identifier: MIT
// Where a function that is known at the vertices of a mesh changes its sign: chains of edges that are crossed.
#pragma once

#include "base/memory.h"
#include "base/runtime.h"
#include "curves/surface_mesh.h"

#include <cstdint>

namespace hrbfnpr::curves {

// A place on an edge of the mesh: a + share (b - a), where g < 0 at vertex a and g >= 0 at b.
struct Crossing {
    std::int32_t negative, positive; // vertices
    double share;                    // by linear interpolation, in [0, 1]

    [[nodiscard]] glm::dvec3 place(const SurfaceMesh& mesh) const noexcept {
        const glm::dvec3 a = mesh.position[negative];
        return a + share * (mesh.position[positive] - a);
    }
};

// Along a chain what is negative lies to the left, as seen from outside: the direction of grad f x grad g.
struct MeshChains {
    explicit MeshChains(base::Memory& memory) noexcept : first(memory), closed(memory), crossing(memory) {}

    base::Array<std::int64_t> first;  // of each chain, and the end of the last: one more than chains
    base::Array<std::uint8_t> closed; // 1: the last crossing is followed by the first, which stands there once
    base::Array<Crossing> crossing;

    [[nodiscard]] std::int64_t chains() const noexcept { return closed.size(); }
};

// One value for each vertex; 0 counts as positive.  The same bits for any thread count.
[[nodiscard]] MeshChains find_chains(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                     const base::Array<double>& level);

} // namespace hrbfnpr::curves
