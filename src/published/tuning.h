// SPDX-License-Identifier: MIT
// The constants that the article leaves open. Those that it prints stand with the recursions.
#pragma once

namespace hrbfnpr::published {

struct PublishedTuning {
    // A stroke takes a principal direction in full from this confidence on, and below the first one goes on in its own
    // direction. Larger: strokes are straighter where the curvature hardly has a direction.
    double unsure = 0.02;
    double sure = 0.10;
    // The depth map of hidden marks has at most this many texels; of a larger viewport it is coarser. Larger: more
    // memory, at 4 bytes each.
    double most_texels = 16777216.0;
};
inline constexpr PublishedTuning published_tuning;

} // namespace hrbfnpr::published
