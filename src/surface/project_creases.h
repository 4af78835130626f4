// SPDX-License-Identifier: MIT
// Projection where descent does not come to an end: on the sheets that meet at a crease.
#pragma once

#include "surface/project.h"

namespace hrbfnpr::surface {

// Of the points that have not converged: from their last iterates, by Newton's steps on the active sheet and, where
// another one is active after a step, on both and on a third one.  Those that do not come onto the surface by it stay
// as they are.  For implicits that have sheets.
void project_onto_creases(const base::Work& work, const implicit::Implicit& implicit,
                          const ProjectionSettings& settings, Projection& points);

} // namespace hrbfnpr::surface
