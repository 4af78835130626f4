// SPDX-License-Identifier: MIT
// Curves whose cubics are nearer to them, where that is asked for.
#pragma once

#include "curves/curves.h"
#include "curves/view.h"

#include <span>

namespace hrbfnpr::curves {

// Halves the pieces that are marked (one mark for each point: of the piece that begins there) until the image of each
// half's middle is off the curve by less than the tolerance, pixels; and looks for the cusps of curves that have a mark
// anew.  What is not marked stays.  Adds up evaluations.
[[nodiscard]] Curves finer_curves(const base::Runtime& runtime, const Level& contour, const View& view,
                                  const Curves& curves, std::span<const std::uint8_t> marked, double tolerance,
                                  std::int64_t& evaluations, const base::Progress& progress);

} // namespace hrbfnpr::curves
