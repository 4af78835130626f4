// SPDX-License-Identifier: MIT
// What is near to what, for an order: cells around a place, and ways along a surface that has creases.
#pragma once

#include "marks/site.h"
#include "stipples/order_loops.h"

#include <algorithm>
#include <cstdint>

namespace hrbfnpr::stipples {

// Which of the 27 around a cell have a point that is nearer than that to one of the cell's.
inline std::uint32_t reached(const glm::vec3& in_cell, float side, float distance) noexcept {
    float squared[3][3];
    for (int axis = 0; axis < 3; ++axis) {
        const float low = std::max(in_cell[axis], 0.0F);
        const float high = std::max(side - in_cell[axis], 0.0F);
        squared[axis][0] = low * low;
        squared[axis][1] = 0.0F;
        squared[axis][2] = high * high;
    }
    std::uint32_t found = 0;
    unsigned step = 0;
    for (const float z : squared[2])
        for (const float y : squared[1])
            for (const float x : squared[0]) found |= (x + y + z < distance * distance ? 1U : 0U) << step++;
    return found;
}

[[nodiscard]] inline OrderLoops loops_for(const marks::Site& site) noexcept {
    OrderLoops loops = order_loops(site.runtime.instruction_set);
    if (site.implicit.sheets() == nullptr) return loops;
    loops.feel = loops.feel_on_surface;
    loops.feel_and_find = loops.feel_and_find_on_surface;
    return loops;
}

// Of the way from a place with the unit normal n to another one, o away, with the normal m: over the crease between
// them, through both tangent planes.
[[nodiscard]] inline double squared_way(const glm::dvec3& o, const glm::dvec3& n, const glm::dvec3& m) noexcept {
    const double detour = -2.0 * glm::dot(o, n) * glm::dot(o, m) / std::max(1.0 + glm::dot(n, m), 0.1);
    return glm::dot(o, o) + std::max(detour, 0.0);
}

} // namespace hrbfnpr::stipples
