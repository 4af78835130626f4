// SPDX-License-Identifier: MIT
// Curves from runs of points on them: predictor and corrector from their ends, all in step, until each comes to where a
// run begins.
#pragma once

#include "curves/trace.h"

namespace hrbfnpr::curves {

// Adds the curves to those that there are.
void follow(const base::Runtime& runtime, const Level& level, const SurfaceMesh& mesh, const Curves& runs,
            const TraceSettings& settings, Curves& curves, TraceReport& report, const base::Progress& progress);

} // namespace hrbfnpr::curves
