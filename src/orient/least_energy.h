// SPDX-License-Identifier: MIT
// The normals of least energy of some places, from several starts.
#pragma once

#include "orient/cloud.h"

#include <limits>

namespace hrbfnpr::orient {

// The normals of a coarser cloud's least energy at every place, that energy, and how far its own starts agreed.
struct Begin {
    explicit Begin(base::Memory& memory) noexcept : normal(memory) {}

    // The energy that points 1 apart would have.
    [[nodiscard]] double own_energy() const noexcept { return energy * apart; }

    geometry::VecArray normal;
    double energy = 0.0; // over the degrees of freedom
    double apart = 1.0;  // distance between its points
    double agreement = 0.0;
};

struct Effort {
    int starts = 6;               // at most: two that come to the same are enough
    bool all = false;             // unless all are wanted
    bool tree = false;            // adds a start whose signs are those of a spanning tree
    const Begin* begin = nullptr; // adds a start from these
};

struct LeastEnergy {
    explicit LeastEnergy(base::Memory& memory) noexcept : normal(memory) {}

    geometry::VecArray normal; // unit, of each place
    double energy = 0.0;       // over the degrees of freedom: 0.025 is that of points without any order
    double agreement = 1.0;    // 0 .. 1: how far starts that came as low have the same signs
    // Energy over the least of the lowest start whose signs are others: near 1 where the noise decides.
    double rival = std::numeric_limits<double>::infinity();
};

// ridge: that of fit::HermiteEnergy. given: normals to begin with, with their signs, or null.
[[nodiscard]] LeastEnergy least_energy(const base::Work& work, const Places& places, const Near& near, double ridge,
                                       const geometry::VecArray* given, const Effort& effort);

} // namespace hrbfnpr::orient
