// SPDX-License-Identifier: MIT
// Which direction is up: as the caller says, by the format's convention, by the shape where that is clear, else y.
#pragma once

#include "picture/call.h"
#include "picture/shape.h"

namespace hrbfnpr::picture {

struct FoundUp {
    glm::dvec3 direction;
    String reason; // it follows "up is z: " in a note
};

// Finds the direction from the samples of a surface, and from what its file tells.  shape: nullable.  `normals` are as
// many as the points.
[[nodiscard]] FoundUp find_up(const Shape* shape, const Points& points, const Points& normals, Pool& pool);

// The direction that the options give, or the one that is found, with a note where that is not y.  A part of a solid
// has y.
[[nodiscard]] glm::dvec3 choose_up(const Call& call, const Shape* shape, const Points& points, const Points& normals);

// "x", "-x", ... of an axis, else the three numbers with commas between.
[[nodiscard]] String name_of_direction(const glm::dvec3& direction, Pool& pool);

// The axis, 'z' or 'y', along which a terrain looks down; 0 if it does not, or is none.
[[nodiscard]] char hangs_along(const Points& points, const Points& normals) noexcept;

} // namespace hrbfnpr::picture
