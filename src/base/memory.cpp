// SPDX-License-Identifier: MIT
#include "base/memory.h"

#include <limits>
#include <new>

namespace hrbfnpr::base {
namespace {

void* default_allocate(void* /*user*/, std::uint64_t size, std::uint64_t alignment) {
    if (size > std::numeric_limits<std::size_t>::max()) return nullptr; // with 32-bit pointers
    return ::operator new (static_cast<std::size_t>(size), std::align_val_t{static_cast<std::size_t>(alignment)},
                           std::nothrow);
}

void default_deallocate(void* /*user*/, void* memory, std::uint64_t /*size*/, std::uint64_t alignment) {
    ::operator delete (memory, std::align_val_t{static_cast<std::size_t>(alignment)});
}

} // namespace

Memory::Memory() noexcept : Memory(nullptr, nullptr, nullptr) {}

Memory::Memory(AllocateFn give, DeallocateFn take_back, void* user) noexcept
    : allocate_(give != nullptr ? give : default_allocate),
      deallocate_(take_back != nullptr ? take_back : default_deallocate), user_(user) {}

void* Memory::allocate(std::uint64_t size) {
    void* memory = allocate_(user_, size, alignment);
    if (memory == nullptr)
        fail(Status::out_of_memory, "the allocator returned NULL for %llu bytes",
             static_cast<unsigned long long>(size));
    const auto now =
        now_.fetch_add(static_cast<std::int64_t>(size), std::memory_order_relaxed) + static_cast<std::int64_t>(size);
    auto peak = peak_.load(std::memory_order_relaxed);
    while (now > peak && !peak_.compare_exchange_weak(peak, now, std::memory_order_relaxed)) {
    }
    return memory;
}

void Memory::deallocate(void* memory, std::uint64_t size) noexcept {
    deallocate_(user_, memory, size, alignment);
    now_.fetch_sub(static_cast<std::int64_t>(size), std::memory_order_relaxed);
}

} // namespace hrbfnpr::base
