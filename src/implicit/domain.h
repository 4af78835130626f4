// SPDX-License-Identifier: MIT
// The domain of a surface: the zero level of an implicit may end before its bounds do.
#pragma once

#include "geometry/vec.h"

namespace hrbfnpr::implicit {

// A signed function on the zero level of f. Marks, lines and rays use it. All calls are safe from several threads.
class Domain {
public:
    Domain() = default;
    Domain(const Domain&) = delete;
    Domain& operator=(const Domain&) = delete;
    virtual ~Domain() = default;

    // The surface exists where this is <= 0, and ends where it is 0. The place has f = 0; the gradient need not be
    // unit. This may evaluate the surface, so it may throw whatever that throws.
    [[nodiscard]] virtual double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const = 0;
    // Whether beyond() must be called. If not, the place is on the surface, far from every end.
    [[nodiscard]] virtual bool near_end(const glm::dvec3& /*place*/) const noexcept { return true; }
    [[nodiscard]] bool contains(const glm::dvec3& place, const glm::dvec3& gradient) const {
        return !near_end(place) || beyond(place, gradient) <= 0.0;
    }
    // Whether the surface may end within a cube, given by its centre and half its side.
    [[nodiscard]] virtual bool may_end_near(const glm::dvec3& /*centre*/, double /*half*/) const noexcept {
        return true;
    }
    // Whether no part of the surface is in the cube; false where that is not certain.
    [[nodiscard]] virtual bool has_no_surface_in(const glm::dvec3& /*centre*/, double /*half*/) const noexcept {
        return false;
    }
};

} // namespace hrbfnpr::implicit
