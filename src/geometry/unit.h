// SPDX-License-Identifier: MIT
// The unit of length in which very small and very large models are processed.
#pragma once

#include <cmath>

namespace hrbfnpr::geometry {

// Returns 1 for sizes whose squares and cubes a float can hold. For others it returns the power of two that is a half
// to a quarter of `size`. Scaling by it is exact, so the scale of a model leaves no trace in its marks.
[[nodiscard]] inline double unit_for(double size) noexcept {
    constexpr int ordinary = 30; // powers of two: 1e-9 .. 1e9
    if (!(size > 0.0) || !std::isfinite(size)) return 1.0;
    const int power = std::ilogb(size);
    return power >= -ordinary && power <= ordinary ? 1.0 : std::ldexp(1.0, power - 1);
}

} // namespace hrbfnpr::geometry
