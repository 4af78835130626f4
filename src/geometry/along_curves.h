// SPDX-License-Identifier: MIT
// Detects points along curves: wires, cross sections, the scan lines of a scanner. The gaps between such curves are not
// holes of a surface that was sampled all over.
#pragma once

#include "geometry/point_tree.h"

namespace hrbfnpr::geometry {

// Returns whether enough points have nearest neighbours along a line.
[[nodiscard]] bool lie_along_curves(const PointTree& tree);

} // namespace hrbfnpr::geometry
