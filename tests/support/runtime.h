// SPDX-License-Identifier: MIT
// Runtimes with a number of threads or with a test's allocator, and a comparison of two arrays bit by bit.
#pragma once

#include "base/memory.h"
#include "base/runtime.h"
#include "support/allocator.h"

#include <cstring>

namespace hrbfnpr::test {

inline base::Runtime with_threads(int threads) {
    return {nullptr, nullptr, nullptr, base::Parallel(threads, nullptr, nullptr), base::InstructionSet::automatic,
            nullptr, nullptr};
}

inline base::Runtime with_allocator(Allocator& allocator, int threads = 2) {
    return {Allocator::allocate,
            Allocator::deallocate,
            &allocator,
            base::Parallel(threads, nullptr, nullptr),
            base::InstructionSet::automatic,
            nullptr,
            nullptr};
}

template <class T>
bool same_bits(const base::Array<T>& a, const base::Array<T>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), sizeof(T) * static_cast<std::size_t>(a.size())) == 0);
}

} // namespace hrbfnpr::test
