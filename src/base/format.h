// SPDX-License-Identifier: MIT
// Formats the text of messages.
#pragma once

#include <cstdarg>
#include <cstddef>

namespace hrbfnpr::base {

// Works like vsnprintf in the C locale, so that messages are the same in a host whose locale writes 0,5.
[[gnu::format(printf, 3, 0)]] void format_text(char* destination, std::size_t capacity, const char* format,
                                               std::va_list arguments) noexcept;

} // namespace hrbfnpr::base
