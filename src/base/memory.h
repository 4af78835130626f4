// SPDX-License-Identifier: MIT
// The context's allocator, which counts bytes, and an array that owns memory from it.
#pragma once

#include "base/assert.h"
#include "base/status.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

namespace hrbfnpr::base {

using AllocateFn = void* (*)(void* user, std::uint64_t size, std::uint64_t alignment);
using DeallocateFn = void (*)(void* user, void* memory, std::uint64_t size, std::uint64_t alignment);

// Thread-safe. All memory whose size depends on the data is allocated here.
class Memory {
public:
    static constexpr std::uint64_t alignment = 64; // the size of a cache line and of the widest SIMD vector

    Memory() noexcept;
    Memory(AllocateFn give, DeallocateFn take_back, void* user) noexcept;
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;

    // Throws Error{out_of_memory} with the size in the message.
    [[nodiscard]] void* allocate(std::uint64_t size);
    void deallocate(void* memory, std::uint64_t size) noexcept;

    [[nodiscard]] std::int64_t bytes_now() const noexcept { return now_.load(std::memory_order_relaxed); }
    [[nodiscard]] std::int64_t bytes_peak() const noexcept { return peak_.load(std::memory_order_relaxed); }

private:
    AllocateFn allocate_;
    DeallocateFn deallocate_;
    void* user_;
    std::atomic<std::int64_t> now_{0};
    std::atomic<std::int64_t> peak_{0};
};

// A growable array of trivial elements, in memory from a Memory. Elements that resize() adds are zero. The Memory must
// outlive the array. An array that lent() makes owns no memory, and must not be changed.
template <class T>
class Array {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    explicit Array(Memory& memory) noexcept : memory_(&memory) {}
    Array(Memory& memory, std::int64_t size) : memory_(&memory) { resize(size); }
    Array(Array&& other) noexcept
        : memory_(other.memory_), data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)),
          capacity_(std::exchange(other.capacity_, 0)) {}
    Array& operator=(Array&& other) noexcept {
        std::swap(memory_, other.memory_);
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        return *this;
    }
    Array(const Array&) = delete;
    Array& operator=(const Array&) = delete;
    ~Array() { release(); }
    // Returns an array with the elements of this one, which must outlive it unchanged.
    [[nodiscard]] Array lent() const noexcept {
        Array borrowed(*memory_);
        borrowed.data_ = data_;
        borrowed.size_ = size_;
        return borrowed;
    }

    [[nodiscard]] std::int64_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return capacity_ * element_bytes; }
    [[nodiscard]] T* data() noexcept { return data_; }
    [[nodiscard]] const T* data() const noexcept { return data_; }
    [[nodiscard]] T& operator[](std::int64_t i) noexcept { return data_[i]; }
    [[nodiscard]] const T& operator[](std::int64_t i) const noexcept { return data_[i]; }
    [[nodiscard]] T* begin() noexcept { return data_; }
    [[nodiscard]] T* end() noexcept { return data_ + size_; }
    [[nodiscard]] const T* begin() const noexcept { return data_; }
    [[nodiscard]] const T* end() const noexcept { return data_ + size_; }
    [[nodiscard]] T& back() noexcept { return data_[size_ - 1]; }
    [[nodiscard]] std::span<T> span() noexcept { return {data_, static_cast<std::size_t>(size_)}; }
    [[nodiscard]] std::span<const T> span() const noexcept { return {data_, static_cast<std::size_t>(size_)}; }
    [[nodiscard]] Memory& memory() const noexcept { return *memory_; }

    void clear() noexcept { size_ = 0; }

    void reserve(std::int64_t capacity) {
        if (capacity <= capacity_) return;
        HRBFNPR_ASSERT(!is_borrowed());
        T* grown = static_cast<T*>(memory_->allocate(byte_count(capacity)));
        if (size_ > 0) std::memcpy(static_cast<void*>(grown), data_, byte_count(size_));
        if (data_ != nullptr) memory_->deallocate(data_, byte_count(capacity_));
        data_ = grown;
        capacity_ = capacity;
    }

    void resize(std::int64_t size) {
        reserve(size);
        if (size > size_) std::memset(static_cast<void*>(data_ + size_), 0, byte_count(size - size_));
        size_ = size;
    }

    // Resizes without initializing the added elements, for arrays that are then filled on all threads.
    void resize_for_overwrite(std::int64_t size) {
        reserve(size);
        size_ = size;
    }

    void push_back(const T& value) {
        if (size_ == capacity_) {
            const T copy = value; // a copy, because `value` may be in the memory that reserve() frees
            reserve(capacity_ < 16 ? 16 : capacity_ + capacity_ / 2);
            data_[size_++] = copy;
            return;
        }
        data_[size_++] = value;
    }

    // Deallocates the memory.
    void release() noexcept {
        if (capacity_ > 0) memory_->deallocate(data_, byte_count(capacity_));
        data_ = nullptr;
        size_ = 0;
        capacity_ = 0;
    }

private:
    [[nodiscard]] bool is_borrowed() const noexcept { return data_ != nullptr && capacity_ == 0; }

    // NOLINTNEXTLINE(bugprone-sizeof-expression): the elements may be pointers
    static constexpr std::int64_t element_bytes{sizeof(T)};

    static std::uint64_t byte_count(std::int64_t elements) {
        constexpr auto limit = std::int64_t{1} << 62;
        if (elements < 0 || elements > limit / element_bytes)
            fail(Status::out_of_memory, "%lld elements of %lld bytes are more than memory can hold",
                 static_cast<long long>(elements), static_cast<long long>(element_bytes));
        return static_cast<std::uint64_t>(elements * element_bytes);
    }

    Memory* memory_;
    T* data_ = nullptr;
    std::int64_t size_ = 0;
    std::int64_t capacity_ = 0;
};

// A single object in memory from a Memory. It holds a task's working data if the data may be too large for the stack of
// a host's thread.
template <class T>
class OwnedObject {
public:
    template <class... Arguments>
    explicit OwnedObject(Memory& memory, Arguments&&... arguments)
        : memory_(memory), object_(new (memory.allocate(sizeof(T))) T(std::forward<Arguments>(arguments)...)) {
        static_assert(std::is_nothrow_constructible_v<T, Arguments...> && alignof(T) <= Memory::alignment);
    }
    OwnedObject(const OwnedObject&) = delete;
    OwnedObject& operator=(const OwnedObject&) = delete;
    ~OwnedObject() {
        object_->~T();
        memory_.deallocate(object_, sizeof(T));
    }

    [[nodiscard]] T* operator->() noexcept { return object_; }
    [[nodiscard]] T& operator*() noexcept { return *object_; }

private:
    Memory& memory_;
    T* object_;
};

} // namespace hrbfnpr::base
