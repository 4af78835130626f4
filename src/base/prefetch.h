// SPDX-License-Identifier: MIT
// Memory that will be needed soon.
#pragma once

#include <cstdint>

namespace hrbfnpr::base {

// Asks for the cache lines of `count` elements; never fails, whatever the address.
template <class T>
inline void prefetch(const T* data, std::int64_t count) noexcept {
    const auto* const bytes = reinterpret_cast<const char*>(data);
    const auto size = count * static_cast<std::int64_t>(sizeof(T));
    for (std::int64_t at = 0; at < size; at += 64) __builtin_prefetch(bytes + at);
    // GCC takes a function that only does this for one without effects, and leaves out the calls to it.
    __asm__ volatile("");
}

// The same of so many that the first cache would not hold them until then: to the second one.
template <class T>
inline void prefetch_many(const T* data, std::int64_t count) noexcept {
    const auto* const bytes = reinterpret_cast<const char*>(data);
    const auto size = count * static_cast<std::int64_t>(sizeof(T));
    for (std::int64_t at = 0; at < size; at += 64) __builtin_prefetch(bytes + at, 0, 2);
    __asm__ volatile("");
}

} // namespace hrbfnpr::base
