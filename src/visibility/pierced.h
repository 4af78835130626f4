// SPDX-License-Identifier: MIT
// Where lines of one item pass through the surface of another: that one lies before the line on one side of the place
// and behind it on the other.
#pragma once

#include "base/operation.h"
#include "visibility/image_lines.h"

#include <limits>

namespace hrbfnpr::visibility {

struct Pierced {
    std::int32_t piece;  // of the line
    double share;        // along the piece, in [0, 1]
    std::int32_t item;   // whose surface it is, among the occluders
    std::int32_t change; // of the number of sheets before the line, along it: one
};

// What stands in Event::near_piece for such a place: the number of no piece.
inline constexpr std::int32_t no_line = std::numeric_limits<std::int32_t>::max();

// Of all lines with all surfaces but their own, on the lines' cubics.  Between two places where f and its slope along
// the line are known f is taken for a cubic; where that has a root it is looked at.  Sorted by piece and share.
[[nodiscard]] base::Array<Pierced> find_pierced(const base::Runtime& runtime, std::span<const Subject> subjects,
                                                std::span<const Occluder> occluders, const ImageLines& lines,
                                                const base::Progress& progress);

} // namespace hrbfnpr::visibility
