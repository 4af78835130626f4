// SPDX-License-Identifier: MIT
// The transfer function of colours.
#pragma once

#include <cmath>

namespace hrbfnpr::drawing {

// Converts between encoded sRGB values and linear light, for colours in [0, 1]. [IEC 61966-2-1]
[[nodiscard]] inline float to_linear(float encoded) noexcept {
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}
[[nodiscard]] inline float from_linear(float light) noexcept {
    return light <= 0.0031308F ? light * 12.92F : 1.055F * std::pow(light, 1.0F / 2.4F) - 0.055F;
}

} // namespace hrbfnpr::drawing
