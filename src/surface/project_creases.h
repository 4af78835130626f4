// SPDX-License-Identifier: MIT
// Projection of points for which descent does not converge: onto the sheets that meet at a crease.
#pragma once

#include "surface/project.h"

namespace hrbfnpr::surface {

// Projects the points that have not converged, starting from their last iterates. Newton's steps go to the zero set of
// the active sheet. If another sheet is active after a step, the next steps go to the zero sets of both sheets; a third
// sheet is handled in the same way. Points that do not reach the surface are not changed. The implicit function must
// have sheets.
void project_onto_creases(const base::Work& work, const implicit::Implicit& implicit,
                          const ProjectionSettings& settings, Projection& points);

} // namespace hrbfnpr::surface
