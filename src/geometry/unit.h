// SPDX-License-Identifier: MIT
// The unit of length in which very small and very large models are processed.
#pragma once

#include <cmath>

namespace hrbfnpr::geometry {

// Returns 1 for sizes whose squares and cubes a float can hold. For other sizes it returns the power of two between a
// quarter and a half of `size`. Scaling by a power of two is exact, so the scale of a model does not change its marks.
[[nodiscard]] inline double unit_for(double size) noexcept {
    // Sizes from 2^-30 to 2^30, about 1e-9 to 1e9, need no other unit.
    constexpr int ordinary = 30;
    if (!(size > 0.0) || !std::isfinite(size)) return 1.0;
    const int power = std::ilogb(size);
    return power >= -ordinary && power <= ordinary ? 1.0 : std::ldexp(1.0, power - 1);
}

} // namespace hrbfnpr::geometry
