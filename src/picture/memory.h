// SPDX-License-Identifier: MIT
// Defines standard containers that use the context's memory. They do not use std::pmr, which the toolchains of
// Emscripten and Apple lacked for a long time.
#pragma once

#include "base/memory.h"

#include <cstddef>
#include <limits>
#include <list>
#include <map>
#include <new>
#include <scoped_allocator>
#include <string>
#include <unordered_map>
#include <vector>

namespace hrbfnpr::picture {

// A Pool lets containers use the context's memory, which is counted. They throw Error{out_of_memory}. The Memory must
// outlive the Pool, and the Pool must outlive its containers.
class Pool {
public:
    explicit Pool(base::Memory& memory) noexcept : memory_(&memory) {}
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;
    [[nodiscard]] base::Memory& memory() const noexcept { return *memory_; }

private:
    base::Memory* memory_;
};

// Allocates from a Pool. Without a Pool, as in copies of containers, it allocates from the program's memory.
template <class T>
class PoolAllocator {
public:
    using value_type = T;

    PoolAllocator() noexcept = default;
    PoolAllocator(Pool* pool) noexcept : pool_(pool) {} // NOLINT: containers are made by Vector<T> list(&pool)
    template <class U>
    PoolAllocator(const PoolAllocator<U>& other) noexcept : pool_(other.pool()) {} // NOLINT

    [[nodiscard]] T* allocate(std::size_t count) {
        if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_array_new_length();
        const std::size_t bytes = count * sizeof(T);
        return static_cast<T*>(pool_ != nullptr ? pool_->memory().allocate(bytes) : ::operator new(bytes));
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        if (pool_ != nullptr)
            pool_->memory().deallocate(memory, count * sizeof(T));
        else
            ::operator delete(memory);
    }
    [[nodiscard]] PoolAllocator select_on_container_copy_construction() const noexcept { return {}; }
    [[nodiscard]] Pool* pool() const noexcept { return pool_; }
    friend bool operator==(const PoolAllocator& a, const PoolAllocator& b) noexcept { return a.pool_ == b.pool_; }

private:
    Pool* pool_ = nullptr;
};

// Gives the elements of a container the same pool as the container.
template <class T>
using Allocator = std::scoped_allocator_adaptor<PoolAllocator<T>>;

template <class T>
using Vector = std::vector<T, Allocator<T>>;
template <class T>
using List = std::list<T, Allocator<T>>;
template <class Key, class T, class Less = std::less<Key>>
using Map = std::map<Key, T, Less, Allocator<std::pair<const Key, T>>>;
template <class Key, class T, class Hash>
using HashMap = std::unordered_map<Key, T, Hash, std::equal_to<Key>, Allocator<std::pair<const Key, T>>>;
using String = std::basic_string<char, std::char_traits<char>, Allocator<char>>;

} // namespace hrbfnpr::picture
