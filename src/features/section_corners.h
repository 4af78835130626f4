// SPDX-License-Identifier: MIT
// Where plane sections cross creases: their lines, one for each sheet, end there in the same places.
#pragma once

#include "creases/creases.h"

#include <span>

namespace hrbfnpr::curves {

// Sections of a mesh that is cut at creases.  Ends of lines that are nearer than a side come to the place where both
// sheets and the plane are 0.
void end_at_creases(const base::Runtime& runtime, const implicit::Sheets& sheets, const Creases& creases,
                    const glm::dvec3& plane, std::span<const double> levels, double side, FeatureLines& lines);

} // namespace hrbfnpr::curves
