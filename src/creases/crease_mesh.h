// SPDX-License-Identifier: MIT
// A mesh of an implicit that has sheets, cut where they meet: each triangle stands for one of them, and there are
// vertices on the creases and at their corners.
#pragma once

#include "curves/surface_mesh.h"

#include <array>

namespace hrbfnpr::curves {

// A place of a crease where an edge of the mesh crosses it, or a corner.
struct CreaseNode {
    glm::dvec3 position{0.0};
    bool exact = false; // both sheets are 0 there; else they could not be told apart, or more than two meet
    bool corner = false;
};

// Creases as chains of nodes, from corner to corner, from border to border, or closed.
struct CreaseChains {
    explicit CreaseChains(base::Memory& memory) noexcept
        : first(memory), closed(memory), left(memory), right(memory), node(memory) {}

    base::Array<std::int64_t> first;  // of each chain's nodes, and the end
    base::Array<std::uint8_t> closed; // 1: the last is followed by the first, which stands there once
    base::Array<std::int32_t> left;   // sheet to the left of each chain, as seen from outside
    base::Array<std::int32_t> right;
    base::Array<CreaseNode> node;

    [[nodiscard]] std::int64_t chains() const noexcept { return closed.size(); }
};

struct SharpMesh {
    explicit SharpMesh(base::Memory& memory) noexcept : mesh(memory), sheet(memory), creases(memory) {}

    SurfaceMesh mesh; // a vertex on a crease stands there once for each sheet, with its gradient; nothing is across
    base::Array<std::int32_t> sheet; // of each triangle
    CreaseChains creases;
    std::int64_t unresolved = 0; // nodes that are not exact
};

// The vertices of `mesh` stay the first ones.  Edges whose sheets meet beside them, but off the surface, since
// another one lies between, are halved, some times.  The same bits for any thread count.
[[nodiscard]] SharpMesh split_at_creases(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                         SurfaceMesh mesh, const base::Progress& progress);

} // namespace hrbfnpr::curves
