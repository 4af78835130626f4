// SPDX-License-Identifier: MIT
// Finds the directions of noisy clouds as means of normals and as normals of means of points.
#pragma once

#include "orient/cloud.h"

namespace hrbfnpr::orient {

// Returns for each place a mean of the normals around it. Only normals that point to the same side as the place's own
// are averaged, weighted by a Gaussian of the standard deviation `deviation`.
[[nodiscard]] geometry::VecArray smooth_directions(const base::Work& work, const geometry::PointTree& tree,
                                                   const Near& near, const geometry::VecArray& normal,
                                                   double deviation);

// Averages directions over the width, of 1 to 3 spacings, whose means fit the chords between places two to four
// spacings apart best: a chord is perpendicular to the mean of the two right normals. Directions stay as they are
// unless a width is plainly better. From two spacings on, points of walls then look the way of the face whose
// neighbours they lie nearer to.
void refine_noisy(const base::Work& work, const geometry::PointTree& tree, geometry::VecArray& normal);

// Returns a cloud of means: the points nearest to each of the first `count` places of the farthest-first order become
// one.
[[nodiscard]] Cloud means_of(const base::Work& work, const Cloud& cloud, std::int64_t count);

// Returns unit normals of a cloud's places, from planes through the points around each of them. Points count only if
// the normals of their means are on the same side, and count more the nearer they are and the better these normals
// agree. So the other sheet of a wall and the points around an edge do not count. The centre and spacing of `means` are
// in the cloud's coordinates.
[[nodiscard]] geometry::VecArray normals_by_means(const base::Work& work, const Cloud& cloud, const Cloud& means,
                                                  const geometry::VecArray& normal);

} // namespace hrbfnpr::orient
