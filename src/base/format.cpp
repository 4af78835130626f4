// SPDX-License-Identifier: MIT
#include "base/format.h"

#include <clocale>
#include <cstdio>

#if defined(__APPLE__)
#include <xlocale.h>
#elif defined(__unix__)
#include <locale.h>
#endif

namespace hrbfnpr::base {

#if defined(_WIN32)
void format_text(char* destination, std::size_t capacity, const char* format, std::va_list arguments) noexcept {
    const _locale_t plain = _create_locale(LC_ALL, "C");
    if (_vsnprintf_l(destination, capacity, format, plain, arguments) < 0 && capacity > 0)
        destination[capacity - 1] = '\0';
    _free_locale(plain);
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
