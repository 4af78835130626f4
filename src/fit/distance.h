// SPDX-License-Identifier: MIT
// Distances of samples from a fitted surface.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "fit/samples.h"
#include "implicit/hrbf.h"

namespace hrbfnpr::fit {

struct Distances {
    explicit Distances(base::Memory& memory) noexcept : value(memory), gradient(memory), distance(memory) {}

    base::Array<double> value; // f at each sample
    geometry::VecArray gradient;
    // The signed first-order distance f / |grad f| (Taubin, "Estimation of planar curves, surfaces, and nonplanar space
    // curves defined by implicit equations", 1991).
    base::Array<double> distance;
};

// Computes the distances from the misfit of a solver: -f(x_i) in normalised units, and n_i - grad f(x_i), 4 numbers per
// sample.
[[nodiscard]] Distances distances_of_misfit(const base::Array<double>& misfit, const implicit::HrbfData& data,
                                            const Samples& samples);

[[nodiscard]] Distances measure_distances(const base::Work& work, const implicit::HrbfData& data,
                                          const Samples& samples);
// Measures the distances from the zero level of any implicit.
[[nodiscard]] Distances measure_distances(const base::Work& work, const implicit::Implicit& implicit,
                                          const Samples& samples);

} // namespace hrbfnpr::fit
