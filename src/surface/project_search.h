// SPDX-License-Identifier: MIT
// Projection of points for which neither descent nor the projection onto creases converges: it searches around the
// point for a change of sign of f.
#pragma once

#include "surface/project.h"

namespace hrbfnpr::surface {

// Projects the points that have not converged, or that ended where f is flat. From the last iterate it searches growing
// spheres, up to the end of the search region, for a point where f has the other sign. Then it bisects. Points without
// a change of sign around them are not changed. It is for implicit functions that can have local minima of |f| off the
// surface: minima and maxima of several functions.
void project_by_search(const base::Work& work, const implicit::Implicit& implicit, const ProjectionSettings& settings,
                       Projection& points);

} // namespace hrbfnpr::surface
