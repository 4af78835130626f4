// SPDX-License-Identifier: MIT
// Cut faces as they are drawn in sections: lines at 45 degrees inside closed outlines [ISO 128-3].
#pragma once

#include "geometry/vec.h"
#include "picture/memory.h"

#include <array>

namespace hrbfnpr::picture {

using Outline = Vector<glm::dvec2>;
using Segment = std::array<glm::dvec2, 2>;

// Outlines that go round, from parts of them in any order and direction.  Parts that close to nothing are left out.
[[nodiscard]] Vector<Outline> closed_outlines(const Vector<Outline>& parts, Pool& pool);

// Segments of lines that rise to the right, `period` apart, where they are inside.  Inside is what an odd number of
// outlines goes round, so that holes stay empty.  y grows downward.  Outlines that are not finite get no lines.
[[nodiscard]] Vector<Segment> hatched(const Vector<Outline>& outlines, double period, Pool& pool);

} // namespace hrbfnpr::picture
