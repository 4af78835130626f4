// SPDX-License-Identifier: MIT
// Projection where neither descent nor creases come to an end: a search around the place for where f changes its sign.
#pragma once

#include "surface/project.h"

namespace hrbfnpr::surface {

// Of the points that have not converged, or ended where f is flat: from their last iterates, on spheres that grow, up
// to the end of the search region; then by halving.  Those around which f changes its sign nowhere stay as they are.
// For implicits that have local minima of |f| off the surface by their making: minima and maxima of parts.
void project_by_search(const base::Work& work, const implicit::Implicit& implicit, const ProjectionSettings& settings,
                       Projection& points);

} // namespace hrbfnpr::surface
