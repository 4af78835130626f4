// SPDX-License-Identifier: MIT
#include "base/memory.h"

#include <limits>
#include <new>

#if defined(__linux__)
#include <cerrno>
#include <sys/mman.h>
#endif

namespace hrbfnpr::base {
namespace {

// The smallest size, in bytes, of an array that gets huge pages. Smaller arrays gain little from huge pages, and may
// take up to one huge page more than requested.
constexpr std::uint64_t large = std::uint64_t{4} << 20U;

// Asks for huge pages where the system provides them on request, as Linux does by default. A cancelled call must wait
// until its large arrays are freed. With huge pages, freeing takes almost no time, instead of 0.1 ms per megabyte. The
// first write to the memory takes a quarter of the time if huge pages are free. It takes longer if the system, or the
// host of a virtual machine, must first make them free.
void ask_for_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::uint64_t size) noexcept {
#if defined(__linux__)
    constexpr std::uintptr_t page = 4096; // a system with larger pages rejects the call, which is harmless
    const auto address = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t inward = (page - address % page) % page;
    const int before = errno; // the host's errno, which is restored
    madvise(static_cast<char*>(memory) + inward, static_cast<std::size_t>(size) - inward, MADV_HUGEPAGE);
    errno = before;
#endif
}

void* default_allocate(void* /*user*/, std::uint64_t size, std::uint64_t alignment) {
    if (size > std::numeric_limits<std::size_t>::max()) return nullptr; // possible if pointers have 32 bits
    void* const memory = ::operator new (static_cast<std::size_t>(size),
                                         std::align_val_t{static_cast<std::size_t>(alignment)}, std::nothrow);
    if (memory != nullptr && size >= large) ask_for_huge_pages(memory, size);
    return memory;
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
