// SPDX-License-Identifier: MIT
// Stipples spread evenly over the area, or by a density, in a progressive order.
#pragma once

#include "marks/site.h"
#include "stipples/surface_cells.h"

#include <cstdint>

namespace hrbfnpr::stipples {

// The part of the surface that the marks are spread over, cut finely enough for `marks` of them.
[[nodiscard]] SurfaceCells cover_surface(const marks::Site& site, const marks::Seeds& seeds, double sample_spacing,
                                         std::int64_t marks);

struct EvenMarks {
    explicit EvenMarks(base::Memory& memory) noexcept : position(memory), normal(memory) {}

    geometry::VecArray position; // in the progressive order
    geometry::VecArray normal;
    marks::LevelReport report;
    double area = 0.0; // the area of the covered surface
};

// Throws not_converged if there is not a single one.
[[nodiscard]] EvenMarks spread_evenly(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                      marks::Kind kind);

// ---- Densities: where stipples are to be denser

// The numbers are those that hrbfnpr_layer_desc.density takes.
enum class Density : std::uint32_t { uniform = 0, curvature = 1, callback = 2 };

struct DensitySettings {
    Density kind = Density::uniform;
    double strength = 0.5;
    marks::PlaceFn function = nullptr;
    void* user = nullptr;
};

// `wanted` marks of an even order, from which those are left out whose place in the order, divided by the density at
// the mark, is too high: every prefix of the rest is, at each place, a prefix of the even order.
[[nodiscard]] EvenMarks spread_by_density(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                          const DensitySettings& density);

} // namespace hrbfnpr::stipples
