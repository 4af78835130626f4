// SPDX-License-Identifier: MIT
// Formats the text of messages.
#pragma once

#include <cstdarg>
#include <cstddef>

// HRBFNPR_PRINTF_LIKE(F, A) goes before the declaration of a function whose parameter F is a format of the C standard,
// and whose arguments begin at parameter A, or are a va_list if A is 0. The compiler then checks the arguments. On
// Windows, `printf` would mean the formats of Microsoft's old C library, which lack %zu.
#if defined(__MINGW32__) && !defined(__clang__)
#define HRBFNPR_PRINTF_LIKE(format_parameter, first_argument)                                                          \
    [[gnu::format(gnu_printf, format_parameter, first_argument)]]
#elif defined(__GNUC__)
#define HRBFNPR_PRINTF_LIKE(format_parameter, first_argument) [[gnu::format(printf, format_parameter, first_argument)]]
#else
#define HRBFNPR_PRINTF_LIKE(format_parameter, first_argument)
#endif

namespace hrbfnpr::base {

// Works like vsnprintf in the C locale, so that messages are the same in a host whose locale writes 0,5.
HRBFNPR_PRINTF_LIKE(3, 0)
void format_text(char* destination, std::size_t capacity, const char* format, std::va_list arguments) noexcept;

} // namespace hrbfnpr::base
