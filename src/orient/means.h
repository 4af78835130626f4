// SPDX-License-Identifier: MIT
// Clouds with much noise: means of their points take their place, and give them normals.
#pragma once

#include "orient/cloud.h"

namespace hrbfnpr::orient {

// The points nearest to each of the first places of the farthest-first order become their mean.
[[nodiscard]] Cloud means_of(const base::Runtime& runtime, const Cloud& cloud, std::int64_t count,
                             const base::Progress& progress);

// Unit normals of the places of a cloud: of the planes through the points around each of them.  Counted are those whose
// means, at `centre` and by `spacing` in the cloud's coordinates, have normals on the same side, the more the nearer
// they are and the better these agree: neither the other sheet of a wall, nor what lies around an edge.
[[nodiscard]] geometry::VecArray normals_by_means(const base::Runtime& runtime, const Cloud& cloud, const Cloud& means,
                                                  const geometry::VecArray& normal, const base::Progress& progress);

} // namespace hrbfnpr::orient
