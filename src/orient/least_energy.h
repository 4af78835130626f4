// SPDX-License-Identifier: MIT
// Finds the normals of least energy of a set of places. It searches from several starts.
#pragma once

#include "orient/cloud.h"

#include <limits>

namespace hrbfnpr::orient {

// The result for a coarser cloud: its normals of least energy, blended at every place, its energy, and the agreement of
// its own starts.
struct CoarseStart {
    explicit CoarseStart(base::Memory& memory) noexcept : normal(memory) {}

    // Returns the energy for points at a distance of 1.
    [[nodiscard]] double energy_at_unit_spacing() const noexcept { return energy * spacing; }

    geometry::VecArray normal;
    double energy = 0.0;  // energy per degree of freedom
    double spacing = 1.0; // the distance between the points of the coarser cloud
    double agreement = 0.0;
};

struct StartOptions {
    int starts = 6;       // The largest number of starts. The search ends earlier if two starts reach the same result.
    bool run_all = false; // If set, all starts run, even if two reach the same result.
    bool tree = false;    // If set, one more start spreads signs along a spanning tree.
    const CoarseStart* begin = nullptr; // If not null, one more start begins with the normals of a coarser cloud.
};

struct LeastEnergy {
    explicit LeastEnergy(base::Memory& memory) noexcept : normal(memory) {}

    geometry::VecArray normal; // unit normal of each place
    double energy = 0.0;       // energy per degree of freedom; 0.025 for points without any order
    double agreement = 1.0;    // 0 to 1: the share of equal signs among the results of about the same energy
    // The least energy of a result with other signs, divided by the energy of the chosen result. If the ratio is near
    // 1, only the noise decides between the two results.
    double rival = std::numeric_limits<double>::infinity();
};

// `ridge` is the regularization, as in fit::HermiteEnergy. `given` holds signed normals as a start, or is null.
[[nodiscard]] LeastEnergy least_energy(const base::Work& work, const OrderedPoints& places, const NeighbourLists& near,
                                       double ridge, const geometry::VecArray* given, const StartOptions& options);

} // namespace hrbfnpr::orient
