// SPDX-License-Identifier: MIT
// The part of a mesh where a function g is not positive, cut along the curve g = 0 on the surface.
#pragma once

#include "curves/curve_points.h"

namespace hrbfnpr::curves {

struct ClippedMesh {
    explicit ClippedMesh(base::Memory& memory) noexcept : mesh(memory), cut(memory) {}

    SurfaceMesh mesh; // vertices from `first_cut` on stand on the curve, with f = g = 0
    std::int64_t first_cut = 0;
    base::Array<CurvePoint> cut; // these, as they were evaluated last
    double left_out = 0.0;       // the share of the area that was cut away
};

// The same bits for any thread count.
[[nodiscard]] ClippedMesh clip(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
                               const base::Progress& progress);

} // namespace hrbfnpr::curves
