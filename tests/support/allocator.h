// SPDX-License-Identifier: MIT
// An allocator that counts, and refuses what it is told to; for contexts and for base::Runtime.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace hrbfnpr::test {

struct Allocator {
    std::atomic<std::int64_t> calls{0};  // refused ones, too
    std::atomic<std::int64_t> blocks{0}; // given out and not yet given back
    std::atomic<std::int64_t> bytes{0};  // in these
    std::atomic<std::uint64_t> smallest_alignment{std::numeric_limits<std::uint64_t>::max()};

    std::int64_t refuse_at = 0;                                        // the how-manieth call is refused; 0 = none
    bool refuse_after = false;                                         // and all later ones, too
    std::uint64_t largest = std::numeric_limits<std::uint64_t>::max(); // more bytes at a time are refused

    static void* allocate(void* user, std::uint64_t size, std::uint64_t alignment) {
        auto& self = *static_cast<Allocator*>(user);
        const std::int64_t call = self.calls.fetch_add(1) + 1;
        if (self.refuses(call) || size > self.largest) return nullptr;
        self.blocks.fetch_add(1);
        self.bytes.fetch_add(static_cast<std::int64_t>(size));
        std::uint64_t smallest = self.smallest_alignment;
        while (alignment < smallest && !self.smallest_alignment.compare_exchange_weak(smallest, alignment)) {
        }
        return aligned(size, alignment);
    }
    static void deallocate(void* user, void* memory, std::uint64_t size, std::uint64_t /*alignment*/) {
        auto& self = *static_cast<Allocator*>(user);
        self.blocks.fetch_sub(1);
        self.bytes.fetch_sub(static_cast<std::int64_t>(size));
        std::free(memory);
    }

    // Memory that std::free gives back.
    static void* aligned(std::uint64_t size, std::uint64_t alignment) {
        return std::aligned_alloc(alignment,
                                  (std::max<std::uint64_t>(size, 1) + alignment - 1) / alignment * alignment);
    }

private:
    [[nodiscard]] bool refuses(std::int64_t call) const {
        return refuse_at > 0 && (call == refuse_at || (refuse_after && call > refuse_at));
    }
};

} // namespace hrbfnpr::test
