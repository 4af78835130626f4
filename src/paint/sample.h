// SPDX-License-Identifier: MIT
// A place on a surface, and what a field gives there.
#pragma once

#include "geometry/vec.h"

namespace hrbfnpr::paint {

struct Place {
    glm::dvec3 position;
    glm::dvec3 normal; // a unit vector; fields of points do not read it
};

struct Sample {
    glm::dvec3 value{0.0}; // the value of a scalar field is x
    double weight = 0.0;   // 0: the field says nothing, and the value is 0; at most 1
};

} // namespace hrbfnpr::paint
