// SPDX-License-Identifier: MIT
// Places of curves at which something changes: cusps of the apparent contour, where the line of sight is tangent to the
// contour on the surface [Koenderink 1984]; ends, where the surface ends; and points that a curve wants in between.
#pragma once

#include "curves/curves.h"
#include "implicit/domain.h"

#include <span>

namespace hrbfnpr::curves {

// Puts a point at each place of the contours where v^T H v changes its sign: there the image turns back.
// Adds to `evaluations`.  The same bits for any thread count.
[[nodiscard]] Curves with_cusps(const base::Work& work, const Level& contour, const View& view, const Curves& given,
                                std::int64_t& evaluations);

// Halves the pieces that are marked (one mark for each point, for the piece that begins there) until the image of each
// half's middle is off the curve by less than the tolerance, in pixels; and looks for the cusps of curves that have a
// mark anew. Curves without a mark stay. Adds to `evaluations`.
[[nodiscard]] Curves finer_curves(const base::Work& work, const Level& contour, const View& view, const Curves& curves,
                                  std::span<const std::uint8_t> marked, double tolerance, std::int64_t& evaluations);

// The parts of curves that lie where the surface is, ended exactly on its border. The curves are zero lines of `level`;
// each passes somewhere where the surface is.
[[nodiscard]] Curves clip(const base::Work& work, const Level& level, const implicit::Domain& domain,
                          const Curves& curves);

} // namespace hrbfnpr::curves
