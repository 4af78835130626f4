// SPDX-License-Identifier: MIT
// The caller's field of directions.
#pragma once

#include "marks/site.h"

namespace hrbfnpr::marks {

using DirectionFn = std::int32_t (*)(void* user, std::int64_t count, const double* positions, const double* normals,
                                     double* directions);

struct DirectionFunction {
    DirectionFn function = nullptr;
    void* user = nullptr;
};

// Unit and tangent, or zero where the field has none.  Calls on the thread that it is called on.
// Throws Error{callback}.
void directions_at(const Site& site, const DirectionFunction& field, const geometry::VecArray& positions,
                   const geometry::VecArray& normals, geometry::VecArray& directions, const base::Progress& progress);

} // namespace hrbfnpr::marks
