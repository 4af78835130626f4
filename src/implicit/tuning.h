// SPDX-License-Identifier: MIT
// Tuning of how trees of minima and maxima are evaluated. No member of CsgTuning changes a value that is computed; they
// were set for speed on `scripts/bench edges --only=csg` and `--only=rows`.
#pragma once

#include <cstdint>

namespace hrbfnpr::implicit {

struct CsgTuning {
    // Points that a run of steps works on at a time. Larger: less overhead for each step, and intermediate results
    // leave the fast caches.
    static constexpr std::int64_t block = 128;
    // The least number of primitives whose minimum is taken as a group, by a tree of boxes, and not two at a time.
    // Larger: more of those that are far are evaluated.
    std::int64_t primitives = 16;
    // The same if one of the members holds a model; two that do are always a group.
    std::int64_t beside_model = 3;
    // Groups lie in groups this deep at most; what lies deeper is done two at a time. Larger: more stack.
    std::int32_t nested = 8;
    // The most that rounding changes a place or a value by, as a share of the largest number that they come from.
    // Larger: members are asked that are not needed; smaller: needed ones may be left out.
    double rounding = 1e-7;
};
inline constexpr CsgTuning csg_tuning;

} // namespace hrbfnpr::implicit
