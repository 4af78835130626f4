// SPDX-License-Identifier: MIT
// Where a surface is: an implicit's zero level may end before its bounds do.
#pragma once

#include "geometry/vec.h"

namespace hrbfnpr::implicit {

// A signed function on the zero level of f. Marks, lines and rays ask it. All calls are safe from several threads.
class Domain {
public:
    Domain() = default;
    Domain(const Domain&) = delete;
    Domain& operator=(const Domain&) = delete;
    virtual ~Domain() = default;

    // <= 0: the surface is there; its end is where this is 0. The place has f = 0, and its gradient need not be unit.
    // It may evaluate the surface, so it may throw what that does.
    [[nodiscard]] virtual double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const = 0;
    // Whether beyond() must be asked. Far from every end a place is there, and a line that runs there does not end.
    [[nodiscard]] virtual bool near_end(const glm::dvec3& /*place*/) const noexcept { return true; }
    [[nodiscard]] bool holds(const glm::dvec3& place, const glm::dvec3& gradient) const {
        return !near_end(place) || beyond(place, gradient) <= 0.0;
    }
    // Whether the surface may end within a cube, given by its centre and half its side.
    [[nodiscard]] virtual bool may_end_near(const glm::dvec3& /*centre*/, double /*half*/) const noexcept {
        return true;
    }
    // Whether none of the surface is in such a cube; false where that is not certain.
    [[nodiscard]] virtual bool is_nowhere_near(const glm::dvec3& /*centre*/, double /*half*/) const noexcept {
        return false;
    }
};

} // namespace hrbfnpr::implicit
