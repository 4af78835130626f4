// SPDX-License-Identifier: MIT
// Text to a stream, a buffer at a time; numbers alike in every locale.
#pragma once

#include "io/stream.h"

#include <cstdint>
#include <string_view>

namespace hrbfnpr::output {

class TextOut {
public:
    explicit TextOut(io::Writer& writer) noexcept : writer_(writer) {}

    TextOut& operator<<(std::string_view text);
    TextOut& operator<<(char one) { return *this << std::string_view(&one, 1); }
    TextOut& operator<<(std::int64_t number);
    // Writes a number of thousandths, without zeros at its end.
    TextOut& thousandths(std::int64_t number);
    // Rounds to thousandths.
    TextOut& operator<<(double number);
    // Writes nine decimals, as a matrix needs.
    TextOut& precise(double number);
    // Writes the five characters that XML reserves as entities, and controls as spaces.
    TextOut& escaped(std::string_view text);

    void flush();
    [[nodiscard]] std::int64_t bytes() const noexcept { return bytes_ + used_; }

private:
    static constexpr std::int64_t room = 16384;

    io::Writer& writer_;
    std::int64_t used_ = 0, bytes_ = 0;
    char buffer_[room];
};

// To thousandths of a millimetre, the unit of all that is written.
[[nodiscard]] std::int64_t in_thousandths(double number) noexcept;

} // namespace hrbfnpr::output
