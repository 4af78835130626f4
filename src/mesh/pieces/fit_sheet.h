// SPDX-License-Identifier: MIT
// One sheet: a Hermite fit to a patch, with as many of its samples as it takes.
#pragma once

#include "fit/fit.h"
#include "mesh/pieces/patches.h"

namespace hrbfnpr::mesh {

struct SheetFit {
    implicit::HrbfData data;
    fit::FitReport report;    // residuals at the centres, distances of all samples
    double squares = 0.0;     // sum of the samples' squared distances
    double worst = 0.0;       // distance of a sample, in its tolerance
    std::int64_t outside = 0; // samples beyond their tolerance
    std::int32_t rounds = 0;
    std::int64_t samples = 0;
};

// options: as of fit_mesh.  most: centres.
[[nodiscard]] SheetFit fit_sheet(const base::Runtime& runtime, const PatchSamples& patch, const fit::FitInput& options,
                                 std::int64_t most, const base::Progress& progress);

} // namespace hrbfnpr::mesh
