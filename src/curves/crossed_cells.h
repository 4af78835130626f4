// SPDX-License-Identifier: MIT
// The cells of a lattice that the surface passes through, by the signs of f at their corners: found by flood from
// seeds.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "curves/kuhn_tetrahedra.h"
#include "curves/lattice.h"
#include "curves/surface_mesh.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

#include <array>

namespace hrbfnpr::curves {

struct CrossedCell {
    std::uint64_t code; // geometry/morton.h
    std::array<std::int32_t, 8> corner;
};

struct CrossedCells {
    CrossedCells(base::Memory& memory, const Lattice& cut) noexcept
        : lattice(cut), cell(memory), place(memory), position(memory), value(memory) {}

    Lattice lattice;
    base::Array<CrossedCell> cell;    // along a space-filling curve
    base::Array<std::uint64_t> place; // of the corners: packed
    geometry::VecArray position;
    base::Array<double> value; // f
    std::int64_t triangles = 0;

    [[nodiscard]] bool negative(std::int32_t corner) const noexcept { return value[corner] < 0.0; }
    [[nodiscard]] unsigned negative_corners(const CrossedCell& of) const noexcept {
        unsigned set = 0;
        for (unsigned k = 0; k < 8; ++k) set |= (negative(of.corner[k]) ? 1U : 0U) << k;
        return set;
    }
    // Where f is a number.
    [[nodiscard]] unsigned known_corners(const CrossedCell& of) const noexcept {
        unsigned set = 0;
        for (unsigned k = 0; k < 8; ++k) set |= (std::isfinite(value[of.corner[k]]) ? 1U : 0U) << k;
        return set;
    }
    // visit(tetrahedron, section) for those that the surface passes through.
    template <class Visit>
    void sections_of(const CrossedCell& of, Visit&& visit) const {
        const unsigned negative = negative_corners(of);
        const unsigned known = known_corners(of);
        for (const Tetrahedron& tetrahedron : tetrahedra) {
            const Section& section = sections[negative_of(tetrahedron, negative)];
            if (section.size > 0 && (tetrahedron.corners & ~known) == 0) visit(tetrahedron, section);
        }
    }
};

// By the settings' triangle_limit, support and limit.  Throws Error{invalid_argument} where there would be more
// triangles.
[[nodiscard]] CrossedCells find_crossed_cells(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                              const geometry::VecArray& seeds, const Lattice& lattice,
                                              const MeshSettings& settings, const base::Progress& progress);

} // namespace hrbfnpr::curves
