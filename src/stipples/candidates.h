// SPDX-License-Identifier: MIT
// Points spread by area over the part of a surface that a set of cells covers, from which marks are chosen.
#pragma once

#include "marks/marks.h"
#include "stipples/order_loops.h"
#include "stipples/surface_cells.h"

namespace hrbfnpr::stipples {

// Cell by cell along a space-filling curve, in single precision: who is chosen comes to rest on the surface later.
struct Candidates {
    explicit Candidates(base::Memory& memory) noexcept
        : code(memory), number(memory), first(memory), group(memory), ticket(memory) {}

    [[nodiscard]] std::int64_t cells() const noexcept { return code.size(); }
    [[nodiscard]] OrderBlock places() noexcept { return {group.data(), group.size()}; }
    // Calls visit(place) for the candidates of a cell with smaller tickets.
    template <class Visit>
    void for_taken(std::int64_t cell, std::uint64_t ticket_limit, Visit&& visit) const {
        for (std::int64_t place = first[cell]; place < first[cell] + number[cell]; ++place)
            if (ticket[place] < ticket_limit) visit(place);
    }

    geometry::CellGrid grid;
    geometry::Bounds region;
    std::int64_t count = 0;
    base::Array<std::uint64_t> code;   // of the cells that hold some (geometry/morton.h), ascending
    base::Array<std::int32_t> number;  // of each cell's candidates
    base::Array<std::int64_t> first;   // place of each cell's first; with all of them, it begins a group
    base::Array<OrderGroup> group;     // x, y, z: relative to grid.origin, within about curvature * (side / 4)^2 of the
                                       // surface; energies and clearances are for the order to set
    base::Array<std::uint32_t> ticket; // random, of each place in the groups
    marks::LevelReport report;         // attempted: all that were near the surface
    double area = 0.0;                 // of the surface inside the region, estimated
};

// About `wanted`.
[[nodiscard]] Candidates draw_candidates(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                         marks::Kind kind, const base::Progress& progress);

// Those with smaller tickets, in the same cells, of which some may hold none; close together.
[[nodiscard]] Candidates thinned(const marks::Site& site, Candidates& candidates, std::uint64_t ticket_limit,
                                 const base::Progress& progress);

} // namespace hrbfnpr::stipples
