// SPDX-License-Identifier: MIT
// Where the images of curves cross, and which of two is the nearer one there.
#pragma once

#include "base/operation.h"
#include "visibility/image_lines.h"

namespace hrbfnpr::visibility {

struct Crossing {
    std::int32_t far_piece, near_piece;
    double far_share, near_share; // along the pieces, in [0, 1]
    std::int32_t change;          // of the number of sheets before the farther line, along it
    glm::dvec2 place;             // pixels
    double gap;                   // between the curves, in sides of the farther one's mesh
    double sine;                  // of the angle between their images
};

struct CrossingReport {
    std::int64_t of_polylines = 0; // crossings of segments
    std::int64_t rejected = 0;     // that the curves do not have
    std::int64_t tangles = 0;      // cells of the image in which none was taken, as there are too many
};

// Of all lines with those that begin or end sheets (Subject::sheets > 0).  Sorted by farther piece and share.
[[nodiscard]] base::Array<Crossing> find_crossings(const base::Runtime& runtime, std::span<const Subject> subjects,
                                                   const ImageLines& lines, CrossingReport& report,
                                                   const base::Progress& progress);

} // namespace hrbfnpr::visibility
