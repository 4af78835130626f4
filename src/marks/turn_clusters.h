// SPDX-License-Identifier: MIT
// The clusters of marks that look the other way.
#pragma once

#include "marks/mark_clusters.h"

namespace hrbfnpr::marks {

// The same marks in the same clusters with opposite normals.  Allocates nothing where `turned` has held as many before.
void turn_clusters(const MarkClusters& clusters, MarkClusters& turned);

} // namespace hrbfnpr::marks
