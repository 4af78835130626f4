// SPDX-License-Identifier: MIT
// Finds the sheet of each point, so that no quantity is averaged across a crease.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::surface {

// Returns the sheet of each point; an empty array if the implicit function is smooth.
[[nodiscard]] base::Array<std::int32_t> sheets_at(const base::Work& work, const implicit::Implicit& implicit,
                                                  const geometry::VecArray& points);

// The cosine of 15 degrees. Sheets that meet at a smaller angle count as one surface.
inline constexpr double smooth_cosine = 0.9659;

// Returns whether there is a crease between two points, given their sheets and unit normals.
[[nodiscard]] inline bool is_creased(std::int32_t sheet, std::int32_t other, const glm::dvec3& normal,
                                     const glm::dvec3& other_normal) noexcept {
    return sheet != other && glm::dot(normal, other_normal) < smooth_cosine;
}

} // namespace hrbfnpr::surface
