// SPDX-License-Identifier: MIT
// Decisions from the bytes of an input. Beyond its end all bytes are 0, which selects the ordinary choice: a short
// input is a call with defaults.
#pragma once

#include "odd.h"

#include <cstring>
#include <string>
#include <vector>

namespace fuzz {

class Input {
public:
    Input(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

    std::uint8_t byte() {
        if (left_ == 0) return 0;
        --left_;
        return *data_++;
    }
    [[nodiscard]] bool is_empty() const { return left_ == 0; }

    // A number from 0 to count - 1; 0 if no bytes are left.
    std::size_t below(std::size_t count) {
        std::size_t number = byte();
        for (std::size_t reach = 256; reach < count; reach *= 256) number = number * 256 + byte();
        return number % count;
    }
    // True once in `times` calls; never if no bytes are left.
    bool once_in(std::size_t times) { return below(times) == times - 1; }

    std::uint64_t next() {
        std::uint64_t bits = 0;
        for (int i = 0; i < 8; ++i) bits = bits << 8U | byte();
        return bits;
    }
    // A number from 0 to 1.
    double unit() { return static_cast<double>(below(65536)) / 65535.0; }
    double between(double low, double high) { return low + (high - low) * unit(); }

    template <class T, std::size_t n>
    const T& one_of(const T (&list)[n]) {
        return list[below(n)];
    }

private:
    const std::uint8_t* data_;
    std::size_t left_;
};

} // namespace fuzz
