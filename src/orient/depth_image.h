// SPDX-License-Identifier: MIT
// The image of a depth camera: points without the sensor's noise, and their normals.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "base/view.h"
#include "geometry/vec_array.h"

namespace hrbfnpr::orient {

// As hrbfnpr_depth_image_desc.  The view has 3 components and columns x rows elements (the boundary checks).
struct DepthImageInput {
    base::InView points;
    std::int32_t columns = 0;
    std::int32_t rows = 0;
    bool keep_points = false;
    double noise = 0.0; // 0: measured
    double smoothing = 1.0;
};

struct DepthImageReport {
    std::int64_t seen = 0;
    std::int64_t left_out = 0;
    double noise = 0.0;        // of 1 / z
    double focal_length = 0.0; // pixels
    double depth = 0.0;        // median
    double radius = 0.0;       // median, pixels
    double seconds = 0.0;
};

// Of each pixel; NaN and a zero normal where nothing was seen, or what was is left out.
struct DepthImage {
    explicit DepthImage(base::Memory& memory) noexcept : point(memory), normal(memory) {}

    geometry::VecArray point;
    geometry::VecArray normal;
    DepthImageReport report;
};

// Throws Error{invalid_argument, out_of_memory, cancelled}.
[[nodiscard]] DepthImage smooth_depth_image(const base::Runtime& runtime, const DepthImageInput& input,
                                            const base::Progress& progress);

} // namespace hrbfnpr::orient
