// Points spread by area over the part of a surface that a set of cells covers, from which marks are chosen.
#pragma once

#include "sampling/marks.h"
#include "sampling/surface_cells.h"

namespace hrbfnpr::sampling {

// Cell by cell along a space-filling curve, in single precision: who is chosen comes to rest on the surface later.
struct Candidates {
    explicit Candidates(base::Memory& memory) noexcept
        : code(memory), first(memory), x(memory), y(memory), z(memory), normal(memory), ticket(memory) {}

    [[nodiscard]] std::int64_t count() const noexcept { return x.size(); }
    [[nodiscard]] std::int64_t cells() const noexcept { return code.size(); }

    geometry::CellGrid grid;
    geometry::Bounds region;
    base::Array<std::uint64_t> code;   // of the cells that hold some (geometry/morton.h), ascending
    base::Array<std::int64_t> first;   // of each cell's candidates, and the end of the last one's
    base::Array<float> x, y, z;        // relative to grid.origin; within about curvature * (side / 4)^2 of the surface
    base::Array<float> normal;         // packed_normal (order_loops.h)
    base::Array<std::uint32_t> ticket; // random
    LevelReport report;                // attempted: all that were near the surface
    double area = 0.0;                 // of the surface inside the region, estimated
};

// At least `wanted`, or as many as a few rounds give.
[[nodiscard]] Candidates draw_candidates(const Site& site, const SurfaceCells& cells, std::int64_t wanted, Group group,
                                         const base::Progress& progress);

} // namespace hrbfnpr::sampling
