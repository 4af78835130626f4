// SPDX-License-Identifier: MIT
#include "base/shared_object.h"

#if defined(_WIN32)
#include "base/windows.h"
#endif
// Emscripten has dladdr, but calling it ends the program.
#if __has_include(<dlfcn.h>) && !defined(__EMSCRIPTEN__)
#include <dlfcn.h>
#define HRBFNPR_HAS_SHARED_OBJECTS 1
#endif

namespace hrbfnpr::base {

#if defined(_WIN32)

// The last handle to a DLL cannot be released by code of that DLL, because the code would be gone when the call
// returns. So the DLL stays in memory until the process ends.
void* hold_shared_object(const void* address) noexcept {
    keep_shared_object(address);
    return nullptr;
}

void release_shared_object(void* /*held*/) noexcept {}

void keep_shared_object(const void* address) noexcept {
    HMODULE module = nullptr;
    GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_PIN,
                       static_cast<LPCWSTR>(address), &module);
}

#elif defined(HRBFNPR_HAS_SHARED_OBJECTS)

namespace {

void* open_again(const void* address, int flags) noexcept {
    Dl_info object{};
    if (dladdr(address, &object) == 0 || object.dli_fname == nullptr) return nullptr;
    return dlopen(object.dli_fname, RTLD_LAZY | RTLD_NOLOAD | flags);
}

} // namespace

void* hold_shared_object(const void* address) noexcept { return open_again(address, 0); }

void release_shared_object(void* held) noexcept {
    if (held != nullptr) dlclose(held);
}

void keep_shared_object(const void* address) noexcept { release_shared_object(open_again(address, RTLD_NODELETE)); }

#else

void* hold_shared_object(const void* /*address*/) noexcept { return nullptr; }
void release_shared_object(void* /*held*/) noexcept {}
void keep_shared_object(const void* /*address*/) noexcept {}

#endif

} // namespace hrbfnpr::base
