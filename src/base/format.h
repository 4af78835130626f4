// SPDX-License-Identifier: MIT
// Text of messages.
#pragma once

#include <cstdarg>
#include <cstddef>

namespace hrbfnpr::base {

// vsnprintf as in the C locale: a message reads the same in a host that writes 0,5.
[[gnu::format(printf, 3, 0)]] void format_text(char* destination, std::size_t capacity, const char* format,
                                               std::va_list arguments) noexcept;

} // namespace hrbfnpr::base
