// SPDX-License-Identifier: MIT
// Prefetches memory that will be needed soon.
#pragma once

#include <cstdint>

namespace hrbfnpr::base {

// Prefetches the cache lines of `count` elements. Invalid addresses are harmless.
template <class T>
inline void prefetch(const T* data, std::int64_t count) noexcept {
    const auto* const bytes = reinterpret_cast<const char*>(data);
    const auto size = count * static_cast<std::int64_t>(sizeof(T));
    for (std::int64_t at = 0; at < size; at += 64) __builtin_prefetch(bytes + at);
    // Without this, GCC regards the function as one without effects, and removes calls to it.
    __asm__ volatile("");
}

// Prefetches into the second-level cache, for data that do not fit into the first level.
template <class T>
inline void prefetch_many(const T* data, std::int64_t count) noexcept {
    const auto* const bytes = reinterpret_cast<const char*>(data);
    const auto size = count * static_cast<std::int64_t>(sizeof(T));
    for (std::int64_t at = 0; at < size; at += 64) __builtin_prefetch(bytes + at, 0, 2);
    __asm__ volatile("");
}

} // namespace hrbfnpr::base
