// SPDX-License-Identifier: MIT
// Projection of points for which neither descent nor creases converge: a search around the point for a change of sign
// of f.
#pragma once

#include "surface/project.h"

namespace hrbfnpr::surface {

// Projects the points that have not converged, or that ended where f is flat. From the last iterate it searches growing
// spheres, up to the end of the search region, for a point where f has the other sign, then bisects. Points that it
// finds no change of sign around stay as they are. It serves implicits that can have local minima of |f| off the
// surface: minima and maxima of parts.
void project_by_search(const base::Work& work, const implicit::Implicit& implicit, const ProjectionSettings& settings,
                       Projection& points);

} // namespace hrbfnpr::surface
