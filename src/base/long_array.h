// SPDX-License-Identifier: MIT
// Arrays so large that their first touch takes long: a cancel is seen meanwhile.
#pragma once

#include "base/memory.h"
#include "base/operation.h"

#include <algorithm>
#include <cstdint>

namespace hrbfnpr::base {

// As array.resize(size): what it adds is zero.
template <class T>
void resize_long(Array<T>& array, std::int64_t size, const Progress& progress) {
    constexpr std::int64_t at_once = std::max<std::int64_t>(1, (std::int64_t{1} << 22) / std::int64_t{sizeof(T)});
    array.reserve(size);
    while (size - array.size() > at_once) {
        progress.check();
        array.resize(array.size() + at_once);
    }
    array.resize(size);
}

} // namespace hrbfnpr::base
