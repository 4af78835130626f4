// SPDX-License-Identifier: MIT
// The normals of least energy of a cloud, from several starts.
#pragma once

#include "fit/hermite_energy.h"
#include "orient/cloud.h"
#include "orient/directions.h"
#include "orient/signs.h"

#include <limits>

namespace hrbfnpr::orient {

// Normals of a coarser cloud's least energy at every place, that energy, and how far its own starts agreed.
struct Begin {
    explicit Begin(base::Memory& memory) noexcept : normal(memory) {}

    geometry::VecArray normal;
    double energy = 0.0; // over the degrees of freedom
    double apart = 1.0;  // how far its points are from each other
    double agreement = 0.0;

    // With points 1 apart.
    [[nodiscard]] double own_energy() const noexcept { return energy * apart; }
};

struct Effort {
    int starts = 6;               // at most: two that come to the same are enough
    bool all = false;             // ... unless all are wanted
    bool tree = false;            // beside them one with the signs of a spanning tree
    const Begin* begin = nullptr; // and one from these
};

struct LeastEnergy {
    explicit LeastEnergy(base::Memory& memory) noexcept : normal(memory) {}

    geometry::VecArray normal; // unit, of each place
    double energy = 0.0;       // over the degrees of freedom: 0.025 is that of points without any order
    double agreement = 1.0;    // 0 .. 1: how far starts that came as low are the same
    // Energy over the least of the lowest start whose signs are others: near 1 where the noise decides.
    double rival = std::numeric_limits<double>::infinity();
    std::unique_ptr<fit::HermiteEnergy> form; // the energy itself; refers to the tree and the ranks
};

// given: normals to begin with, with their signs, or null.  ridge: see HermiteEnergy.
[[nodiscard]] LeastEnergy least_energy(const base::Runtime& runtime, const geometry::PointTree& tree,
                                       const base::Array<std::int64_t>& rank, const Near& near, double ridge,
                                       const geometry::VecArray* given, const Effort& effort,
                                       const base::Progress& progress);

// Share of places whose signs are the same, or of those whose are not: 0.5 .. 1.
[[nodiscard]] double share_alike(const geometry::VecArray& a, const geometry::VecArray& b) noexcept;

// How noisy a cloud is: the ridge that its noise calls for, 0 for a clean one.
struct Noise {
    double deviation = 0.0; // over the spacing
    double ridge = 0.0;
};
[[nodiscard]] Noise measure_noise(const base::Runtime& runtime, const Cloud& cloud, const base::Progress& progress);

} // namespace hrbfnpr::orient
