// SPDX-License-Identifier: MIT
// Buffered text output to a stream; numbers do not depend on the locale.
#pragma once

#include "io/stream.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace hrbfnpr::output {

// The largest number of thousandths that is written; a double represents it exactly.
inline constexpr double most_thousandths = 1e15;

// Rounds to thousandths of a millimetre, the unit of all output.
[[nodiscard]] inline std::int64_t in_thousandths(double number) noexcept {
    return static_cast<std::int64_t>(
        std::floor(std::clamp(1000.0 * number, -most_thousandths, most_thousandths) + 0.5));
}

class TextOut {
public:
    explicit TextOut(io::Writer& writer) noexcept : writer_(writer) {}

    TextOut& operator<<(std::string_view text) {
        while (!text.empty()) {
            if (used_ == room) flush();
            const std::size_t part = std::min(text.size(), static_cast<std::size_t>(room - used_));
            std::memcpy(buffer_ + used_, text.data(), part);
            used_ += static_cast<std::int64_t>(part);
            text.remove_prefix(part);
        }
        return *this;
    }
    TextOut& operator<<(char one) { return *this << std::string_view(&one, 1); }
    TextOut& operator<<(std::int64_t number) {
        char digits[24];
        return *this << until(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
    }
    TextOut& hexadecimal(std::uint64_t number) {
        char digits[24];
        char* const end = std::to_chars(digits, digits + sizeof digits, number, 16).ptr;
        for (char* digit = digits; digit < end; ++digit)
            if (*digit >= 'a') *digit = static_cast<char>(*digit - 'a' + 'A');
        return *this << until(digits, end);
    }
    // Writes number / 1000 as a decimal without trailing zeros; for example, 1500 becomes 1.5.
    TextOut& thousandths(std::int64_t number) {
        char digits[32];
        char* end = digits;
        if (number < 0) *end++ = '-';
        const std::int64_t size = number < 0 ? -number : number;
        if (size >= 1000 || size == 0) end = std::to_chars(end, digits + sizeof digits, size / 1000).ptr;
        if (std::int64_t rest = size % 1000; rest != 0) {
            *end++ = '.';
            for (std::int64_t unit = 100; rest != 0; unit /= 10) {
                *end++ = static_cast<char>('0' + rest / unit);
                rest %= unit;
            }
        }
        return *this << until(digits, end);
    }
    // Writes a number, rounded to thousandths.
    TextOut& operator<<(double number) { return thousandths(in_thousandths(number)); }
    // Writes a number with nine decimals, as a matrix needs.
    TextOut& precise(double number) {
        char digits[64];
        const double known = std::clamp(number, -most_thousandths, most_thousandths);
// Emscripten's std::to_chars cannot write doubles with a fixed number of decimals; its snprintf does not depend on the
// host's locale, because Emscripten has only one locale.
#if defined(__EMSCRIPTEN__)
        return *this << std::string_view(digits,
                                         static_cast<std::size_t>(std::snprintf(digits, sizeof digits, "%.9f", known)));
#else
        return *this << until(digits,
                              std::to_chars(digits, digits + sizeof digits, known, std::chars_format::fixed, 9).ptr);
#endif
    }
    // Writes the five characters that XML reserves as entities, and control characters as spaces.
    TextOut& escaped(std::string_view text) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            const char c = text[i];
            const std::string_view three = text.substr(i, 3);
            // U+FFFE and U+FFFF are not allowed in XML.
            if (three == "\xEF\xBF\xBE" || three == "\xEF\xBF\xBF") {
                *this << "\xEF\xBF\xBD";
                i += 2;
                continue;
            }
            switch (c) {
            case '&': *this << "&amp;"; break;
            case '<': *this << "&lt;"; break;
            case '>': *this << "&gt;"; break;
            case '"': *this << "&quot;"; break;
            case '\'': *this << "&#39;"; break;
            default: {
                const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t';
                *this << (control ? ' ' : c);
            }
            }
        }
        return *this;
    }

    void flush() {
        if (used_ == 0) return;
        const std::int64_t size = used_;
        bytes_ += size;
        used_ = 0;
        writer_.write(buffer_, static_cast<std::uint64_t>(size));
    }
    [[nodiscard]] std::int64_t bytes() const noexcept { return bytes_ + used_; }

private:
    static constexpr std::int64_t room = 16384;

    [[nodiscard]] static std::string_view until(const char* begin, const char* end) noexcept {
        return {begin, static_cast<std::size_t>(end - begin)};
    }

    io::Writer& writer_;
    std::int64_t used_ = 0, bytes_ = 0;
    char buffer_[room];
};

} // namespace hrbfnpr::output
