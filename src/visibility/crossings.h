// SPDX-License-Identifier: MIT
// Where the number of sheets before a line may change: crossings of the images of two curves, with the nearer one, and
// places where a line of one item passes through the surface of another.
#pragma once

#include "base/operation.h"
#include "visibility/image_lines.h"

namespace hrbfnpr::visibility {

struct Crossing {
    std::int32_t far_piece, near_piece;
    double far_share, near_share; // along the pieces, in [0, 1]
    std::int32_t change;          // how the number of sheets before the farther line changes as one goes along it
    glm::dvec2 place;             // pixels
    double gap;                   // the distance between the curves in space, in sides of one curve's mesh
    double sine;                  // the sine of the angle between their images
};

struct CrossingReport {
    std::int64_t of_polylines = 0; // crossings of segments
    std::int64_t rejected = 0;     // those of these that the curves do not have
    std::int64_t tangles = 0;      // cells of the image in which no crossing was taken, as there are too many
};

// Crossings of all lines with those that begin or end sheets (Subject::sheets > 0). Sorted by farther piece and share.
[[nodiscard]] base::Array<Crossing> find_crossings(const base::Runtime& runtime, std::span<const Subject> subjects,
                                                   const ImageLines& lines, CrossingReport& report,
                                                   const base::Progress& progress);

// Takes out crossings of curves that are near in space, too, and which the curves themselves do not have: beside a cusp
// the cubics may cross where the curve does not. Returns their number.
std::int64_t verify_crossings(const base::Runtime& runtime, std::span<const Subject> subjects, const ImageLines& lines,
                              base::Array<Crossing>& crossings, const base::Progress& progress);

struct Pierced {
    std::int32_t piece;  // the line's piece
    double share;        // along the piece, in [0, 1]
    std::int32_t item;   // the place of the surface's item among the occluders
    std::int32_t change; // how the number of sheets before the line changes as one goes along it: 1 or -1
};

// Places of all lines on all surfaces but their own. Between two places where f and its slope along the line's cubic
// are known f is taken for a cubic; where that may have a root it is looked at. Sorted by piece and share.
[[nodiscard]] base::Array<Pierced> find_pierced(const base::Runtime& runtime, std::span<const Subject> subjects,
                                                std::span<const Occluder> occluders, const ImageLines& lines,
                                                const base::Progress& progress);

} // namespace hrbfnpr::visibility
