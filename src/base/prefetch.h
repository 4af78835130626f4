// SPDX-License-Identifier: MIT
// Prefetches memory that will be needed soon.
#pragma once

#include <cstdint>

namespace hrbfnpr::base {

// Prefetches the cache lines of `count` elements. It never fails, whatever the address.
template <class T>
inline void prefetch(const T* data, std::int64_t count) noexcept {
    const auto* const bytes = reinterpret_cast<const char*>(data);
    const auto size = count * static_cast<std::int64_t>(sizeof(T));
    for (std::int64_t at = 0; at < size; at += 64) __builtin_prefetch(bytes + at);
    // GCC treats a function that only prefetches as one without effects, and removes the calls to it.
    __asm__ volatile("");
}

// Prefetches into the second-level cache: for more elements than the first level can hold until they are used.
template <class T>
inline void prefetch_many(const T* data, std::int64_t count) noexcept {
    const auto* const bytes = reinterpret_cast<const char*>(data);
    const auto size = count * static_cast<std::int64_t>(sizeof(T));
    for (std::int64_t at = 0; at < size; at += 64) __builtin_prefetch(bytes + at, 0, 2);
    __asm__ volatile("");
}

} // namespace hrbfnpr::base
