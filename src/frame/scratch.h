// Arrays that are kept from frame to frame.
#pragma once

#include "base/memory.h"

#include <memory>

namespace hrbfnpr::frame {

// Resizes to `count` elements whose values do not matter.  Grows by a quarter more than asked, so
// that a moving camera soon allocates nothing.
template <class T>
void resize_scratch(base::Array<T>& array, std::int64_t count) {
    if (count * std::int64_t{sizeof(T)} > array.bytes()) {
        array.clear(); // nothing to copy
        array.reserve(count + count / 4);
    }
    array.resize(count);
}

// The same for types with constructors, such as GLM's: base::Array copies bytes only.
template <class T>
class Objects {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    explicit Objects(base::Memory& memory) noexcept : memory_(&memory) {}
    Objects(const Objects&) = delete;
    Objects& operator=(const Objects&) = delete;
    ~Objects() { release(); }

    [[nodiscard]] std::int64_t size() const noexcept { return size_; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return capacity_ * std::int64_t{sizeof(T)}; }
    [[nodiscard]] T& operator[](std::int64_t i) noexcept { return data_[i]; }
    [[nodiscard]] const T& operator[](std::int64_t i) const noexcept { return data_[i]; }
    [[nodiscard]] std::span<const T> span() const noexcept { return {data_, static_cast<std::size_t>(size_)}; }
    void clear() noexcept { size_ = 0; }

    void resize_scratch(std::int64_t count) {
        if (count > capacity_) {
            release();
            const std::int64_t capacity = count + count / 4;
            data_ = static_cast<T*>(memory_->allocate(static_cast<std::uint64_t>(capacity) * sizeof(T)));
            std::uninitialized_default_construct_n(data_, capacity);
            capacity_ = capacity;
        }
        size_ = count;
    }

private:
    void release() noexcept {
        if (data_ != nullptr) memory_->deallocate(data_, static_cast<std::uint64_t>(bytes()));
        data_ = nullptr;
        size_ = 0;
        capacity_ = 0;
    }

    base::Memory* memory_;
    T* data_ = nullptr;
    std::int64_t size_ = 0;
    std::int64_t capacity_ = 0;
};

} // namespace hrbfnpr::frame
