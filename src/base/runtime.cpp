// SPDX-License-Identifier: MIT
#include "base/runtime.h"

#include "base/format.h"

#include <cstdarg>

namespace hrbfnpr::base {

void Runtime::log(LogLevel level, const char* format, ...) const noexcept {
    if (log_ == nullptr || level < least_level_) return;
    char text[512];
    std::va_list arguments;
    va_start(arguments, format);
    format_text(text, sizeof text, format, arguments);
    va_end(arguments);
    log_(log_user_, static_cast<std::int32_t>(level), text);
}

} // namespace hrbfnpr::base
