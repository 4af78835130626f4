// SPDX-License-Identifier: MIT
// Where marks start from.                                             [NPAR 4.2, 5.1]
#pragma once

#include "geometry/vec_array.h"
#include "marks/point_set.h"

namespace hrbfnpr::marks {

struct Seeds {
    explicit Seeds(base::Memory& memory) noexcept : position(memory), normal(memory) {}

    geometry::VecArray position; // on the surface
    geometry::VecArray normal;   // unit
    SeedSource source = SeedSource::points;
    LevelReport report;
    double step = 0.0; // rho_0: as set, or the estimate for this source
};

} // namespace hrbfnpr::marks
