// SPDX-License-Identifier: MIT
// Where a mesh is to be sharp, and the smooth patches between.
#pragma once

#include "mesh/edges.h"
#include "mesh/plan.h"

namespace hrbfnpr::mesh {

// An edge that two patches meet in, or, where a crease fades, one patch with itself.
struct Crease {
    std::int32_t from, to;    // vertices
    std::int32_t left, right; // faces: `left` runs through the edge from `from` to `to`
};

struct Creases {
    explicit Creases(base::Memory& memory) noexcept : patch(memory), edge(memory), cut(memory), shared(memory) {}

    base::Array<std::int32_t> patch; // of each face, from 0 in the order of their first faces
    std::int32_t patches = 0;
    base::Array<Crease> edge;
    // Of each side of the faces (3 face + k): 1 if beyond it is a crease or nothing; 2 if another patch, smoothly.
    base::Array<std::uint8_t> cut;
    // Faces that are near to a smooth cut, and the patch beyond it.
    struct Shared {
        std::int32_t face, patch;
    };
    base::Array<Shared> shared;
    double length = 0.0; // of all creases
    double fading = 0.0; // of those that one patch meets itself in, though it was cut
};

// Creases that end nowhere are grown along edges that go on as they do; short pieces that part nothing are none.
[[nodiscard]] Creases find_creases(const base::Work& work, const Mesh& mesh, const Sharpness& sharpness);
// By what each component is said to be. Creases begin with those sides of the faces, 3 face + k, that are not 0 in
// `sides`, if they bend by more than the angle.
[[nodiscard]] Creases find_creases(const base::Work& work, const Mesh& mesh, const base::Array<Sharpness>& of_component,
                                   const base::Array<std::uint8_t>& sides);
// Those, and what bends by more than an angle in some of the patches between them: patch by patch, whether.
[[nodiscard]] Creases find_more_creases(const base::Work& work, const Mesh& mesh, const Creases& known,
                                        const base::Array<std::uint8_t>& within, double angle);

} // namespace hrbfnpr::mesh
