// SPDX-License-Identifier: MIT
// Changes along curves: cusps of the apparent contour, where the line of sight is tangent to the contour on the surface
// [Koenderink 1984]; ends, where the surface ends; and points added where a curve is too coarse.
#pragma once

#include "curves/curves.h"
#include "implicit/domain.h"

#include <span>

namespace hrbfnpr::curves {

// Adds a point at each place of the contours where v^T H v changes its sign: there the image has a cusp. Adds to
// `evaluations`. The same bits for any thread count.
[[nodiscard]] Curves with_cusps(const base::Work& work, const Level& contour, const View& view, const Curves& given,
                                std::int64_t& evaluations);

// Halves the marked pieces, and their halves, until the middle of a piece's cubic is off the curve by less than the
// tolerance in the image, in pixels. marked: one entry for each point, for the piece that begins there. Finds the cusps
// of curves with a mark again; other curves do not change. Adds to `evaluations`.
[[nodiscard]] Curves finer_curves(const base::Work& work, const Level& contour, const View& view, const Curves& curves,
                                  std::span<const std::uint8_t> marked, double tolerance, std::int64_t& evaluations);

// The parts of curves within `domain`, which end exactly on its border. The curves are zero lines of `level`, and each
// has a part within the domain.
[[nodiscard]] Curves clip(const base::Work& work, const Level& level, const implicit::Domain& domain,
                          const Curves& curves);

} // namespace hrbfnpr::curves
