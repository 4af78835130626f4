// SPDX-License-Identifier: MIT
// The marks of a finished set in clusters and pieces of strokes, which a frame passes over whole.
//   cluster_marks: a set's layers -> their clusters, pieces and gaps
//   move_clusters, turn_clusters: the clusters of a layer -> those of an item that moves it, or shows its other side
#pragma once

#include "base/runtime.h"
#include "marks/point_set.h"

namespace hrbfnpr::marks {

// Fills set.unit and the layers' clusters. Any finite numbers will do. Bits do not depend on the number of threads.
void cluster_marks(const base::Runtime& runtime, PointSet& set, const base::Progress& progress = {});

// The same marks in the same clusters at other places, as those of an animated surface: three floats of each mark,
// relative to the set's origin. `unit` is the set's. Allocates nothing where `moved` has held as many marks before.
void move_clusters(const Layer& layer, const float* position, const float* normal, double unit, MarkClusters& moved);

// The same marks in the same clusters with opposite normals. Allocates nothing where `turned` has held as many before.
void turn_clusters(const MarkClusters& clusters, MarkClusters& turned);

// Fills the gap of each of the layer's marks, in separations: the distance between the lines around it, averaged over
// some of them and along its own. A layer without lines of a known separation gets none.
void measure_gaps(const base::Runtime& runtime, const Layer& layer, base::Array<float>& gap,
                  const base::Progress& progress);

} // namespace hrbfnpr::marks
