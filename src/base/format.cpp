// SPDX-License-Identifier: MIT
#include "base/format.h"

#include <clocale>
#include <cstdio>
#include <cstring>

#if defined(__APPLE__)
#include <xlocale.h>
#elif defined(__unix__)
#include <locale.h>
#endif

namespace hrbfnpr::base {

#if defined(_WIN32)
// The functions of Microsoft's C library that take a locale are not used, because the old library lacks %zu, and writes
// 1e-005 for 1e-05. Here setlocale changes only the locale of this thread.
void format_text(char* destination, std::size_t capacity, const char* format, std::va_list arguments) noexcept {
    const int mode = _configthreadlocale(_ENABLE_PER_THREAD_LOCALE);
    char hosts[256] = "C";
    if (const char* const current = setlocale(LC_NUMERIC, nullptr); current != nullptr)
        std::strncpy(hosts, current, sizeof hosts - 1);
    setlocale(LC_NUMERIC, "C");
    std::vsnprintf(destination, capacity, format, arguments);
    setlocale(LC_NUMERIC, hosts); // restore the host's locale for this thread
    if (mode != -1) _configthreadlocale(mode);
}
#else
void format_text(char* destination, std::size_t capacity, const char* format, std::va_list arguments) noexcept {
    const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
    const locale_t hosts = plain != nullptr ? uselocale(plain) : nullptr;
    std::vsnprintf(destination, capacity, format, arguments);
    if (plain == nullptr) return;
    uselocale(hosts); // restore the host's locale for this thread
    freelocale(plain);
}
#endif

} // namespace hrbfnpr::base
