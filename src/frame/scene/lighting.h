// SPDX-License-Identifier: MIT
// How light the places of an item are: the sum of its style's lights, the ambient light and the rim light, changed by
// the style's tone law. Dots, hatching, lines and published marks all use these functions.
//
// lighting_of: an item, a camera -> Lighting, which the loops of projection_loops.cpp read
// own_lighting: the same in the space of the item, which bounds need
// light_at: a place -> its tone, for one place
// facing: a normal -> n . l of the key light
// least_light: bounds of many marks -> a lower bound of their tones
#pragma once

#include "frame/scene/projection_loops.h"
#include "frame/scene/style.h"
#include "geometry/vec.h"

#include <array>

namespace hrbfnpr::frame {

// A set's own space, in the unit of its clusters and relative to its origin, as lights need it.
struct LitSpace {
    glm::dmat4 to_world{1.0};
    glm::dmat4 to_eye{1.0};
    glm::dmat4 view{1.0};  // from world space to eye space
    double eye_unit = 1.0; // the unit of eye space, in the caller's
    glm::dvec3 origin{0.0};
    double unit = 1.0;
};

// Returns the lighting with lamps in the space of the style's first light. If the style's tone does not come from
// light, only `facing` may be asked.
[[nodiscard]] Lighting lighting_of(const Style& style, const LitSpace& space);

// Returns the same lighting with lamps in the space of the item. The transforms of `lighting` must keep angles.
[[nodiscard]] Lighting own_lighting(const Lighting& lighting) noexcept;

// The shares of the sky and of each lamp that a place sees, and how the surface bends there, or lower bounds for many
// places.
struct SeenShares {
    float open = 1.0F;
    std::array<float, most_lights> visible{1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F, 1.0F};
    float bend = 0.0F; // -1 in hollows, 1 on ridges
};

// Returns tau of a place, by the same formulas as the loops.
[[nodiscard]] float light_at(const Lighting& lighting, const glm::vec3& place, const glm::vec3& normal, float nu,
                             const SeenShares& seen = {}) noexcept;

// Returns n . l of the key light, for a unit normal. Without lights it is 0.
[[nodiscard]] float facing(const Lighting& lighting, const glm::vec3& place, const glm::vec3& normal) noexcept;

// Bounds for places and normals: a ball, and a cone that is given by the cosine and the sine of its half angle. Both
// are in the space of the item.
struct LitBounds {
    glm::vec3 centre{0.0F};
    float radius = 0.0F;
    glm::vec3 axis{0.0F};
    float cosine = -1.0F, sine = 0.0F;
};

// Returns a lower bound of tau for all places and normals in the bounds. `own` is in the space of the item. `seen` has
// lower bounds.
[[nodiscard]] float least_light(const Lighting& own, const LitBounds& bounds, const SeenShares& seen = {}) noexcept;

// Returns the n . l of the first lamp above which all tones exceed `tau` by at least `rounding`, or infinity if there
// is no such number, or if the lamp is a place.
[[nodiscard]] float lightest_facing(const Lighting& own, float tau, float rounding) noexcept;

} // namespace hrbfnpr::frame
