// SPDX-License-Identifier: MIT
// From points to a surface: what cannot be used is left out, normals are made or repaired, samples are chosen, a model
// is fitted to them, and it ends where the points do.
#pragma once

#include "picture/call.h"

namespace hrbfnpr::picture {

// Leaves out faces with a corner that is not finite, and points at a value that stands for no data.
void leave_out_unusable(const Call& call, Shape& shape);

// Whether points have normals, others than zeros.
[[nodiscard]] bool has_normals(const Shape& shape) noexcept;

// Takes the sensor's noise off the image of a depth camera, by the options' factor, and leaves the points that were
// seen, with normals that look to the camera.
[[nodiscard]] hrbfnpr_depth_image_info smooth_depth_image(const Call& call, Stage& stage, Shape& shape);
// The deviation of its depths; the library measures that of the inverse.
[[nodiscard]] constexpr double depth_noise_of(const hrbfnpr_depth_image_info& info) noexcept {
    return info.noise * info.depth * info.depth;
}

// Warns if a viewpoint is given that nothing is turned to.
void tell_unused_viewpoint(const Call& call, const Shape& shape);

// Fits a surface to points. up: the options' direction, or the one that is found.
[[nodiscard]] Surface fit_points(const Call& call, Shape&& shape, glm::dvec3& up);

// A model of these samples, with notes on what the fit made of them. of_points: they may have noise, and are no samples
// of a mesh. normals_made: the points had none, so that there may be dust among them.
[[nodiscard]] Model fit_samples(const Call& call, const Points& points, const Points& normals, bool of_points,
                                bool normals_made);

// Warns of samples that hardly make a surface.
void tell_thin_evidence(const Call& call, const Points& points);

} // namespace hrbfnpr::picture
