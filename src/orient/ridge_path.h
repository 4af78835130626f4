// SPDX-License-Identifier: MIT
// The normals of noisy clouds, over a rising ridge.
#pragma once

#include "orient/least_energy.h"

namespace hrbfnpr::orient {

struct RidgeFit {
    LeastEnergy fitted;
    double roughest = 0.0;   // energy at the least ridge, which noise has not been taken out of
    double steadiness = 1.0; // the least share of equal signs between ridges that noise may call for
};

// From a ridge that only begins to see the noise up to the one it calls for, while the signs stay: a ridge that is too
// high makes one sheet of two, and merges tips.  most: the highest ridge.  given, effort: see least_energy().
[[nodiscard]] RidgeFit follow_ridges(const base::Runtime& runtime, const Cloud& cloud, const Near& near, double most,
                                     const geometry::VecArray* given, const Effort& effort,
                                     const base::Progress& progress);

// Means of the normals about each place that point the same way, by a Gaussian of this deviation.
[[nodiscard]] geometry::VecArray smooth_directions(const base::Runtime& runtime, const geometry::PointTree& tree,
                                                   const Near& near, const geometry::VecArray& normal,
                                                   double deviation);

} // namespace hrbfnpr::orient
