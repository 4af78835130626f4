// SPDX-License-Identifier: MIT
// Selection as by std::nth_element, with the same order on all platforms.
#pragma once

#include "base/assert.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace hrbfnpr::base {

// Moves the median of a[1], the middle element and the last one to the front, and returns the first element of the part
// that is not below it.
template <class T, class Less>
[[nodiscard]] T* partition_by_median(T* begin, T* end, const Less& less) {
    T* low = begin + 1;
    T* const middle = begin + (end - begin) / 2;
    T* const last = end - 1;
    T* const smaller = less(*low, *middle) ? low : middle;
    T* const larger = smaller == low ? middle : low;
    std::swap(*begin, less(*last, *smaller) ? *smaller : less(*larger, *last) ? *larger : *last);
    // The median, and elements that were swapped, stop both searches.
    for (T* high = end;; ++low) {
        while (less(*low, *begin)) ++low;
        --high;
        while (less(*begin, *high)) --high;
        if (low >= high) return low;
        std::swap(*low, *high);
    }
}

// Works like std::nth_element, whose order within the two parts depends on the standard library. All elements must be
// different.
template <class T, class Less>
void select(T* begin, T* nth, T* end, const Less& less) {
    HRBFNPR_ASSERT(begin <= nth && nth < end);
    constexpr std::ptrdiff_t few = 3;
    // Each partition halves the range on average. A range that needs more than twice as many is sorted instead.
    int partitions = 0;
    for (std::ptrdiff_t size = end - begin; size > 1; size /= 2) partitions += 2;
    for (; end - begin > few && partitions > 0; --partitions) {
        T* const cut = partition_by_median(begin, end, less);
        (cut <= nth ? begin : end) = cut;
    }
    std::sort(begin, end, less);
}

} // namespace hrbfnpr::base
