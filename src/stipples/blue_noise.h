// SPDX-License-Identifier: MIT
// Stipples spread evenly over the area, in a progressive order.
#pragma once

#include "marks/site.h"
#include "stipples/surface_cells.h"

namespace hrbfnpr::stipples {

// The part of the surface that the marks are spread over, cut finely enough for `marks` of them.
[[nodiscard]] SurfaceCells cover_surface(const marks::Site& site, const marks::Seeds& seeds, double sample_spacing,
                                         std::int64_t marks, const base::Progress& progress);

struct EvenMarks {
    explicit EvenMarks(base::Memory& memory) noexcept : position(memory), normal(memory) {}

    geometry::VecArray position; // in the progressive order
    geometry::VecArray normal;
    marks::LevelReport report;
    double area = 0.0; // the area of the covered surface
};

// Throws not_converged if there is not a single one.
[[nodiscard]] EvenMarks spread_evenly(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                      marks::Kind kind, const base::Progress& progress);

} // namespace hrbfnpr::stipples
