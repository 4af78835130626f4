// SPDX-License-Identifier: MIT
// How far apart nested lines really lie: tone goes by the paper that each of them has.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "marks/point_set.h"

namespace hrbfnpr::marks {

// Fills the gap of each of the layer's marks, in separations: the distance between the lines around it, averaged over
// some of them and along its own.  Of layers without lines of a known separation nothing.
void measure_gaps(const base::Runtime& runtime, const Layer& layer, base::Array<float>& gap,
                  const base::Progress& progress);

} // namespace hrbfnpr::marks
