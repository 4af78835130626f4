// SPDX-License-Identifier: MIT
// Makes a surface from points. It removes unusable points, makes or repairs normals, chooses samples, fits a model to
// them, and ends it where the points end.
#pragma once

#include "picture/call.h"

namespace hrbfnpr::picture {

// Removes faces with a corner that is not finite, and points whose coordinates mark missing data.
void leave_out_unusable(const Call& call, Shape& shape);

// Returns whether the points have normals, and at least one normal is not 0.
[[nodiscard]] bool has_normals(const Shape& shape) noexcept;

// Smooths the image of a depth camera. The sensor's noise is reduced by the factor in the options. The shape keeps the
// points that the camera saw, with normals towards the camera.
[[nodiscard]] hrbfnpr_depth_image_info smooth_depth_image(const Call& call, Stage& stage, Shape& shape);
// Returns the standard deviation of the depths. It follows from the deviation of the inverse depths, which the library
// measures.
[[nodiscard]] constexpr double depth_noise_of(const hrbfnpr_depth_image_info& info) noexcept {
    return info.noise * info.depth * info.depth;
}

// Warns if the caller gives a viewpoint that has no effect.
void tell_unused_viewpoint(const Call& call, const Shape& shape);

// Fits a surface to points. `up` receives the up direction: the direction in the options, or else the direction that is
// found.
[[nodiscard]] Surface fit_points(const Call& call, Shape&& shape, glm::dvec3& up);

// Fits a model to samples, and reports in notes how the fit changed them. `of_points` is true for points that may have
// noise, and false for samples of a mesh. `has_dust` is true if they may include dust.
[[nodiscard]] Model fit_samples(const Call& call, const Points& points, const Points& normals, bool of_points,
                                bool has_dust);

// Warns if the samples are too few, or too flat, to define a surface well.
void tell_thin_evidence(const Call& call, const Points& points);

} // namespace hrbfnpr::picture
