// SPDX-License-Identifier: MIT
// The cells of a uniform grid near one surface: found by flood fill from points on it, so that
// sheets which no seed belongs to are never reached.
#pragma once

#include "geometry/cell_grid.h"
#include "marks/site.h"

namespace hrbfnpr::stipples {

// A cell and the plane that f looks like from its centre: f(x) / |grad f| ~ distance + normal . (x - centre).
struct SurfaceCell {
    std::uint64_t code; // geometry/morton.h
    double distance;    // NaN: no such plane
    glm::dvec3 normal;
};

struct SurfaceCells {
    explicit SurfaceCells(base::Memory& memory) noexcept : cell(memory) {}

    geometry::CellGrid grid;
    geometry::Bounds region;       // marks stay inside
    double band = 0.0;             // every point within this distance of the surface (inside the region) is in a cell
    base::Array<SurfaceCell> cell; // along a space-filling curve

    [[nodiscard]] double volume() const noexcept {
        return static_cast<double>(cell.size()) * grid.side * grid.side * grid.side;
    }
    [[nodiscard]] double half_diagonal() const noexcept;
    // Half the thickness of the layer that the cells fill, to first order.
    [[nodiscard]] double reach() const noexcept { return half_diagonal() + band; }
    // Area of the surface, within some 10 %: the layer's volume over its thickness.
    [[nodiscard]] double rough_area() const noexcept { return volume() / (2.0 * reach()); }
};

// Cells of side `side`; the band is half of that.
[[nodiscard]] SurfaceCells find_surface_cells(const marks::Site& site, const geometry::VecArray& seeds,
                                              const geometry::Bounds& region, double side,
                                              const base::Progress& progress);

} // namespace hrbfnpr::stipples
