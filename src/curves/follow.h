// SPDX-License-Identifier: MIT
// Curves from starts on them: predictor and corrector, all in step, until each comes to the next start.
#pragma once

#include "curves/trace.h"

namespace hrbfnpr::curves {

// Adds the curves to those that there are.
void follow(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh,
            const base::Array<CurvePoint>& starts, const TraceSettings& settings, Curves& curves, TraceReport& report,
            const base::Progress& progress);

} // namespace hrbfnpr::curves
