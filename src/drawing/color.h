// SPDX-License-Identifier: MIT
// The transfer function of colours, and Oklab. T is float or double.
#pragma once

#include <glm/vec3.hpp>

#include <cmath>

namespace hrbfnpr::drawing {

// Converts between encoded sRGB values and linear light, for colours in [0, 1]. [IEC 61966-2-1]
template <class T>
[[nodiscard]] T to_linear(T encoded) noexcept {
    return encoded <= T(0.04045) ? encoded / T(12.92) : std::pow((encoded + T(0.055)) / T(1.055), T(2.4));
}
template <class T>
[[nodiscard]] T from_linear(T light) noexcept {
    return light <= T(0.0031308) ? light * T(12.92) : T(1.055) * std::pow(light, T(1.0) / T(2.4)) - T(0.055);
}

// Converts linear light to Oklab: lightness, and two axes of hue and chroma on which grey is 0, 0.
// [Ottosson 2020, "A perceptual color space for image processing"]
template <class T>
[[nodiscard]] glm::vec<3, T> oklab_of(const glm::vec<3, T>& c) noexcept {
    const T l = std::cbrt(T(0.4122214708) * c.x + T(0.5363325363) * c.y + T(0.0514459929) * c.z);
    const T m = std::cbrt(T(0.2119034982) * c.x + T(0.6806995451) * c.y + T(0.1073969566) * c.z);
    const T s = std::cbrt(T(0.0883024619) * c.x + T(0.2817188376) * c.y + T(0.6299787005) * c.z);
    return {T(0.2104542553) * l + T(0.7936177850) * m - T(0.0040720468) * s,
            T(1.9779984951) * l - T(2.4285922050) * m + T(0.4505937099) * s,
            T(0.0259040371) * l + T(0.7827717662) * m - T(0.8086757660) * s};
}

} // namespace hrbfnpr::drawing
