// SPDX-License-Identifier: MIT
// Arrays whose memory is kept between calls.
#pragma once

#include "base/memory.h"

namespace hrbfnpr::base {

// Resizes an array to `count` elements with unspecified values. An array that grows gets memory for a quarter more than
// `count` elements, so that a moving camera soon causes no more allocations.
template <class T>
void resize_scratch(base::Array<T>& array, std::int64_t count) {
    if (count * std::int64_t{sizeof(T)} > array.bytes()) {
        array.clear(); // so that no elements are copied
        array.reserve(count + count / 4);
    }
    array.resize_for_overwrite(count);
}

} // namespace hrbfnpr::base
