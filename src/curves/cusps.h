// SPDX-License-Identifier: MIT
// Cusps of the apparent contour: where the line of sight is tangent to the contour on the surface.  [Koenderink 1984]
#pragma once

#include "curves/curves.h"
#include "curves/view.h"

namespace hrbfnpr::curves {

// Puts a point at each place of the contours where v^T H v changes its sign: there the image turns back.
// Adds up evaluations.  The same bits for any thread count.
[[nodiscard]] Curves with_cusps(const base::Runtime& runtime, const Level& contour, const View& view,
                                const Curves& given, std::int64_t& evaluations, const base::Progress& progress);

} // namespace hrbfnpr::curves
