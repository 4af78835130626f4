// SPDX-License-Identifier: MIT
// Finds the directions of noisy clouds as means of normals and as normals of means of points.
#pragma once

#include "orient/cloud.h"

namespace hrbfnpr::orient {

// Returns for each place a mean of the normals around it. Only normals that point to the same side as the place's own
// are averaged, weighted by a Gaussian of the standard deviation `deviation`.
[[nodiscard]] geometry::VecArray smooth_directions(const base::Work& work, const geometry::PointTree& tree,
                                                   const NeighbourLists& near, const geometry::VecArray& normal,
                                                   double deviation);

// Averages directions over a width of 1 to 3 spacings. It chooses the width whose means fit the chords between places
// two to four spacings apart best, because a chord is perpendicular to the mean of the right normals at its ends.
// Directions stay as they are unless a width is clearly better. From two spacings on, a place of a wall then gets the
// direction of the face whose places are nearer to it.
void refine_noisy(const base::Work& work, const geometry::PointTree& tree, geometry::VecArray& normal);

// Returns a cloud of means. Each of the first `count` places of the farthest-first order becomes the mean of the points
// that are nearest to it.
[[nodiscard]] Cloud means_of(const base::Work& work, const Cloud& cloud, std::int64_t count);

// Returns unit normals of a cloud's places, from planes through the points around each of them. A point counts only if
// the normal of its mean is on the same side. It counts more the nearer it is and the better the normals agree. So the
// other sheet of a wall and the points around an edge do not count. The centre and spacing of `means` are in the
// cloud's coordinates.
[[nodiscard]] geometry::VecArray normals_by_means(const base::Work& work, const Cloud& cloud, const Cloud& means,
                                                  const geometry::VecArray& normal);

} // namespace hrbfnpr::orient
