// SPDX-License-Identifier: MIT
// Finds which parts of a line are drawn. Short gaps are closed and short parts are left out, but neither appears nor
// vanishes suddenly.
//
// The presence of a line at a sample is 1 where it is drawn, 0 where it is not, and between where it fades. The held
// length of a sample measures how much of the line holds together around it. It is the length to either side, which
// The presence of a line at a sample is 1 where the line is drawn and 0 where it is not drawn. Where the line fades, it
// is between 0 and 1. The held length of a sample is the length of the line that is connected with the sample, on both
// sides. Where the presence is lower than at the sample, length counts less. The held length ends where the presence is
// 0. It changes continuously with the presences. So a gap whose held length is below a limit can be closed, a gap of
// twice the limit stays open, and a gap in between is half open. The same holds for parts.
#pragma once

#include "base/assert.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace hrbfnpr::frame {

// Samples along a line. In a ring, the last sample repeats the first.
struct SampledLine {
    // For each sample: the distance along the line from the first sample, in pixels, in rising order.
    std::span<const float> length;
    bool ring = false;

    [[nodiscard]] std::int64_t size() const noexcept { return static_cast<std::int64_t>(length.size()); }
    [[nodiscard]] float at(std::int64_t i) const noexcept {
        HRBFNPR_ASSERT(i >= 0 && i < size());
        return length[static_cast<std::size_t>(i)];
    }
    // Returns the neighbour of sample i in the direction `way` (1 or -1), and sets `step` to its distance. Returns -1
    // if the line ends at i.
    [[nodiscard]] std::int64_t next(std::int64_t i, int way, float& step) const noexcept {
        std::int64_t k = i + way;
        if (k >= 0 && k < size()) {
            step = way > 0 ? at(k) - at(i) : at(i) - at(k);
            return k;
        }
        if (!ring) return -1;
        k = way > 0 ? 1 : size() - 2;
        step = way > 0 ? at(1) - at(0) : at(size() - 1) - at(size() - 2);
        return k;
    }
};

// The result of walking along the line.
struct HeldLength {
    float length = 0.0F;
    std::int64_t stopped_at = -1; // The first sample without presence. -1 if the walk ended for another reason.
};

// Walks from sample i in one direction, until the held length is `most`, the presence is 0, or the line ends.
// `presence(k)` is the presence at sample k, and length near sample k is multiplied by `weight(k)`. If the line is
// present at sample j but not at its neighbour k, the presence ends at the share `end_share(j, k)` of the way from j to
// k. If the line ends, the length `beyond` is added.
template <class Presence, class Weight, class EndShare>
[[nodiscard]] HeldLength held_length(const SampledLine& line, std::int64_t i, int way, float most, float beyond,
                                     const Presence& presence, const Weight& weight,
                                     const EndShare& end_share) noexcept {
    const float own = presence(i);
    if (!(own > 0.0F)) return {0.0F, i};
    HeldLength held;
    float least = 1.0F; // the smallest presence until now, as a share of the presence at sample i
    float before = weight(i);
    for (std::int64_t steps = 0; steps < line.size(); ++steps) {
        float step = 0.0F;
        const std::int64_t k = line.next(i, way, step);
        if (k < 0) {
            held.length = std::min(held.length + least * beyond, most);
            return held;
        }
        const float there = presence(k);
        if (!(there > 0.0F)) {
            held.length = std::min(held.length + least * before * step * end_share(i, k), most);
            held.stopped_at = k;
            return held;
        }
        const float now = there < own ? std::min(least, there / own) : least;
        const float after = weight(k);
        held.length += 0.5F * step * (least * before + now * after);
        if (held.length >= most) {
            held.length = most;
            return held;
        }
        least = now;
        before = after;
        i = k;
    }
    return held; // The walk has passed all around a ring.
}

// Returns a value that rises smoothly from 0 at `from` to 1 at `to`.
[[nodiscard]] inline float ramp_between(float x, float from, float to) noexcept {
    return to > from ? std::clamp((x - from) / (to - from), 0.0F, 1.0F) : x > from ? 1.0F : 0.0F;
}

} // namespace hrbfnpr::frame
