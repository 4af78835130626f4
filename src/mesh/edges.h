// SPDX-License-Identifier: MIT
// What lies across the edges of faces, and what hangs together.
#pragma once

#include "mesh/mesh.h"

#include <numeric>

namespace hrbfnpr::mesh {

// Sets of numbers that grow together.  Their names do not depend on the order in which they are joined: the least.
class Sets {
public:
    Sets(base::Memory& memory, std::int64_t count) : above_(memory) {
        above_.resize_for_overwrite(count);
        std::iota(above_.begin(), above_.end(), 0);
    }
    [[nodiscard]] std::int32_t of(std::int32_t i) noexcept {
        while (above_[i] != i) i = above_[i] = above_[above_[i]];
        return i;
    }
    void join(std::int32_t a, std::int32_t b) noexcept {
        a = of(a);
        b = of(b);
        above_[a < b ? b : a] = a < b ? a : b;
    }

private:
    base::Array<std::int32_t> above_;
};

// A side of a face: from corner k to k + 1.
struct Side {
    std::uint64_t edge; // lower vertex, higher vertex
    std::int32_t face;
    std::int32_t forward; // 1: from the lower one to the higher one
};

// All sides, those of one edge one after the other.
[[nodiscard]] base::Array<Side> sides_by_edge(const base::Runtime& runtime, const base::Array<Triangle>& triangle,
                                              const base::Progress& progress = {});

// Calls visit(first side, behind the last) for each edge.
template <class Visit>
void for_edges(const base::Array<Side>& sides, const base::Progress& progress, Visit&& visit) {
    constexpr std::int64_t edges_a_look = 16384;
    std::int64_t edges = 0;
    for (const Side* first = sides.begin(); first != sides.end();) {
        if (edges++ % edges_a_look == 0) progress.check();
        const Side* last = first + 1;
        while (last != sides.end() && last->edge == first->edge) ++last;
        visit(first, last);
        first = last;
    }
}

template <class Visit>
void for_edges(const base::Array<Side>& sides, Visit&& visit) {
    for_edges(sides, base::Progress(), std::forward<Visit>(visit));
}

inline constexpr double default_crease_angle = 30.0; // degrees

// Whether faces bend by more than an angle, but for rounding: those of a prism of twelve sides do by 30 degrees.
[[nodiscard]] constexpr bool bends_more(double bend, double angle) noexcept { return bend > 1.01 * angle; }

// Of each face, from 0, in the order of their first faces: what hangs together by shared vertices.
[[nodiscard]] base::Array<std::int32_t> components_of(const base::Array<Triangle>& triangle, std::int64_t vertices,
                                                      std::int64_t& count, const base::Progress& progress = {});

} // namespace hrbfnpr::mesh
