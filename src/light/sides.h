// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/vec.h"

#include <glm/common.hpp>

#include <cstdint>

namespace hrbfnpr::light {

// Returns the number of the direction, of six along the axes, to which a vector is nearest.
[[nodiscard]] inline std::uint32_t side_of(const glm::dvec3& v) noexcept {
    const glm::dvec3 size = glm::abs(v);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<std::uint32_t>(2 * axis + (v[axis] < 0.0 ? 1 : 0));
}

} // namespace hrbfnpr::light
