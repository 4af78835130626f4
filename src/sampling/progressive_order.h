// A blue-noise order of points: each prefix of it is evenly spread over the surface.
#pragma once

#include "sampling/site.h"

namespace hrbfnpr::sampling {

// Places 0 .. n - 1 of the order as indices into `position`; n = min(wanted, what differs).
// By dart throwing with a radius that falls by 4 % a pass.  Neighbours whose normals point to
// opposite sides do not keep each other out: on a thin sheet both faces get their own order.
[[nodiscard]] base::Array<std::int64_t> progressive_order(const Site& site, const geometry::VecArray& position,
                                                          const geometry::VecArray& normal, std::int64_t wanted,
                                                          const base::Progress& progress);

} // namespace hrbfnpr::sampling
