// SPDX-License-Identifier: MIT
// Sorting and merging of long arrays, with checks for cancellation.
#pragma once

#include "base/operation.h"

#include <algorithm>
#include <cstdint>

namespace hrbfnpr::base {

// Works like std::sort. All elements must be different, so that the order is the same with any standard library.
template <class T, class Less>
void sort_long(T* begin, T* end, const Less& less, const Progress& progress = {}) {
    constexpr std::ptrdiff_t at_once = 65536;
    while (end - begin > at_once) {
        progress.check();
        T* const middle = begin + (end - begin) / 2;
        std::nth_element(begin, middle, end, less);
        sort_long(begin, middle, less, progress);
        begin = middle;
    }
    progress.check();
    std::sort(begin, end, less);
}

// Works like std::merge. `to` must not overlap the inputs.
template <class T, class Less>
void merge_long(const T* a, const T* a_end, const T* b, const T* b_end, T* to, const Less& less,
                const Progress& progress = {}) {
    constexpr std::int64_t at_once = 65536;
    while (a != a_end && b != b_end) {
        progress.check();
        for (std::int64_t left = at_once; left > 0 && a != a_end && b != b_end; --left)
            *to++ = less(*b, *a) ? *b++ : *a++;
    }
    std::copy(b, b_end, std::copy(a, a_end, to));
}

} // namespace hrbfnpr::base
