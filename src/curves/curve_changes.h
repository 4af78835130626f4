// SPDX-License-Identifier: MIT
// Changes along curves: cusps of the apparent contour, where the line of sight is tangent to the contour on the surface
// [Koenderink 1984]; the ends of curves where the surface ends; and points added where a curve is too coarse.
#pragma once

#include "curves/curves.h"
#include "implicit/domain.h"

#include <span>

namespace hrbfnpr::curves {

// Adds a point at each place of the contours where v^T H v changes its sign; the image has a cusp there. Adds to
// `evaluations`. The result has the same bits for any number of threads.
[[nodiscard]] Curves with_cusps(const base::Work& work, const Level& contour, const View& view, const Curves& given,
                                std::int64_t& evaluations);

// Halves the marked pieces repeatedly. It stops when, in the image, the distance between the middle of each piece and
// the curve is less than `tolerance`, in pixels. `marked` has one entry for each point; the entry belongs to the piece
// that begins at the point. The cusps of changed curves are found again. Other curves do not change. Adds to
// `evaluations`.
[[nodiscard]] Curves finer_curves(const base::Work& work, const Level& contour, const View& view, const Curves& curves,
                                  std::span<const std::uint8_t> marked, double tolerance, std::int64_t& evaluations);

// Returns the parts of curves that are inside `domain`. They end exactly on its border. The curves are zero lines of
// `level`, and each has a part inside the domain.
[[nodiscard]] Curves clip(const base::Work& work, const Level& level, const implicit::Domain& domain,
                          const Curves& curves);

// The parts of curves where the eye sees the outside of a surface, and those where it sees the inside.
struct FacingParts {
    Curves outside, inside;
};
// Divides curves exactly where the line of sight is tangent to a surface, which is f = 0, or g = 0 with `by_level`.
[[nodiscard]] FacingParts facing_parts(const base::Work& work, const Level& level, const View& view, bool by_level,
                                       const Curves& curves);

} // namespace hrbfnpr::curves
