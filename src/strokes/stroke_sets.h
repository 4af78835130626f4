// SPDX-License-Identifier: MIT
// Which set the strokes of a cross field belong to.
#pragma once

#include "base/runtime.h"
#include "strokes/stroke_marks.h"

namespace hrbfnpr::strokes {

// Strokes whose set is that whose lines they follow; `lines` are those of set 0.  One that changes over for long
// becomes two, so that each set alone leaves no gaps and has no strokes across its own.
// marks: in a separation, along a stroke.
[[nodiscard]] base::Array<OrderedStroke> split_by_set(const base::Runtime& runtime,
                                                      const base::Array<OrderedStroke>& strokes,
                                                      const surface::DirectionField& lines, double marks,
                                                      const base::Progress& progress);

} // namespace hrbfnpr::strokes
