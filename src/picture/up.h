// SPDX-License-Identifier: MIT
// Finds which direction is up: the caller's choice, the convention of the file format, the shape where it is clear, or
// else y.
#pragma once

#include "picture/call.h"
#include "picture/shape.h"

namespace hrbfnpr::picture {

struct FoundUp {
    glm::dvec3 direction;
    String reason; // The text that follows "up is z: " in a note.
};

// Finds the up direction from the samples of a surface and the data of its file. `shape` may be null. `normals` has one
// for each point.
[[nodiscard]] FoundUp find_up(const Shape* shape, const Points& points, const Points& normals, Pool& pool);

// Returns the direction that the options give, or else the direction that find_up() returns. Reports a found direction
// other than y in a note. For a part of a solid the result is y.
[[nodiscard]] glm::dvec3 choose_up(const Call& call, const Shape* shape, const Points& points, const Points& normals);

// Returns the name of an axis such as "x" or "-x", or three numbers with commas between them.
[[nodiscard]] String name_of_direction(const glm::dvec3& direction, Pool& pool);

// Returns the axis, 'z' or 'y', along which a terrain faces down. Returns 0 if it does not, or if there is no terrain.
[[nodiscard]] char hangs_along(const Points& points, const Points& normals) noexcept;

} // namespace hrbfnpr::picture
