// SPDX-License-Identifier: MIT
// One fit with every given sample as a centre.
#pragma once

#include "base/work.h"
#include "fit/fit.h"
#include "fit/samples.h"

namespace hrbfnpr::fit {

// The numbers that regularization adds to the diagonal for values and for gradients, in coordinates whose bounding box
// has a diagonal of 1.
struct Smoothing {
    double value = 0.0;
    double gradient = 0.0;
};

struct CentreFit {
    FitResult result;           // Only the report's fields about the kernel and the solver are set.
    base::Array<double> misfit; // see Solution::misfit
    // The most likely s^2 if f is a random function of covariance s^2 phi (in coordinates with a diagonal of 1) with
    // noise of variance s^2 times the smoothing: Rasmussen and Williams, "Gaussian Processes for Machine Learning",
    // 2006, 5.4.1.
    double variance = 0.0;
};

// An earlier fit to some of the centres. The iterations of a new fit can start at its weights.
struct EarlierFit {
    const implicit::HrbfData* data = nullptr; // null: there is no earlier fit
    // For each centre of the new fit, its index in the earlier fit, or -1. Null: both fits have the same centres.
    const base::Array<std::int64_t>* index = nullptr;
};

// `centres.bounds` are the model's bounds. They may differ from the bounds of the centres' positions.
[[nodiscard]] CentreFit fit_centres(const base::Work& work, const FitInput& input, const Samples& centres,
                                    const Smoothing& smoothing, const EarlierFit& earlier = {});

} // namespace hrbfnpr::fit
