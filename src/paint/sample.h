// SPDX-License-Identifier: MIT
// A place on a surface, and the sample of a field there.
#pragma once

#include "geometry/vec.h"

#include <cstdint>

namespace hrbfnpr::paint {

struct Place {
    glm::dvec3 position;
    glm::dvec3 normal; // a unit vector; fields of points do not read it
};

// Returns the place with an index in packed arrays.
[[nodiscard]] inline Place place_at(const double* positions, const double* normals, std::int64_t i) noexcept {
    return {{positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]},
            {normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]}};
}

struct Sample {
    glm::dvec3 value{0.0}; // the value of a scalar field is x
    double weight = 0.0;   // 0: the field says nothing, and the value is 0; at most 1
};

} // namespace hrbfnpr::paint
