// SPDX-License-Identifier: MIT
// Makes a surface from points. It removes unusable points, makes or repairs normals, chooses samples, fits a model to
// them, and ends it where the points end.
#pragma once

#include "picture/call.h"

namespace hrbfnpr::picture {

// Removes faces with a corner that is not finite, and points whose coordinates mark missing data.
void leave_out_unusable(const Call& call, Shape& shape);

// Tells whether points have normals that are not all zero.
[[nodiscard]] bool has_normals(const Shape& shape) noexcept;

// Reduces the sensor's noise in the image of a depth camera by the factor in the options. The shape keeps the points
// that were seen, with normals towards the camera.
[[nodiscard]] hrbfnpr_depth_image_info smooth_depth_image(const Call& call, Stage& stage, Shape& shape);
// Returns the standard deviation of the depths, from the deviation of the inverse depth, which the library measures.
[[nodiscard]] constexpr double depth_noise_of(const hrbfnpr_depth_image_info& info) noexcept {
    return info.noise * info.depth * info.depth;
}

// Warns if a viewpoint is given but nothing is turned towards it.
void tell_unused_viewpoint(const Call& call, const Shape& shape);

// Fits a surface to points. `up` is the direction of the options, or the one that is found.
[[nodiscard]] Surface fit_points(const Call& call, Shape&& shape, glm::dvec3& up);

// Fits a model to samples, and notes the changes that the fit made to them. `of_points` tells that the samples are
// points that may have noise, not samples of a mesh. `normals_made` tells that the points had no normals, so they may
// include dust.
[[nodiscard]] Model fit_samples(const Call& call, const Points& points, const Points& normals, bool of_points,
                                bool normals_made);

// Warns of samples that hardly define a surface.
void tell_thin_evidence(const Call& call, const Points& points);

} // namespace hrbfnpr::picture
