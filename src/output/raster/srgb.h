// SPDX-License-Identifier: MIT
// Between encoded sRGB values and linear light, for colours in [0, 1].       [IEC 61966-2-1]
#pragma once

#include "geometry/vec.h"

#include <cmath>

namespace hrbfnpr::output {

[[nodiscard]] inline float to_linear(float encoded) noexcept {
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}
[[nodiscard]] inline float from_linear(float light) noexcept {
    return light <= 0.0031308F ? light * 12.92F : 1.055F * std::pow(light, 1.0F / 2.4F) - 0.055F;
}

// Premultiplied colours, whose alpha stays.
[[nodiscard]] inline glm::vec4 to_linear(const glm::vec4& c) noexcept {
    if (!(c.w > 0.0F)) return glm::vec4(0.0F);
    return {to_linear(c.x / c.w) * c.w, to_linear(c.y / c.w) * c.w, to_linear(c.z / c.w) * c.w, c.w};
}
[[nodiscard]] inline glm::vec4 from_linear(const glm::vec4& c) noexcept {
    if (!(c.w > 0.0F)) return glm::vec4(0.0F);
    return {from_linear(c.x / c.w) * c.w, from_linear(c.y / c.w) * c.w, from_linear(c.z / c.w) * c.w, c.w};
}

} // namespace hrbfnpr::output
