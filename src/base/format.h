// SPDX-License-Identifier: MIT
// Formats the text of messages.
#pragma once

#include <cstdarg>
#include <cstddef>

namespace hrbfnpr::base {

// Does what vsnprintf does in the C locale, so that a message reads the same in a host that writes 0,5.
[[gnu::format(printf, 3, 0)]] void format_text(char* destination, std::size_t capacity, const char* format,
                                               std::va_list arguments) noexcept;

} // namespace hrbfnpr::base
