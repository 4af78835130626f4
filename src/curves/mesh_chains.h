// SPDX-License-Identifier: MIT
// Chains of mesh edges that lines cross, from triangle to triangle; and those where a function that is known at the
// vertices changes its sign.
#pragma once

#include "base/runtime.h"
#include "curves/chains.h"
#include "curves/clip_mesh.h"

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

// Along a chain negative g lies to the left, as seen from outside: the direction of grad f x grad g.
struct MeshChains {
    explicit MeshChains(base::Memory& memory) noexcept : first(memory), closed(memory), crossing(memory) {}

    base::Array<std::int64_t> first;  // the first crossing of each chain, and the number of crossings
    base::Array<std::uint8_t> closed; // 1: the last crossing is followed by the first, which stands there once
    base::Array<Crossing> crossing;

    [[nodiscard]] std::int64_t chains() const noexcept { return closed.size(); }
};

// One value for each vertex; 0 counts as positive. The same bits for any thread count.
[[nodiscard]] MeshChains find_chains(const base::Runtime& runtime, const SurfaceMesh& mesh,
                                     const base::Array<double>& level);

// Walks along the lines that cross triangles. crossed: two edges of each triangle as bits 1, 2, 4, or 0; it is 0
// afterwards. may_enter(edge) tells whether a walk may come into the triangle of an edge over it. Open chains are the
// edge that the first triangle is entered by and those that each is left by; closed ones only the latter.
template <class MayEnter>
[[nodiscard]] Chains<std::int64_t> walk_chains(const SurfaceMesh& mesh, base::Array<std::uint8_t>& crossed,
                                               MayEnter&& may_enter) {
    HRBFNPR_ASSERT(crossed.size() == mesh.triangles());
    Chains<std::int64_t> chains(crossed.memory());
    base::Array<std::int32_t> found(crossed.memory()); // the triangles that are crossed
    for (std::int64_t t = 0; t < crossed.size(); ++t)
        if (crossed[t] != 0) found.push_back(static_cast<std::int32_t>(t));
    const auto has = [&](std::int64_t edge) { return ((crossed[edge / 3] >> (edge % 3)) & 1) != 0; };
    const auto walk = [&](std::int64_t edge) {
        while (edge >= 0 && crossed[edge / 3] != 0) {
            std::int64_t exit = next_in_triangle(edge);
            if (!has(exit)) exit = next_in_triangle(exit);
            HRBFNPR_ASSERT(exit != edge && has(exit));
            crossed[edge / 3] = 0;
            chains.point.push_back(exit);
            edge = opposite_of(mesh, exit);
        }
    };
    for (const bool closed : {false, true})
        for (const std::int32_t t : found)
            for (std::int64_t edge = 3 * t; edge < 3 * t + 3; ++edge) {
                if (!has(edge) || !may_enter(edge)) continue;
                const std::int64_t before = mesh.neighbour[edge];
                if (!closed && before >= 0 && crossed[before] != 0) continue;
                if (!closed) chains.point.push_back(edge);
                walk(edge);
                chains.end(closed);
            }
    return chains;
}

} // namespace hrbfnpr::curves
