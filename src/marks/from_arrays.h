// SPDX-License-Identifier: MIT
// Ready-made marks, from the caller's arrays.
#pragma once

#include "base/runtime.h"
#include "base/view.h"
#include "marks/point_set.h"

#include <span>

namespace hrbfnpr::marks {

// The arrays of one layer; hrbfnpr_layer_arrays says what empty ones mean.
struct LayerArrays {
    Kind kind = Kind::own;
    LayerName name{};
    base::InView position, normal, stroke_first, stroke_direction, direction, curvature, rank, level, width;
};

// The layers of another set, if there is one, and those of the arrays, without clusters.
// Throws Error{invalid_argument} that names layer, array and index.
[[nodiscard]] PointSet from_arrays(const base::Runtime& runtime, const PointSet* base,
                                   std::span<const LayerArrays> arrays, std::uint64_t random_seed);

} // namespace hrbfnpr::marks
