// SPDX-License-Identifier: MIT
// Which sheet of an implicit points are on, so that nothing is averaged over a crease.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::surface {

// Of each point; empty where the implicit is smooth.
[[nodiscard]] base::Array<std::int32_t> sheets_at(const base::Work& work, const implicit::Implicit& implicit,
                                                  const geometry::VecArray& points);

// The cosine of 15 degrees: sheets that meet at a smaller angle are one surface.
inline constexpr double smooth_cosine = 0.9659;

// Whether a crease is between two places, by their sheets and unit normals.
[[nodiscard]] inline bool is_creased(std::int32_t sheet, std::int32_t other, const glm::dvec3& normal,
                                     const glm::dvec3& other_normal) noexcept {
    return sheet != other && glm::dot(normal, other_normal) < smooth_cosine;
}

} // namespace hrbfnpr::surface
