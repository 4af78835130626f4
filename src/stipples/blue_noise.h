// SPDX-License-Identifier: MIT
// Spreads stipples evenly over the area, or by a density, in a progressive order.
#pragma once

#include "marks/site.h"
#include "stipples/surface_cells.h"

#include <cstdint>

namespace hrbfnpr::stipples {

// Finds the cells of the surface over which marks are spread. The cells are small enough for `marks` marks.
[[nodiscard]] SurfaceCells cover_surface(const marks::Site& site, const marks::Seeds& seeds, double sample_spacing,
                                         std::int64_t marks);

struct EvenMarks {
    explicit EvenMarks(base::Memory& memory) noexcept : position(memory), normal(memory), place(memory) {}

    geometry::VecArray position; // the positions, in the progressive order
    geometry::VecArray normal;
    marks::LevelReport report;
    double area = 0.0; // the area of the covered surface
    // If marks that a still picture does not need are missing: for each mark, its place in the whole order, as a share
    // from 0 to 1; and the number of marks of the whole order. Otherwise empty and 0.
    base::Array<double> place;
    std::int64_t whole = 0;
};

// Throws not_converged if it cannot place any mark. Leaves out marks of the order that `need` does not ask for; null:
// it asks for all.
[[nodiscard]] EvenMarks spread_evenly(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                      marks::Kind kind, const marks::Need* need = nullptr);

// ---- Densities: where stipples are to be denser

// The values equal those of hrbfnpr_layer_desc.density.
enum class Density : std::uint32_t { uniform = 0, curvature = 1, callback = 2 };

struct DensitySettings {
    Density kind = Density::uniform;
    double strength = 0.5;
    marks::PointFunction function = nullptr;
    void* user = nullptr;
};

// Thins an even order to at most `wanted` marks. The place of each mark in the order is divided by the density there,
// and marks with a high result are left out. So around each place, the first marks of the result are the same as the
// first marks of some even order. Leaves out marks that site.need does not ask for, if the density is uniform.
[[nodiscard]] EvenMarks spread_by_density(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                          const DensitySettings& density);

} // namespace hrbfnpr::stipples
