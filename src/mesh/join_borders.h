// SPDX-License-Identifier: MIT
// Borders that are meant to be one line, and are not by rounding.
#pragma once

#include "mesh/mesh.h"

namespace hrbfnpr::mesh {

// Joins vertices of borders that are no farther than `near` from each other, and renumbers those that are left.  Faces
// may have corners in common then.
void join_borders(const base::Runtime& runtime, base::Array<glm::dvec3>& vertex, base::Array<Triangle>& triangle,
                  double near, const base::Progress& progress);

} // namespace hrbfnpr::mesh
