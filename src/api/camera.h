// SPDX-License-Identifier: MIT
// Converts the public camera to the frame's camera.
#pragma once

#include "api/descriptor.h"
#include "frame/scene/camera.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

template <>
hrbfnpr_camera defaults() noexcept;

// The struct must have been read by read_struct(). The frame checks its numbers.
[[nodiscard]] frame::Camera to_camera(const hrbfnpr_camera& camera);

[[nodiscard]] inline glm::dmat4 to_matrix(const double* column_major) noexcept {
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = column_major[i];
    return matrix;
}

inline void from_matrix(double* column_major, const glm::dmat4& matrix) noexcept {
    for (int i = 0; i < 16; ++i) column_major[i] = matrix[i / 4][i % 4];
}

} // namespace hrbfnpr::api
