// SPDX-License-Identifier: MIT
// Finds normals of noisy clouds in two ways: as means of normals, and as normals of means of points.
#pragma once

#include "orient/cloud.h"

namespace hrbfnpr::orient {

// Returns for each place a mean of the normals around it. It averages only normals on the same side as the place's
// normal, weighted by a Gaussian with the standard deviation `deviation`.
[[nodiscard]] geometry::VecArray smooth_directions(const base::Work& work, const geometry::PointTree& tree,
                                                   const NeighbourLists& near, const geometry::VecArray& normal,
                                                   double deviation);

// Replaces each direction by a mean over its neighbourhood. The best width of the mean, from 1 to 3 spacings, is found
// by chords between places: a chord is perpendicular to the mean of the correct normals at its ends. The best width is
// the one whose means fit chords of two to four spacings best. If no width is clearly better than no averaging, the
// directions are not changed. If the width is two spacings or more, a place of a wall then gets the direction of the
// nearer face.
void refine_noisy(const base::Work& work, const geometry::PointTree& tree, geometry::VecArray& normal);

// Returns a cloud of means. Each of the first `count` places of the farthest-first order becomes the mean of the points
// that are nearest to it.
[[nodiscard]] Cloud means_of(const base::Work& work, const Cloud& cloud, std::int64_t count);

// Returns unit normals for the places of a cloud, from planes through the points around each place. A point is used
// only if the normal of its mean is on the same side. It weighs more the nearer it is and the better the normals agree,
// so points beyond a wall or an edge do not count. The centre and spacing of `means` are in the coordinates of the
// cloud.
[[nodiscard]] geometry::VecArray normals_by_means(const base::Work& work, const Cloud& cloud, const Cloud& means,
                                                  const geometry::VecArray& normal);

} // namespace hrbfnpr::orient
