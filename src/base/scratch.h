// SPDX-License-Identifier: MIT
// Arrays whose memory is kept from call to call.
#pragma once

#include "base/memory.h"

namespace hrbfnpr::base {

// Resizes to `count` elements whose values are unspecified.  The capacity grows to a quarter more than `count`, so that
// a moving camera soon allocates nothing.
template <class T>
void resize_scratch(base::Array<T>& array, std::int64_t count) {
    if (count * std::int64_t{sizeof(T)} > array.bytes()) {
        array.clear(); // nothing to copy
        array.reserve(count + count / 4);
    }
    array.resize_for_overwrite(count);
}

} // namespace hrbfnpr::base
