// SPDX-License-Identifier: MIT
// Arrays in the forms that callers may have: floats or doubles, packed or with gaps, unaligned, forward or reversed.
#pragma once

#include "fuzz.h"
#include "input.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuzz {

// Numbers that a descriptor can refer to while this object exists.
class Array {
public:
    Array(std::span<const double> numbers, std::uint32_t components, Input& input)
        : Array(numbers, components, input.below(8)) {}
    // `form` has bits for floats, gaps and the reverse order.
    Array(std::span<const double> numbers, std::uint32_t components, std::size_t form = 0) {
        const auto count = static_cast<std::int64_t>(numbers.size() / components);
        const bool is_float = (form & 1U) != 0;
        const std::size_t scalar = is_float ? sizeof(float) : sizeof(double);
        const std::size_t stride = scalar * components + ((form & 2U) != 0 ? 3 : 0);
        bytes_.resize(stride * static_cast<std::size_t>(count) + 1);
        const bool is_turned = (form & 4U) != 0 && count > 0;
        for (std::int64_t i = 0; i < count; ++i) {
            std::uint8_t* const element = &bytes_[1 + stride * static_cast<std::size_t>(is_turned ? count - 1 - i : i)];
            for (std::size_t k = 0; k < components; ++k)
                put(element + k * scalar, numbers[static_cast<std::size_t>(i) * components + k], is_float);
        }
        view = {&bytes_[1 + (is_turned ? stride * static_cast<std::size_t>(count - 1) : 0)], count,
                is_turned ? -static_cast<std::int64_t>(stride) : static_cast<std::int64_t>(stride),
                is_float ? HRBFNPR_SCALAR_FLOAT32 : HRBFNPR_SCALAR_FLOAT64, components};
    }
    Array(const Array&) = delete;
    Array& operator=(const Array&) = delete;

    hrbfnpr_array view{};

private:
    static void put(std::uint8_t* at, double number, bool is_float) {
        const double largest = static_cast<double>(std::numeric_limits<float>::max());
        const auto small = static_cast<float>(std::isfinite(number) ? std::clamp(number, -largest, largest) : number);
        if (is_float)
            std::memcpy(at, &small, sizeof small);
        else
            std::memcpy(at, &number, sizeof number);
    }

    Bytes bytes_;
};

// Memory for a result. It is filled with a pattern, which shows whether anything was written.
class Room {
public:
    Room(std::int64_t count, std::uint32_t components, std::uint32_t scalar)
        : bytes_(static_cast<std::size_t>(count) * components * size_of(scalar), pattern), out{bytes_.data(), count, 0,
                                                                                               scalar, components} {}
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;

    [[nodiscard]] bool is_untouched() const {
        return std::all_of(bytes_.begin(), bytes_.end(), [](std::uint8_t byte) { return byte == pattern; });
    }
    // Returns the contents as numbers of type T, which must match the scalar.
    template <class T>
    [[nodiscard]] std::vector<T> numbers() const {
        std::vector<T> numbers(bytes_.size() / sizeof(T));
        if (!bytes_.empty()) std::memcpy(numbers.data(), bytes_.data(), bytes_.size());
        return numbers;
    }
    [[nodiscard]] bool is_finite() const {
        if (out.scalar == HRBFNPR_SCALAR_FLOAT32) return all_finite(numbers<float>());
        return out.scalar != HRBFNPR_SCALAR_FLOAT64 || all_finite(numbers<double>());
    }

private:
    static constexpr std::uint8_t pattern = 0xA7;

    static std::size_t size_of(std::uint32_t scalar) {
        if (scalar == HRBFNPR_SCALAR_UINT8) return 1;
        return scalar == HRBFNPR_SCALAR_FLOAT64 || scalar == HRBFNPR_SCALAR_INT64 ? 8 : 4;
    }
    template <class T>
    static bool all_finite(const std::vector<T>& numbers) {
        return std::all_of(numbers.begin(), numbers.end(), [](T number) { return std::isfinite(number); });
    }

    Bytes bytes_;

public:
    hrbfnpr_array_out out;
};

} // namespace fuzz
