// Points uniform by area on the part of a surface that a set of cells covers.
#pragma once

#include "sampling/marks.h"
#include "sampling/surface_cells.h"

namespace hrbfnpr::sampling {

struct Candidates {
    explicit Candidates(base::Memory& memory) noexcept : position(memory), normal(memory) {}

    geometry::VecArray position;
    geometry::VecArray normal;
    LevelReport report; // of what was projected
    double area = 0.0;  // of the surface inside the region, estimated
};

// At least `wanted`, or as many as a few rounds give.
[[nodiscard]] Candidates draw_candidates(const Site& site, const SurfaceCells& cells, std::int64_t wanted, Group group,
                                         const base::Progress& progress);

} // namespace hrbfnpr::sampling
