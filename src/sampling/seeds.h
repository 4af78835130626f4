// Where the sampling starts.                                          [NPAR 4.2, 5.1]
#pragma once

#include "sampling/generate.h"
#include "sampling/site.h"

namespace hrbfnpr::sampling {

struct Seeds {
    explicit Seeds(base::Memory& memory) noexcept : position(memory), normal(memory) {}

    geometry::VecArray position; // on the surface
    geometry::VecArray normal;   // unit
    SeedSource source = SeedSource::points;
    LevelReport report;
    double step = 0.0; // rho_0: as set, or the estimate for this source
};

// Throws not_converged if none reaches the surface.
[[nodiscard]] Seeds make_seeds(const Site& site, const SampleHint& samples, const GenerateSettings& settings,
                               const base::Progress& progress);

} // namespace hrbfnpr::sampling
