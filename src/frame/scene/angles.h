// SPDX-License-Identifier: MIT
// Sums and bounds of angles that are given by their cosines and sines.
#pragma once

#include "base/assert.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {

// The cosine and sine of an angle in [0, pi].
struct Angle {
    float cosine, sine;
};

[[nodiscard]] inline Angle sum(const Angle& a, const Angle& b) noexcept {
    const float sine = a.sine * b.cosine + a.cosine * b.sine;
    if (sine < 0.0F) return {-1.0F, 0.0F}; // The angle is beyond pi.
    return {a.cosine * b.cosine - a.sine * b.sine, sine};
}

struct Range {
    float least, most;
};

// Returns the range of cosines of all angles that differ by at most `spread` from the angle with the cosine `middle`.
[[nodiscard]] inline Range cosines(float middle, const Angle& spread) noexcept {
    HRBFNPR_ASSERT(spread.sine >= 0.0F && spread.sine <= 1.001F && std::abs(spread.cosine) <= 1.001F);
    middle = std::clamp(middle, -1.0F, 1.0F);
    const float sine = std::sqrt(1.0F - middle * middle);
    const float both = middle * spread.cosine;
    const float side = sine * spread.sine;
    return {middle > -spread.cosine ? both - side : -1.0F, middle < spread.cosine ? both + side : 1.0F};
}

} // namespace hrbfnpr::frame
