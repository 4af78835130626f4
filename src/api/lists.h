// SPDX-License-Identifier: MIT
// Lists from the caller: a pointer, a count, and a stride. Each element is a struct that begins with its size.
#pragma once

#include "api/descriptor.h"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>

namespace hrbfnpr::api {

// The name of an element in messages, such as "items[3]".
struct ElementName {
    ElementName(const char* list, std::int64_t number) noexcept {
        std::snprintf(text, sizeof text, "%.70s[%lld]", list, static_cast<long long>(number));
    }
    char text[96];
};

// The prefix of the names of a list's count and stride. For "style.lines" it is "style.line_".
struct CountPrefix {
    explicit CountPrefix(const char* list) noexcept {
        const auto length = static_cast<int>(std::strlen(list));
        std::snprintf(text, sizeof text, "%.*s_", length > 0 && list[length - 1] == 's' ? length - 1 : length, list);
    }
    char text[96];
};

template <class T>
class List {
public:
    // Throws Error{invalid_argument, unsupported_struct}. `name` must outlive this object.
    List(const T* first, std::int64_t count, std::int64_t stride, std::int64_t most, const char* name)
        : first_(reinterpret_cast<const std::byte*>(first)), count_(count), stride_(stride), name_(name) {
        if (count < 0 || count > most)
            fail(Status::invalid_argument, "%scount is %lld; it must be from 0 to %lld", CountPrefix(name).text,
                 static_cast<long long>(count), static_cast<long long>(most));
        if (count == 0) return;
        if (first == nullptr) fail(Status::invalid_argument, "%s is NULL", name);
        std::uint32_t size = 0;
        std::memcpy(&size, first, sizeof size);
        check_struct_size<T>(size, ElementName(name, 0).text);
        if (stride_ == 0) stride_ = size;
        constexpr std::int64_t largest = std::int64_t{1} << 32;
        if (stride_ < std::int64_t{smallest_struct} || stride_ > largest)
            fail(Status::invalid_argument, "%sstride is %lld; it must be 0 or the bytes from one element to the next",
                 CountPrefix(name).text, static_cast<long long>(stride));
    }

    [[nodiscard]] std::int64_t count() const noexcept { return count_; }
    // Returns element i in full. Missing fields have their defaults.
    [[nodiscard]] T operator[](std::int64_t i) const {
        return read_struct(reinterpret_cast<const T*>(first_ + i * stride_), ElementName(name_, i).text);
    }
    [[nodiscard]] ElementName name(std::int64_t i) const noexcept { return {name_, i}; }

private:
    const std::byte* first_;
    std::int64_t count_;
    std::int64_t stride_;
    const char* name_;
};

} // namespace hrbfnpr::api
