// SPDX-License-Identifier: MIT
// Sections of a surface with creases: lines of single sheets that follow each other, as one.
#pragma once

#include "curves/surface_lines.h"

namespace hrbfnpr::curves {

// Where one open line ends in the very place where another begins they become one, and closed where its own ends meet.
// A corner stays one: a piece of 2e-4 sides goes around it.
[[nodiscard]] SurfaceLines join_at_corners(base::Memory& memory, const SurfaceLines& lines, double side);

} // namespace hrbfnpr::curves
