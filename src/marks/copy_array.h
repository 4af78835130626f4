// SPDX-License-Identifier: MIT
// Arrays of plain numbers, copied into memory that is there already.
#pragma once

#include "base/memory.h"

#include <cstring>
#include <type_traits>

namespace hrbfnpr::marks {

template <class T>
void copy_array(const base::Array<T>& from, base::Array<T>& to) {
    static_assert(std::is_trivially_copyable_v<T>);
    to.resize_for_overwrite(from.size());
    if (!from.empty())
        std::memcpy(static_cast<void*>(to.data()), from.data(), sizeof(T) * static_cast<std::size_t>(from.size()));
}

} // namespace hrbfnpr::marks
