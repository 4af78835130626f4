// SPDX-License-Identifier: MIT
// The search for a zero of a function between two places where its signs differ: the Illinois method. [Dowell & Jarratt
// 1971]
#pragma once

#include "base/assert.h"

#include <algorithm>

namespace hrbfnpr::curves {

struct Illinois {
    double low = 0.0, high = 1.0;
    double at_low, at_high; // the values there; the value of an end that stays is halved
    double trial;           // where the function is asked for next
    int kept = 0;           // how many times in a row the same end stayed: above 0 the higher one

    Illinois(double from, double to) noexcept : at_low(from), at_high(to), trial(from / (from - to)) {
        HRBFNPR_ASSERT(!(from * to > 0.0));
    }
    // The value at the trial.
    void take(double value) noexcept {
        const bool same = (value < 0.0) == (at_low < 0.0);
        (same ? low : high) = trial;
        (same ? at_low : at_high) = value;
        kept = same ? std::max(1, kept + 1) : std::min(-1, kept - 1);
        if (kept > 1) at_high *= 0.5;
        if (kept < -1) at_low *= 0.5;
        trial = low + (high - low) * at_low / (at_low - at_high);
        if (!(trial >= low && trial <= high)) trial = 0.5 * (low + high);
    }
    [[nodiscard]] bool done(double width) const noexcept {
        return !(high - low > width) || at_low == 0.0 || at_high == 0.0;
    }
};

} // namespace hrbfnpr::curves
