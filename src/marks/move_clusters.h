// SPDX-License-Identifier: MIT
// The clusters of marks that have moved, as those of an animated surface.
#pragma once

#include "marks/point_set.h"

namespace hrbfnpr::marks {

// The same marks in the same clusters, at other places: three floats of each mark, relative to the set's origin.
// `unit` is the set's.  Allocates nothing where `moved` has held as many marks before.
void move_clusters(const Layer& layer, const float* position, const float* normal, double unit, MarkClusters& moved);

} // namespace hrbfnpr::marks
