// SPDX-License-Identifier: MIT
// Finds the creases of a mesh, and the smooth patches between them.
#pragma once

#include "mesh/edges.h"
#include "mesh/plan.h"

namespace hrbfnpr::mesh {

// A sharp edge between two patches. Where a crease fades, both sides belong to one patch.
struct Crease {
    std::int32_t from, to;    // the vertices at its ends
    std::int32_t left, right; // The two faces. `left` runs through the edge from `from` to `to`.
};

struct Creases {
    explicit Creases(base::Memory& memory) noexcept : patch(memory), edge(memory), cut(memory), shared(memory) {}

    // For each face: the index of its patch. Patches are numbered in the order of their first faces.
    base::Array<std::int32_t> patch;
    std::int32_t patches = 0;
    base::Array<Crease> edge;
    // For each side 3 face + k: 1 if there is a crease or no other face, 2 if another patch continues smoothly there (a
    // smooth cut), else 0.
    base::Array<std::uint8_t> cut;
    // A face near a smooth cut, and the patch beyond the cut.
    struct Shared {
        std::int32_t face, patch;
    };
    base::Array<Shared> shared;
    double length = 0.0; // the total length of all creases
    // The total length of the creases that have the same patch on both sides, even after smooth cuts.
    double fading = 0.0;
};

// Finds the creases of a mesh. Creases with a free end are extended along edges that continue in their direction. Short
// creases that separate nothing are dropped.
[[nodiscard]] Creases find_creases(const base::Work& work, const Mesh& mesh, const Sharpness& sharpness);
// Finds creases with separate limits for each component. A side 3 face + k can begin a crease only if its entry in
// `sides` is not 0 and it bends by more than the angle.
[[nodiscard]] Creases find_creases(const base::Work& work, const Mesh& mesh, const base::Array<Sharpness>& of_component,
                                   const base::Array<std::uint8_t>& sides);
// Returns the known creases, and also edges that bend by more than an angle inside patches whose entry in `within` is
// not 0.
[[nodiscard]] Creases find_more_creases(const base::Work& work, const Mesh& mesh, const Creases& known,
                                        const base::Array<std::uint8_t>& within, double angle);
// Returns the crumbs of each component.
[[nodiscard]] base::Array<Crumbs> find_crumbs(const base::Work& work, const Mesh& mesh, const Creases& creases);
// Returns the area of each component.
[[nodiscard]] base::Array<double> areas_of_components(const base::Work& work, const Mesh& mesh);

} // namespace hrbfnpr::mesh
