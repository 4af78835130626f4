// SPDX-License-Identifier: MIT
// A growable list of objects, in memory from a Memory. It is for objects that base::Array cannot hold.
#pragma once

#include "base/memory.h"

namespace hrbfnpr::base {

// The Memory must outlive the list.
template <class T>
class List {
    static_assert(std::is_nothrow_move_constructible_v<T> && alignof(T) <= Memory::alignment);

public:
    explicit List(Memory& memory) noexcept : memory_(&memory) {}
    List(List&& other) noexcept
        : memory_(other.memory_), data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)),
          capacity_(std::exchange(other.capacity_, 0)) {}
    List& operator=(List&& other) noexcept {
        std::swap(memory_, other.memory_);
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
        return *this;
    }
    List(const List&) = delete;
    List& operator=(const List&) = delete;
    ~List() {
        clear();
        give_back(data_, capacity_);
    }

    [[nodiscard]] std::int64_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return capacity_ * std::int64_t{sizeof(T)}; }
    [[nodiscard]] T& operator[](std::int64_t i) noexcept { return data_[i]; }
    [[nodiscard]] const T& operator[](std::int64_t i) const noexcept { return data_[i]; }
    [[nodiscard]] T* begin() noexcept { return data_; }
    [[nodiscard]] T* end() noexcept { return data_ + size_; }
    [[nodiscard]] const T* begin() const noexcept { return data_; }
    [[nodiscard]] const T* end() const noexcept { return data_ + size_; }
    [[nodiscard]] T& back() noexcept { return data_[size_ - 1]; }
    [[nodiscard]] Memory& memory() const noexcept { return *memory_; }

    void reserve(std::int64_t capacity) {
        if (capacity <= capacity_) return;
        auto* grown = static_cast<T*>(memory_->allocate(static_cast<std::uint64_t>(capacity) * sizeof(T)));
        for (std::int64_t i = 0; i < size_; ++i) {
            new (grown + i) T(std::move(data_[i]));
            data_[i].~T();
        }
        give_back(data_, capacity_);
        data_ = grown;
        capacity_ = capacity;
    }

    // The arguments must not refer to elements of the list.
    template <class... Arguments>
    T& add(Arguments&&... arguments) {
        if (size_ == capacity_) reserve(capacity_ < 4 ? 4 : capacity_ + capacity_ / 2);
        T* added = new (data_ + size_) T(std::forward<Arguments>(arguments)...);
        ++size_;
        return *added;
    }

    void clear() noexcept {
        for (; size_ > 0; --size_) data_[size_ - 1].~T();
    }

private:
    void give_back(T* data, std::int64_t capacity) noexcept {
        if (data != nullptr) memory_->deallocate(data, static_cast<std::uint64_t>(capacity) * sizeof(T));
    }

    Memory* memory_;
    T* data_ = nullptr;
    std::int64_t size_ = 0;
    std::int64_t capacity_ = 0;
};

} // namespace hrbfnpr::base
