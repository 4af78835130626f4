// SPDX-License-Identifier: MIT
// The smoothest directions between measured ones.
#pragma once

#include "surface/direction_field.h"

namespace hrbfnpr::surface {

// Unit and tangent, one for each sample.
[[nodiscard]] geometry::VecArray smooth_directions(const base::Runtime& runtime, const FieldSamples& samples,
                                                   Symmetry symmetry, const base::Progress& progress);

} // namespace hrbfnpr::surface
