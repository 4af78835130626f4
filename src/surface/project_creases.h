// SPDX-License-Identifier: MIT
// Projection of points for which descent does not converge: onto the sheets that meet at a crease.
#pragma once

#include "surface/project.h"

namespace hrbfnpr::surface {

// Projects the points that have not converged, from their last iterates. Newton's steps go to the zero level of the
// active sheet. If another sheet is active after a step, they go to the zero levels of both, and of a third sheet
// likewise. Points that do not reach the surface stay as they are. The implicit must have sheets.
void project_onto_creases(const base::Work& work, const implicit::Implicit& implicit,
                          const ProjectionSettings& settings, Projection& points);

} // namespace hrbfnpr::surface
