// SPDX-License-Identifier: MIT
// The constants that the article does not give. Those that it gives are in growth.cpp.
#pragma once

namespace hrbfnpr::published {

struct PublishedTuning {
    // From the confidence `full_confidence` on, a stroke follows the principal direction completely. At `no_confidence`
    // and below, it continues in its own direction. Larger: strokes are straighter where the principal direction is
    // uncertain.
    double no_confidence = 0.02;
    double full_confidence = 0.10;
    // The largest number of texels in the depth map of the visibility test, so for larger viewports it is coarser.
    // Larger: more memory, 4 bytes for each texel.
    double most_texels = 16777216.0;
};
inline constexpr PublishedTuning published_tuning;

} // namespace hrbfnpr::published
