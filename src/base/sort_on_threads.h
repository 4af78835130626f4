// SPDX-License-Identifier: MIT
// Sorting of long arrays on all threads.
#pragma once

#include "base/memory.h"
#include "base/sort.h"
#include "base/work.h"

#include <utility>

namespace hrbfnpr::base {

// Works like std::sort: runs of equal length are sorted in parallel, and merged in pairs. All elements must be
// different, so that the order is the same with any standard library. Needs memory for a copy.
template <class T, class Less>
void sort_on_threads(const Work& work, Array<T>& array, const Less& less) {
    constexpr std::int64_t run = 32768;
    const std::int64_t count = array.size();
    work.for_chunks(count, run, [&](std::int64_t begin, std::int64_t end) {
        std::sort(array.data() + begin, array.data() + end, less);
    });
    Array<T> merged(array.memory());
    for (std::int64_t length = run; length < count; length *= 2) {
        merged.resize_for_overwrite(count);
        work.for_each((count + 2 * length - 1) / (2 * length), [&](std::int64_t pair) {
            const std::int64_t begin = 2 * length * pair;
            const std::int64_t middle = std::min(begin + length, count);
            const std::int64_t end = std::min(middle + length, count);
            merge_long(array.data() + begin, array.data() + middle, array.data() + middle, array.data() + end,
                       merged.data() + begin, less, work);
        });
        std::swap(array, merged);
    }
}

} // namespace hrbfnpr::base
