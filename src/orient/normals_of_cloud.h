// SPDX-License-Identifier: MIT
// Normals of a cloud, as its noise, its size, and whether its points lie along curves call for.
#pragma once

#include "orient/least_energy.h"

namespace hrbfnpr::orient {

struct CloudNormals {
    explicit CloudNormals(base::Memory& memory) noexcept : fitted(memory) {}

    LeastEnergy fitted;
    double noise = 0.0; // standard deviation, in spacings
    double confidence = 0.0;
};

// given: normals to begin with, with their signs, or null.
[[nodiscard]] CloudNormals normals_of_cloud(const base::Work& work, const Cloud& cloud, const Near& near,
                                            const geometry::VecArray* given);

// ---- Its parts, for tests

struct RidgeFit {
    LeastEnergy fitted;
    double roughest = 0.0;   // energy at the least ridge, which noise has not been taken out of
    double steadiness = 1.0; // the least share of equal signs between ridges that noise may call for
};

// Fits a noisy cloud from a ridge that only begins to see the noise up to the one it calls for, `most`, while the signs
// stay: a ridge that is too high makes one sheet of two, and merges tips.
[[nodiscard]] RidgeFit follow_ridges(const base::Work& work, const Cloud& cloud, const Near& near, double most,
                                     const geometry::VecArray* given, const Effort& effort);

} // namespace hrbfnpr::orient
