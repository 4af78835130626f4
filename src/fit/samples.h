// SPDX-License-Identifier: MIT
// The caller's samples, checked, repaired and merged.
#pragma once

#include "base/operation.h"
#include "base/view.h"
#include "base/work.h"
#include "geometry/vec_array.h"

namespace hrbfnpr::fit {

struct Samples {
    explicit Samples(base::Memory& memory) noexcept : position(memory), normal(memory), value(memory) {}

    geometry::VecArray position; // in the caller's coordinates
    geometry::VecArray normal;   // unit length
    base::Array<double> value;   // the value of f at each sample, in the caller's unit; empty: all values are 0
    geometry::Bounds bounds;
    double spacing = 0.0; // the mean distance from a sample to its nearest other sample; 0 for one sample
    std::int64_t merged = 0;
    std::int64_t rescaled_normals = 0;
};

// Throws Error{invalid_argument} that names "points" or "normals" and the index.
[[nodiscard]] Samples read_samples(const base::Work& work, const base::InView& points, const base::InView& normals);

// Replaces all samples with the same representative by their average. The averages keep the order of the first sample
// of each group.
void merge(Samples& samples, const base::Array<std::int64_t>& representative);

// Measures the bounds and the spacing of the current samples.
void measure_extent(const base::Work& work, Samples& samples);

} // namespace hrbfnpr::fit
