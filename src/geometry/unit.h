// SPDX-License-Identifier: MIT
// The unit of length in which very small and very large things are worked on.
#pragma once

#include <cmath>

namespace hrbfnpr::geometry {

// 1 for what is about as large as a float's squares and cubes allow.  For others the power of two in which `size`
// measures 2 to 4: multiplying by it is exact, so that the scale of a model leaves no trace in its marks.
[[nodiscard]] inline double unit_for(double size) noexcept {
    constexpr int ordinary = 30; // powers of two: 1e-9 .. 1e9
    if (!(size > 0.0) || !std::isfinite(size)) return 1.0;
    const int power = std::ilogb(size);
    return power >= -ordinary && power <= ordinary ? 1.0 : std::ldexp(1.0, power - 1);
}

} // namespace hrbfnpr::geometry
