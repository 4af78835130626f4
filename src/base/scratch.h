// SPDX-License-Identifier: MIT
// Arrays that are kept from call to call.
#pragma once

#include "base/memory.h"

namespace hrbfnpr::base {

// Resizes to `count` elements whose values do not matter.  Grows by a quarter more than asked, so
// that a moving camera soon allocates nothing.
template <class T>
void resize_scratch(base::Array<T>& array, std::int64_t count) {
    if (count * std::int64_t{sizeof(T)} > array.bytes()) {
        array.clear(); // nothing to copy
        array.reserve(count + count / 4);
    }
    array.resize_for_overwrite(count);
}

} // namespace hrbfnpr::base
