// SPDX-License-Identifier: MIT
// Normals of noisy clouds, from as many neighbours as the surface is smooth over.
#pragma once

#include "orient/directions.h"

namespace hrbfnpr::orient {

// Directions are means over 0 to 3 spacings, whichever agrees best with where points two to four spacings away lie: of
// right normals the chord between two places is perpendicular to their mean.  0 unless others are plainly better. Where
// that is two spacings or more, points of walls then look the way of that face whose neighbours they lie nearer to.
void refine_noisy(const base::Runtime& runtime, const geometry::PointTree& tree, geometry::VecArray& normal,
                  const base::Progress& progress);

} // namespace hrbfnpr::orient
