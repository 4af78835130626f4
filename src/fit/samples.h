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
    base::Array<double> value; // the value of f, in the caller's unit; empty: 0, because all samples are on the surface
    geometry::Bounds bounds;
    double spacing = 0.0; // mean distance to the nearest other sample; 0 for one sample
    std::int64_t merged = 0;
    std::int64_t rescaled_normals = 0;
};

// Throws Error{invalid_argument} naming "points" or "normals" and the index.
[[nodiscard]] Samples read_samples(const base::Work& work, const base::InView& points, const base::InView& normals);

// Replaces all samples that have the same representative, which is one of these samples, by their average. The order is
// that of the first sample of each group.
void merge(Samples& samples, const base::Array<std::int64_t>& representative);

// Measures bounds and spacing of the samples as they are now.
void measure_extent(const base::Work& work, Samples& samples);

} // namespace hrbfnpr::fit
