// SPDX-License-Identifier: MIT
// Strided views of the caller's memory. They convert all scalar types from and to double. src/api checks a view before
// other code reads it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace hrbfnpr::base {

// The values equal the constants HRBFNPR_SCALAR_*.
enum class Scalar : std::uint32_t { float32 = 1, float64 = 2, uint8 = 3, uint32 = 4, int32 = 5, int64 = 6 };

[[nodiscard]] constexpr std::int64_t size_of(Scalar scalar) noexcept {
    return scalar == Scalar::float64 || scalar == Scalar::int64 ? 8 : scalar == Scalar::uint8 ? 1 : 4;
}

namespace detail {

template <class T>
[[nodiscard]] inline double read_as(const std::byte* from) noexcept {
    T value;
    std::memcpy(&value, from, sizeof value); // memcpy, because the caller's elements may be unaligned
    return static_cast<double>(value);
}

template <class T>
inline void write_as(std::byte* to, double number) noexcept {
    const T value = static_cast<T>(number);
    std::memcpy(to, &value, sizeof value);
}

} // namespace detail

struct InView {
    const std::byte* data = nullptr;
    std::int64_t count = 0;
    std::int64_t stride = 0; // in bytes; never 0 if count > 0
    Scalar scalar = Scalar::float64;
    std::uint32_t components = 0;

    [[nodiscard]] bool empty() const noexcept { return count == 0; }
    [[nodiscard]] double get(std::int64_t i, std::uint32_t component) const noexcept {
        const std::byte* at = data + i * stride + static_cast<std::int64_t>(component) * size_of(scalar);
        switch (scalar) {
        case Scalar::float32: return detail::read_as<float>(at);
        case Scalar::float64: return detail::read_as<double>(at);
        case Scalar::uint8: return detail::read_as<std::uint8_t>(at);
        case Scalar::uint32: return detail::read_as<std::uint32_t>(at);
        case Scalar::int32: return detail::read_as<std::int32_t>(at);
        case Scalar::int64: return detail::read_as<std::int64_t>(at);
        }
        return 0.0;
    }
    // Returns an element of a view of integers, exactly even for int64.
    [[nodiscard]] std::int64_t get_integer(std::int64_t i, std::uint32_t component) const noexcept {
        if (scalar != Scalar::int64) return static_cast<std::int64_t>(get(i, component));
        std::int64_t value = 0;
        std::memcpy(&value, data + i * stride + static_cast<std::int64_t>(component) * size_of(scalar), sizeof value);
        return value;
    }
};

struct OutView {
    std::byte* data = nullptr; // nullptr if the caller does not want this output
    std::int64_t count = 0;
    std::int64_t stride = 0;
    Scalar scalar = Scalar::float64;
    std::uint32_t components = 0;

    [[nodiscard]] explicit operator bool() const noexcept { return data != nullptr; }
    void set(std::int64_t i, std::uint32_t component, double number) const noexcept {
        std::byte* at = data + i * stride + static_cast<std::int64_t>(component) * size_of(scalar);
        switch (scalar) {
        case Scalar::float32: detail::write_as<float>(at, number); break;
        case Scalar::float64: detail::write_as<double>(at, number); break;
        case Scalar::uint8: detail::write_as<std::uint8_t>(at, number); break;
        case Scalar::uint32: detail::write_as<std::uint32_t>(at, number); break;
        case Scalar::int32: detail::write_as<std::int32_t>(at, number); break;
        case Scalar::int64: detail::write_as<std::int64_t>(at, number); break;
        }
    }
};

} // namespace hrbfnpr::base
