// SPDX-License-Identifier: MIT
// The parts of curves that lie where the surface is, ended exactly on its border.
#pragma once

#include "curves/curves.h"
#include "curves/surface_end.h"

namespace hrbfnpr::curves {

// `level`: whose zero lines the curves are, each of which passes somewhere where the surface is.
[[nodiscard]] Curves clip(const base::Runtime& runtime, const Level& level, const SurfaceEnd& end, const Curves& curves,
                          const base::Progress& progress);

} // namespace hrbfnpr::curves
