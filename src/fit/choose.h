// SPDX-License-Identifier: MIT
// Chooses which samples become centres: all samples, or a few that represent the others.
#pragma once

#include "base/work.h"
#include "fit/distance.h"
#include "fit/fit_centres.h"
#include "fit/noise.h"

namespace hrbfnpr::fit {

struct ChosenFit {
    CentreFit fit;
    base::Array<std::int64_t> centres; // indices of samples, ascending
    Distances distances;               // the distances of all samples from the surface
    std::int32_t rounds = 0;           // the number of fits; 0 if all samples are centres
    double seconds_before = 0.0;       // the time of all rounds except the last
};

// Chooses the first centres by farthest-point sampling. Rounds then add the samples with the largest errors, until all
// samples are within the tolerance or the number of centres is `maximum_centres`. The greedy choice is that of Carr et
// al., "Reconstruction and representation of 3D objects with radial basis functions", 2001, in batches.
[[nodiscard]] ChosenFit choose_and_fit(const base::Work& work, const FitInput& input, const Samples& samples,
                                       const Noise& noise);

} // namespace hrbfnpr::fit
