// SPDX-License-Identifier: MIT
#include "base/status.h"

#include "base/format.h"

#include <cstdarg>
#include <cstring>

namespace hrbfnpr {

void copy_message(char* destination, int capacity, const char* text) noexcept {
    auto length = static_cast<int>(std::strlen(text));
    if (length >= capacity) {
        length = capacity - 1;
        // Step back over the continuation bytes of UTF-8, so that no character is cut in two.
        while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) --length;
    }
    std::memcpy(destination, text, static_cast<std::size_t>(length));
    destination[length] = '\0';
}

Error::Error(Status status, const char* message) noexcept : status_(status) {
    copy_message(message_, message_capacity, message);
}

void fail(Status status, const char* format, ...) {
    char text[2 * Error::message_capacity];
    std::va_list arguments;
    va_start(arguments, format);
    base::format_text(text, sizeof text, format, arguments);
    va_end(arguments);
    throw Error(status, text);
}

} // namespace hrbfnpr
