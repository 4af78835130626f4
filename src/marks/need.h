// SPDX-License-Identifier: MIT
// The marks on a surface that a drawing needs. A still picture shows only some of the marks that a set for all
// cameras has: those on the side that faces the camera, inside the picture, and dark enough.
#pragma once

#include "geometry/vec.h"

namespace hrbfnpr::marks {

class Need {
public:
    virtual ~Need() = default;

    // Returns false if the drawing certainly needs no mark within `reach` of a place. The normals there may differ from
    // `normal` by up to 20 degrees.
    [[nodiscard]] virtual bool may_show(const glm::dvec3& place, const glm::dvec3& normal,
                                        double reach) const noexcept = 0;
    // Returns an upper bound for the share of a progressive order that the drawing needs at a place: 0 is no mark, 1 is
    // all marks. `spacing` is the square root of the area of surface for each mark of the whole order. `normal` is that
    // of the marks, to within 8 degrees.
    [[nodiscard]] virtual double share(const glm::dvec3& place, const glm::dvec3& normal,
                                       double spacing) const noexcept = 0;

protected:
    Need() = default;
    Need(const Need&) = default;
    Need& operator=(const Need&) = default;
};

} // namespace hrbfnpr::marks
