// SPDX-License-Identifier: MIT
// The camera as curves see it: in the surface's own coordinates.
#pragma once

#include "geometry/vec.h"

namespace hrbfnpr::curves {

struct View {
    glm::dvec4 eye{0.0, 0.0, 0.0, 1.0}; // w = 1: where the eye is; w = 0: the direction in which it looks
    glm::dmat4 to_window{1.0};          // to (x w, y w, depth w, w), pixels

    // From the eye to a point, not normalised.
    [[nodiscard]] glm::dvec3 sight(const glm::dvec3& p) const noexcept {
        return eye.w == 0.0 ? glm::dvec3(eye) : p - glm::dvec3(eye);
    }
};

} // namespace hrbfnpr::curves
