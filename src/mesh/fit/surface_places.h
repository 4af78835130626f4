// SPDX-License-Identifier: MIT
// Places on the surface of an implicit, even over its area.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"
#include "surface/support.h"

#include <cstdint>

namespace hrbfnpr::curves {
struct SurfaceMesh;
}

namespace hrbfnpr::mesh {

struct SurfaceSearch {
    geometry::Bounds region; // that the surface is looked for in
    double side = 0.0;       // of cells
    bool finer = false;      // with cells half as wide, and again, where the surface is thinner than they are
    double precision = 1e-9; // of its vertices, in diagonals
    std::int64_t count = 0;  // of places
    std::uint64_t seed = 1;
    // Not null: places that it does not bear out up to the limit are left out.
    const surface::Support* support = nullptr;
    double limit = 0.0;
};

struct SurfacePlaces {
    explicit SurfacePlaces(base::Memory& memory) noexcept : position(memory), gradient(memory) {}

    geometry::VecArray position;
    geometry::VecArray gradient; // of f
    std::int64_t found = 0;      // places, before some were left out
};

struct SurfaceParts {
    std::int64_t components = 0;
    std::int64_t genus = -1; // sum over the components; -1: there is a border
};

[[nodiscard]] SurfaceParts parts_of(const base::Runtime& runtime, const curves::SurfaceMesh& surface);

// The surface that seeds are near to, or places of a coarse lattice lead to, as triangles.
[[nodiscard]] curves::SurfaceMesh find_surface(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                               const geometry::VecArray& seeds, const SurfaceSearch& search,
                                               const base::Progress& progress);

[[nodiscard]] SurfacePlaces places_on(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                      const curves::SurfaceMesh& surface, const SurfaceSearch& search,
                                      const base::Progress& progress);

// Drops places beyond the support's limit, if there is a support.
void leave_out(const base::Runtime& runtime, const SurfaceSearch& search, SurfacePlaces& places,
               const base::Progress& progress);

} // namespace hrbfnpr::mesh
