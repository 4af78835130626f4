// SPDX-License-Identifier: MIT
// Densities on the surface: where stipples are to be denser.
#pragma once

#include "stipples/blue_noise.h"

#include <cstdint>

namespace hrbfnpr::stipples {

// The numbers are those that hrbfnpr_layer_desc.density takes.
enum class Density : std::uint32_t { uniform = 0, curvature = 1, callback = 2 };

using DensityFn = std::int32_t (*)(void* user, std::int64_t count, const double* positions, const double* normals,
                                   double* density);

struct DensitySettings {
    Density kind = Density::uniform;
    double strength = 0.5;
    DensityFn function = nullptr;
    void* user = nullptr;
};

// `wanted` marks of an even order, from which those are left out whose place in the order, divided by the density at
// the mark, is too high: every prefix of the rest is, at each place, a prefix of the even order.
[[nodiscard]] EvenMarks spread_by_density(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                          const DensitySettings& density, const base::Progress& progress);

} // namespace hrbfnpr::stipples
