// SPDX-License-Identifier: MIT
// An allocator that counts calls and can refuse some of them, for contexts and for base::Runtime.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace hrbfnpr::test {

struct Allocator {
    std::atomic<std::int64_t> calls{0};  // includes refused calls
    std::atomic<std::int64_t> blocks{0}; // allocated and not yet freed
    std::atomic<std::int64_t> bytes{0};  // bytes in these blocks
    std::atomic<std::uint64_t> smallest_alignment{std::numeric_limits<std::uint64_t>::max()};

    std::int64_t refuse_at = 0;                                        // number of the call to refuse, from 1; 0: none
    bool refuse_after = false;                                         // also refuses all later calls
    std::uint64_t largest = std::numeric_limits<std::uint64_t>::max(); // larger allocations are refused

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

    // Returns memory for std::free.
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
