// SPDX-License-Identifier: MIT
// The only exception barrier: every exported function that can fail runs inside guarded().
#pragma once

#include "base/fp_state.h"
#include "base/status.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

// Converts an exception into a status, and into a message if the caller's struct has room. Must be called inside a
// catch block. Never throws.
hrbfnpr_status report_exception(hrbfnpr_error* error) noexcept;

// Calls body() in the default floating-point state, and converts exceptions into a status.
template <class F>
hrbfnpr_status guarded(hrbfnpr_error* error, F&& body) noexcept {
    const base::FpGuard guard;
    try {
        body();
    } catch (...) {
        return report_exception(error);
    }
    return HRBFNPR_STATUS_OK;
}

template <class T>
void require_pointer(const T* pointer, const char* name) {
    if (pointer == nullptr) fail(Status::invalid_argument, "%s is NULL", name);
}

template <class T>
[[nodiscard]] T& deref(T* pointer, const char* name) {
    require_pointer(pointer, name);
    return *pointer;
}

// Runs make(), which makes a handle, as guarded() runs body(). *out is NULL unless make() returns a handle.
template <class T, class F>
hrbfnpr_status guarded_create(T** out, const char* name, hrbfnpr_error* error, F&& make) noexcept {
    if (out != nullptr) *out = nullptr;
    return guarded(error, [&] {
        require_pointer(out, name);
        *out = make();
    });
}

} // namespace hrbfnpr::api
