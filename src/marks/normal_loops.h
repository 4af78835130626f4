// SPDX-License-Identifier: MIT
// The inner loop of averaged normals, for every instruction set.
#pragma once

#include "base/instruction_set.h"

#include <cstdint>

namespace hrbfnpr::marks {

// Points with normals. `sheet` has the number of the sheet of each point; null if the surface is smooth.
struct PointsWithNormals {
    const double *x, *y, *z;
    const double *nx, *ny, *nz;
    const double* sheet;
};

// Marks close to each other, and the sum of the normals around each of them.
struct NormalSums {
    static constexpr std::int64_t size = 8;
    double x[size], y[size], z[size];
    double nx[size], ny[size], nz[size];
    double sheet[size];
    double sum_x[size], sum_y[size], sum_z[size];
};

// The limits that average_normals() describes.
struct NormalLimits {
    double squared_radius, squared_steepest, smooth_cosine;
};

struct NormalLoops {
    // Adds to each sum the weighted normals of those of the points with the indices in `at` that belong to the surface
    // around its mark. The points are added in their order, so the bits are the same for every instruction set.
    void (*add_normals)(const PointsWithNormals& points, const std::int32_t* at, std::int64_t count,
                        const NormalLimits& limits, NormalSums& sums);
};

[[nodiscard]] NormalLoops normal_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::marks
