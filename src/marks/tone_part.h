// SPDX-License-Identifier: MIT
// The part of all tones over which a layer of marks appears.
#pragma once

#include <algorithm>

namespace hrbfnpr::marks {

// A rank in [0,1): rounding to float must not make it 1.
[[nodiscard]] inline float rank_of(double u) noexcept {
    constexpr float below_one = 0x1.fffffep-1F;
    return std::min(static_cast<float>(u), below_one);
}

// From the darkness at which the first mark is shown to the one at which all are.
struct TonePart {
    double begin = 0.0;
    double end = 1.0;

    [[nodiscard]] double length() const noexcept { return end - begin; }
    [[nodiscard]] float rank(float own) const noexcept {
        if (begin == 0.0 && end == 1.0) return own;
        return rank_of(1.0 - begin - (1.0 - static_cast<double>(own)) * length());
    }
};

} // namespace hrbfnpr::marks
