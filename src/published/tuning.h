// SPDX-License-Identifier: MIT
// The constants that the article leaves open. The constants that it prints are in growth.cpp.
#pragma once

namespace hrbfnpr::published {

struct PublishedTuning {
    // A stroke follows a principal direction in full from the confidence `sure` on. At `unsure` and below it keeps its
    // direction. Larger: strokes are straighter where the curvature hardly has a direction.
    double unsure = 0.02;
    double sure = 0.10;
    // The depth map of the visibility test has at most this many texels, so it is coarser for larger viewports. Larger:
    // more memory, at 4 bytes each.
    double most_texels = 16777216.0;
};
inline constexpr PublishedTuning published_tuning;

} // namespace hrbfnpr::published
