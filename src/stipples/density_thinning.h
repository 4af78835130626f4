// SPDX-License-Identifier: MIT
// Stipples by a density on the surface.
#pragma once

#include "stipples/blue_noise.h"
#include "stipples/density.h"

namespace hrbfnpr::stipples {

// `wanted` marks of an even order, from which those are left out whose place in the order, divided by the density at
// the mark, is too high: every prefix of what remains is, at each place, a prefix of the even order.
[[nodiscard]] EvenMarks spread_by_density(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                          const DensitySettings& density, const base::Progress& progress);

} // namespace hrbfnpr::stipples
