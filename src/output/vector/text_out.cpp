// SPDX-License-Identifier: MIT
#include "output/vector/text_out.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace hrbfnpr::output {
namespace {

constexpr double largest = 1e15; // thousandths that a double tells apart

[[nodiscard]] std::string_view between(const char* begin, const char* end) noexcept {
    return {begin, static_cast<std::size_t>(end - begin)};
}

// Writes nine decimals.
[[nodiscard]] char* write_fixed(char* begin, char* end, double number) noexcept {
#if defined(__EMSCRIPTEN__) // its library cannot write doubles this way, and has one locale only
    return begin + std::snprintf(begin, static_cast<std::size_t>(end - begin), "%.9f", number);
#else
    return std::to_chars(begin, end, number, std::chars_format::fixed, 9).ptr;
#endif
}

} // namespace

std::int64_t in_thousandths(double number) noexcept {
    return static_cast<std::int64_t>(std::floor(std::clamp(1000.0 * number, -largest, largest) + 0.5));
}

TextOut& TextOut::operator<<(std::string_view text) {
    while (!text.empty()) {
        if (used_ == room) flush();
        const std::size_t part = std::min(text.size(), static_cast<std::size_t>(room - used_));
        std::memcpy(buffer_ + used_, text.data(), part);
        used_ += static_cast<std::int64_t>(part);
        text.remove_prefix(part);
    }
    return *this;
}

TextOut& TextOut::operator<<(std::int64_t number) {
    char digits[24];
    return *this << between(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

TextOut& TextOut::thousandths(std::int64_t number) {
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
    return *this << between(digits, end);
}

TextOut& TextOut::operator<<(double number) { return thousandths(in_thousandths(number)); }

TextOut& TextOut::precise(double number) {
    char digits[64];
    const double known = std::clamp(number, -largest, largest);
    return *this << between(digits, write_fixed(digits, digits + sizeof digits, known));
}

TextOut& TextOut::escaped(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const std::string_view three = text.substr(i, 3);
        if (three == "\xEF\xBF\xBE" || three == "\xEF\xBF\xBF") { // U+FFFE and U+FFFF, which XML does not allow
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

void TextOut::flush() {
    if (used_ == 0) return;
    const std::int64_t size = used_;
    bytes_ += size;
    used_ = 0;
    writer_.write(buffer_, static_cast<std::uint64_t>(size));
}

} // namespace hrbfnpr::output
