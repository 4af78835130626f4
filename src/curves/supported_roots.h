// SPDX-License-Identifier: MIT
// Which of the roots of f along lines are surface, where that ends for want of samples.
#pragma once

#include "curves/span_roots.h"
#include "curves/surface_end.h"

namespace hrbfnpr::curves {

// Takes those from the roots and the counts that lie beyond the border; where one lies on it, as far as numbers tell,
// the count is not certain.
void drop_unsupported(const base::Runtime& runtime, const implicit::Implicit& implicit, const SurfaceEnd& end,
                      const base::Array<Line>& lines, const Spans& spans, base::Array<Root>& roots,
                      base::Array<RootCount>& count, const base::Progress& progress);

} // namespace hrbfnpr::curves
