// SPDX-License-Identifier: MIT
// Cuts the marks of a finished set into clusters.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "marks/point_set.h"

namespace hrbfnpr::marks {

// Fills set.unit and the layers' clusters.  Any finite numbers will do.  Bits do not depend on the number of threads.
void cluster_marks(const base::Runtime& runtime, PointSet& set, const base::Progress& progress = {});

} // namespace hrbfnpr::marks
