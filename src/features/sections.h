// SPDX-License-Identifier: MIT
// Plane sections of a surface with creases. The mesh ends at creases, so a section is found as one line for each sheet
// that it passes: these end in the same places, and become one line there.
#pragma once

#include "creases/creases.h"
#include "features/feature_lines.h"

#include <span>

namespace hrbfnpr::curves {

// The sections of a mesh that is cut at creases, with ends of lines moved to where both sheets of a crease and the
// plane are 0, and joined there. A corner between two lines stays one. side: of the mesh's cells.
[[nodiscard]] SurfaceLines joined_sections(const base::Runtime& runtime, const implicit::Sheets& sheets,
                                           const Creases& creases, const glm::dvec3& plane,
                                           std::span<const double> levels, double side, FeatureLines& sections);

} // namespace hrbfnpr::curves
