// SPDX-License-Identifier: MIT
// Finds the up direction: the caller's choice, the convention of the file format, a clear shape, or else y.
#pragma once

#include "picture/call.h"
#include "picture/shape.h"

namespace hrbfnpr::picture {

struct FoundUp {
    glm::dvec3 direction;
    String reason; // The text that follows "up is z: " in a note.
};

// Finds the up direction from the samples of a surface and the data of its file. `shape` may be null. Each point has a
// normal.
[[nodiscard]] FoundUp find_up(const Shape* shape, const Points& points, const Points& normals, Pool& pool);

// Returns the up direction of the options. If they give none, finds it by find_up(), and reports any direction other
// than y in a note. For a part of a solid it returns y.
[[nodiscard]] glm::dvec3 choose_up(const Call& call, const Shape* shape, const Points& points, const Points& normals);

// Returns the name of an axis, such as "x" or "-x", or else three numbers separated by commas.
[[nodiscard]] String name_of_direction(const glm::dvec3& direction, Pool& pool);

// Returns the axis, 'z' or 'y', along which a terrain faces down. Returns 0 if no terrain faces down.
[[nodiscard]] char hangs_along(const Points& points, const Points& normals) noexcept;

} // namespace hrbfnpr::picture
