// SPDX-License-Identifier: MIT
// The constants that the article leaves open. The constants that it prints are in growth.cpp.
#pragma once

namespace hrbfnpr::published {

struct PublishedTuning {
    // A stroke takes a principal direction in full from `full_confidence` on. At `no_confidence` and below it goes on
    // in its own direction. Larger: strokes are straighter where the curvature has hardly a direction.
    double no_confidence = 0.02;
    double full_confidence = 0.10;
    // The depth map of the visibility test has at most this many texels, so it is coarser for larger viewports. Larger:
    // more memory, at 4 bytes each.
    double most_texels = 16777216.0;
};
inline constexpr PublishedTuning published_tuning;

} // namespace hrbfnpr::published
