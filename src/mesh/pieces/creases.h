// SPDX-License-Identifier: MIT
// Finds the creases of a mesh, where its surface is sharp, and the smooth patches between them.
#pragma once

#include "mesh/edges.h"
#include "mesh/plan.h"

namespace hrbfnpr::mesh {

// An edge between two patches or, where a crease fades, between two places of one patch.
struct Crease {
    std::int32_t from, to;    // vertices
    std::int32_t left, right; // faces: `left` runs through the edge from `from` to `to`
};

struct Creases {
    explicit Creases(base::Memory& memory) noexcept : patch(memory), edge(memory), cut(memory), shared(memory) {}

    base::Array<std::int32_t> patch; // for each face, numbered from 0 in the order of their first faces
    std::int32_t patches = 0;
    base::Array<Crease> edge;
    // For each side of the faces, 3 face + k: 1 if a crease or no face lies beyond it, 2 if another patch joins
    // smoothly there, else 0.
    base::Array<std::uint8_t> cut;
    // A face near a smooth cut, and the patch beyond the cut.
    struct Shared {
        std::int32_t face, patch;
    };
    base::Array<Shared> shared;
    double length = 0.0; // the length of all creases
    double fading = 0.0; // the length of creases with one patch on both sides, even after cutting
};

// Finds the creases of a mesh. Creases that end freely are extended along edges that continue in their direction. Short
// pieces that separate nothing are dropped.
[[nodiscard]] Creases find_creases(const base::Work& work, const Mesh& mesh, const Sharpness& sharpness);
// Finds creases as above, with limits for each component. Creases begin only at sides of the faces, 3 face + k, whose
// entry in `sides` is not 0, if they bend by more than the angle.
[[nodiscard]] Creases find_creases(const base::Work& work, const Mesh& mesh, const base::Array<Sharpness>& of_component,
                                   const base::Array<std::uint8_t>& sides);
// Returns the known creases, and the edges that bend by more than an angle within those patches whose entry in `within`
// is not 0.
[[nodiscard]] Creases find_more_creases(const base::Work& work, const Mesh& mesh, const Creases& known,
                                        const base::Array<std::uint8_t>& within, double angle);

} // namespace hrbfnpr::mesh
