// SPDX-License-Identifier: MIT
// Hatches the cut faces of sections: lines at 45 degrees inside closed outlines [ISO 128-3].
#pragma once

#include "geometry/vec.h"
#include "picture/memory.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::picture {

using Outline = Vector<glm::dvec2>;
using Segment = std::array<glm::dvec2, 2>;

// Joins parts of outlines, in any order and direction, into closed outlines. Parts that do not form a closed outline
// are left out.
[[nodiscard]] Vector<Outline> closed_outlines(const Vector<Outline>& parts, Pool& pool);

struct ClosedOutlines {
    Vector<Outline> closed;
    std::int64_t open = 0; // the number of outlines that do not close
};
// Works like closed_outlines(), but joins ends whose distance is at most `share` of the outline's length. With a larger
// share, both skins of a wall become one outline.
[[nodiscard]] ClosedOutlines close_outlines(const Vector<Outline>& parts, double share, Pool& pool);

// Returns segments of hatch lines that rise to the right, `period` apart, clipped to the inside. A place is inside if
// an odd number of outlines surround it, so that holes stay empty. y grows downward. Outlines with a coordinate that is
// not finite get no lines.
[[nodiscard]] Vector<Segment> hatched(const Vector<Outline>& outlines, double period, Pool& pool);

} // namespace hrbfnpr::picture
