// SPDX-License-Identifier: MIT
// The box of a surface that goes through points along curves: between wires and beyond the first and last of cross
// sections it bulges out of the box of its samples.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

namespace hrbfnpr::generate {

// position: of the samples.  The implicit's own bounds; of 20 000 samples along curves at most, where the surface
// closes within a third of a diagonal around them, those of both.
[[nodiscard]] geometry::Bounds closed_bounds(const base::Runtime& runtime, const implicit::Implicit& implicit,
                                             const geometry::VecArray& position, const base::Progress& progress);

} // namespace hrbfnpr::generate
