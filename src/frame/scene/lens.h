// SPDX-License-Identifier: MIT
// What a frame needs of the camera, combined once in double and used in float.
#pragma once

#include "frame/scene/camera.h"

namespace hrbfnpr::frame {

struct Lens {
    glm::mat4 window{1.0F};   // eye to (x w, y w, depth w, w): pixels and window depth
    glm::vec4 centre{0.0F};   // where the lines of sight come from (w = 1), or their direction (w = 0), eye space
    glm::vec4 viewport{0.0F}; // x, y, width, height
    float pixels = 0.0F;      // per eye unit where w is 1
    float eye_per_world = 1.0F;
    float diagonal = 0.0F; // of the viewport, pixels

    // v of [NPAR 6]: from the camera to a point, not normalised.
    [[nodiscard]] glm::vec3 sight(const glm::vec3& eye) const noexcept {
        return centre.w == 0.0F ? glm::vec3(centre) : eye - glm::vec3(centre);
    }
};

// The same in double: for curves.
struct Optics {
    glm::dmat4 window{1.0}; // eye to (x w, y w, depth w, w)
    glm::dvec4 centre{0.0}; // as Lens::centre
};
[[nodiscard]] Optics make_optics(const Camera& camera);

// Throws Error{invalid_argument} for a camera that cannot be drawn with.
void check(const Camera& camera);
// Of a checked camera; its projection may still be singular.
[[nodiscard]] Lens make_lens(const Camera& camera);

// The side of a cube of the same volume after the transform.
[[nodiscard]] double mean_scale(const glm::dmat4& transform) noexcept;

} // namespace hrbfnpr::frame
