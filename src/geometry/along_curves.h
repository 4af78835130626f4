// SPDX-License-Identifier: MIT
// Points along curves: wires, cross sections, the lines of a scanner.  What is between them is not a hole of a
// surface that was sampled all over.
#pragma once

#include "geometry/point_tree.h"

namespace hrbfnpr::geometry {

// Whether enough points have their nearest others along a line.
[[nodiscard]] bool along_curves(const PointTree& tree);

} // namespace hrbfnpr::geometry
