// SPDX-License-Identifier: MIT
// The domain of a surface says where the surface ends. It may end inside the bounds of the implicit function.
#pragma once

#include "geometry/vec.h"

namespace hrbfnpr::implicit {

// A signed function on the zero set of f, which says where the surface ends. Marks, lines and rays use it. All calls
// are thread-safe.
class Domain {
public:
    Domain() = default;
    Domain(const Domain&) = delete;
    Domain& operator=(const Domain&) = delete;
    virtual ~Domain() = default;

    // Returns a number that is negative or 0 on the surface, 0 at its end, and positive beyond the end. At `place` f is
    // 0; the gradient may have any length. The function may evaluate the implicit function, and then it throws the same
    // errors as Implicit::evaluate().
    [[nodiscard]] virtual double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const = 0;
    // Returns whether beyond() must be called for a place with f = 0. If false, the place is on the surface and far
    // from its ends.
    [[nodiscard]] virtual bool near_end(const glm::dvec3& /*place*/) const noexcept { return true; }
    [[nodiscard]] bool contains(const glm::dvec3& place, const glm::dvec3& gradient) const {
        return !near_end(place) || beyond(place, gradient) <= 0.0;
    }
    // Returns whether the surface may end in a cube, given by its centre and half its side.
    [[nodiscard]] virtual bool may_end_near(const glm::dvec3& /*centre*/, double /*half*/) const noexcept {
        return true;
    }
    // Returns true only if it is certain that a cube contains no part of the surface.
    [[nodiscard]] virtual bool has_no_surface_in(const glm::dvec3& /*centre*/, double /*half*/) const noexcept {
        return false;
    }
};

} // namespace hrbfnpr::implicit
