// Cuts the marks of a finished set into clusters.
#pragma once

#include "base/runtime.h"
#include "sampling/point_set.h"

namespace hrbfnpr::sampling {

// Fills set.clusters from set.group.  Bits do not depend on the number of threads.
void cluster_marks(const base::Runtime& runtime, PointSet& set);

} // namespace hrbfnpr::sampling
