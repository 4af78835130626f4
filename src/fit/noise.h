// SPDX-License-Identifier: MIT
// Measures how noisy samples are.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "fit/samples.h"

namespace hrbfnpr::fit {

struct Noise {
    double position = 0.0; // standard deviation along the normal, in the caller's unit; 0: no noise found
    double normal = 0.0;   // standard deviation of a normal's component; 0 if `position` is 0
};

// A smooth f with f(x) = 0 and grad f(x) = n has (x_j - x_i) . (n_i + n_j) / 2 = O(d^3), d = |x_j - x_i| (the
// trapezoidal rule). Noise adds 2 position^2 + normal^2 d^2 / 2 to the variance of this. So the variance is measured
// over pairs of each sample and its neighbours, in groups from the nearest to the 32nd, and a + b d^2 + c d^6 is fitted
// to it.
[[nodiscard]] Noise measure_noise(const base::Work& work, const Samples& samples);

} // namespace hrbfnpr::fit
