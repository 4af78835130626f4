// SPDX-License-Identifier: MIT
// Window coordinates: pixels from the picture's top-left corner, and depth in the camera's convention.
#pragma once

#include "geometry/vec.h"

#include <cstdint>

namespace hrbfnpr::drawing {

// The numbers are those of the constants HRBFNPR_DEPTH.
enum class DepthConvention : std::uint32_t { negative_one_to_one = 0, zero_to_one = 1, reversed = 2 };

// Window depth of the far plane, which empty pixels have.
[[nodiscard]] constexpr float far_depth(DepthConvention depth) noexcept {
    return depth == DepthConvention::reversed ? 0.0F : 1.0F;
}
// Whether window depth a lies in front of b.  False if one of them is not a number.
[[nodiscard]] constexpr bool nearer(float a, float b, DepthConvention depth) noexcept {
    return depth == DepthConvention::reversed ? a > b : a < b;
}

struct Window {
    glm::dvec4 viewport{0.0}; // x, y of the top-left corner, width, height, pixels
    DepthConvention depth = DepthConvention::negative_one_to_one;
};

} // namespace hrbfnpr::drawing
