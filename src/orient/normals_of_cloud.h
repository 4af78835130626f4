// SPDX-License-Identifier: MIT
// Finds the normals of a cloud. The method depends on its noise, its size, and whether its points lie along curves.
#pragma once

#include "orient/least_energy.h"

namespace hrbfnpr::orient {

struct CloudNormals {
    explicit CloudNormals(base::Memory& memory) noexcept : fitted(memory) {}

    LeastEnergy fitted;
    double noise = 0.0; // the standard deviation of the noise, in spacings
    double confidence = 0.0;
};

// `given` holds signed normals as a start, or is null.
[[nodiscard]] CloudNormals normals_of_cloud(const base::Work& work, const Cloud& cloud, const NeighbourLists& near,
                                            const geometry::VecArray* given);

// ---- Its parts, for tests

struct RidgeFit {
    LeastEnergy fitted;
    double roughest = 0.0;   // the energy with the lowest regularization, which smooths no noise
    double steadiness = 1.0; // the smallest share of equal signs between the regularizations tried
};

// Fits a noisy cloud with rising regularization. It begins where noise is hardly affected, and ends at `most`, which
// suits the noise. It stops before signs change: too much regularization merges two sheets, or the tips of a shape.
[[nodiscard]] RidgeFit follow_ridges(const base::Work& work, const Cloud& cloud, const NeighbourLists& near,
                                     double most, const geometry::VecArray* given, const StartOptions& effort);

} // namespace hrbfnpr::orient
