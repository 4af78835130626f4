// SPDX-License-Identifier: MIT
// The camera as the frame sees it, and the helpers that build its matrices (GLM).
#pragma once

#include "base/view.h"
#include "drawing/window.h"
#include "geometry/vec.h"

#include <cstdint>

namespace hrbfnpr::frame {

using drawing::DepthConvention;

struct Camera {
    DepthConvention depth = DepthConvention::negative_one_to_one;
    glm::dmat4 view{1.0};
    glm::dmat4 projection{1.0};
    glm::dvec4 viewport{0.0}; // x, y of the top-left corner, width, height, pixels
};

// All throw Error{invalid_argument} naming the argument.
[[nodiscard]] glm::dmat4 look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up);
[[nodiscard]] glm::dmat4 perspective(double vertical_angle, double width, double height, double near_plane,
                                     double far_plane, DepthConvention depth);
[[nodiscard]] glm::dmat4 orthographic(double view_height, double width, double height, double near_plane,
                                      double far_plane, DepthConvention depth);
[[nodiscard]] Camera fit_bounds(const geometry::Bounds& bounds, const glm::dvec3& direction, const glm::dvec3& up,
                                double vertical_angle, double width, double height, double margin,
                                DepthConvention depth);

// The same for points of 3 components, at least one, relative to `origin`: as large as the picture allows, and in its
// middle.
[[nodiscard]] Camera fit_points(const base::InView& points, const glm::dvec3& origin, const glm::dvec3& direction,
                                const glm::dvec3& up, double vertical_angle, double width, double height, double margin,
                                DepthConvention depth);

} // namespace hrbfnpr::frame
