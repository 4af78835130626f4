// SPDX-License-Identifier: MIT
// Where a surface ends before its bounds do.
#pragma once

#include "geometry/vec.h"

namespace hrbfnpr::implicit {

class Extent {
public:
    Extent() = default;
    Extent(const Extent&) = delete;
    Extent& operator=(const Extent&) = delete;
    virtual ~Extent() = default;

    // Whether the surface is there, asked for a place on f = 0 and its gradient, which need not be unit.  For any
    // number of threads.
    [[nodiscard]] virtual bool holds(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept = 0;
    // Whether it may end within a cube around a place, of so long a half side.
    [[nodiscard]] virtual bool may_end_near(const glm::dvec3& place, double half) const noexcept = 0;
    // Whether it is surely nowhere within such a cube.
    [[nodiscard]] virtual bool is_nowhere_near(const glm::dvec3& /*place*/, double /*half*/) const noexcept {
        return false;
    }
};

} // namespace hrbfnpr::implicit
