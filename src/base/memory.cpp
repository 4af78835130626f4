#include "base/memory.h"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hrbfnpr::base {
namespace {

#if defined(__linux__)
// Arrays of this size are walked in no order that the processor's table of pages could follow: pages of 2 MiB where
// the system gives them on request (measured: a third of the time of a blue-noise order of 512 000 marks).
constexpr std::uint64_t huge_page = std::uint64_t{1} << 21U;
constexpr std::uint64_t worth_huge_pages = 2 * huge_page;

void advise(void* memory, std::uint64_t size) noexcept {
    if (memory == nullptr || size < worth_huge_pages) return;
    const auto begin = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (begin + huge_page - 1) & ~(huge_page - 1);
    const std::uintptr_t last = (begin + size) & ~(huge_page - 1);
    if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}
#else
void advise(void* /*memory*/, std::uint64_t /*size*/) noexcept {}
#endif

void* default_allocate(void* /*user*/, std::uint64_t size, std::uint64_t alignment) {
    void* memory = ::operator new (size, std::align_val_t{alignment}, std::nothrow);
    advise(memory, size);
    return memory;
}

void default_deallocate(void* /*user*/, void* memory, std::uint64_t /*size*/, std::uint64_t alignment) {
    ::operator delete (memory, std::align_val_t{alignment});
}

} // namespace

Memory::Memory() noexcept : Memory(nullptr, nullptr, nullptr) {}

Memory::Memory(AllocateFn given, DeallocateFn give_back, void* user) noexcept
    : allocate_(given != nullptr ? given : default_allocate),
      deallocate_(give_back != nullptr ? give_back : default_deallocate), user_(user) {}

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
