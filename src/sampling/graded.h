// Stipples by a density on the surface.
#pragma once

#include "sampling/blue_noise.h"
#include "sampling/density.h"

namespace hrbfnpr::sampling {

// `wanted` marks of an even order, from which those are left out whose place in the order, divided by the density at
// the mark, is too high: every prefix of what remains is, at each place, a prefix of the even order.
[[nodiscard]] EvenMarks spread_by_density(const Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                          const DensitySettings& density, const base::Progress& progress);

} // namespace hrbfnpr::sampling
