// SPDX-License-Identifier: MIT
// Directions of noisy clouds: means of normals, and means of points.
#pragma once

#include "orient/cloud.h"

namespace hrbfnpr::orient {

// Returns means of the normals around each place that point the same way, by a Gaussian of this deviation.
[[nodiscard]] geometry::VecArray smooth_directions(const base::Work& work, const geometry::PointTree& tree,
                                                   const Near& near, const geometry::VecArray& normal,
                                                   double deviation);

// Makes directions means over that width, from 0 to 3 spacings, which agrees best with where points two to four
// spacings away lie: the chord between two places is perpendicular to the mean of their right normals. The width is 0
// unless others are plainly better. From two spacings on, points of walls then look the way of the face whose
// neighbours they lie nearer to.
void refine_noisy(const base::Work& work, const geometry::PointTree& tree, geometry::VecArray& normal);

// Returns a cloud of means: the points nearest to each of the first places of the farthest-first order become one.
[[nodiscard]] Cloud means_of(const base::Work& work, const Cloud& cloud, std::int64_t count);

// Returns unit normals of a cloud's places: those of the planes through the points around each of them. Points count
// only if their means have normals on the same side, the more the nearer they are and the better these agree: neither
// the other sheet of a wall nor the points around an edge do. The means stand in the cloud's coordinates at their
// centre, by their spacing.
[[nodiscard]] geometry::VecArray normals_by_means(const base::Work& work, const Cloud& cloud, const Cloud& means,
                                                  const geometry::VecArray& normal);

} // namespace hrbfnpr::orient
