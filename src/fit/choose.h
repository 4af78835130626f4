// SPDX-License-Identifier: MIT
// Which samples become centres: all of them, or the few that represent them.
#pragma once

#include "fit/distance.h"
#include "fit/fit_centres.h"
#include "fit/noise.h"

namespace hrbfnpr::fit {

struct Choice {
    CentreFit fit;
    base::Array<std::int64_t> centres; // which samples, in their order
    Distances distances;               // of all samples
    std::int32_t rounds = 0;           // fits made; 0 if all samples are centres
    double seconds_before = 0.0;       // of all rounds but the last
};

// Chooses by farthest-point sampling and then, in rounds, by what is worst off the fit so far, until all samples
// are within the tolerance or there are maximum_centres.  The greedy choice is that of Carr et al.,
// "Reconstruction and representation of 3D objects with radial basis functions", 2001, in batches.
[[nodiscard]] Choice choose_and_fit(const base::Work& work, const FitInput& input, const Samples& samples,
                                    const Noise& noise);

} // namespace hrbfnpr::fit
