// SPDX-License-Identifier: MIT
// Wraps the library's own handles as values, and its calls as functions that throw.
//
// The picture code uses only hrbfnpr.h, so a caller can do everything that the picture code does.
#pragma once

#include "base/status.h"

#include <hrbfnpr.h>

#include <utility>

namespace hrbfnpr::picture {

// Calls the library: f(&error) returns a status. If the call fails, its error is thrown as an Error.
template <class F>
void call(F&& f) {
    hrbfnpr_error error;
    hrbfnpr_error_init(&error, sizeof error);
    const hrbfnpr_status status = f(&error);
    if (status != HRBFNPR_STATUS_OK) throw Error(static_cast<Status>(status), error.message);
}

// Returns a descriptor with its defaults: defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init).
template <class T, class Init>
[[nodiscard]] T defaults(Init init) noexcept {
    T made;
    init(&made, sizeof made);
    return made;
}

// Owns one reference to a handle, or is null.
template <class T, auto retain, auto release>
class Handle {
public:
    Handle() noexcept = default;
    // Becomes the owner of a reference that the caller owned.
    explicit Handle(T* owned) noexcept : handle_(owned) {}
    Handle(const Handle& other) noexcept : handle_(other.handle_) { retain(handle_); }
    Handle(Handle&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Handle& operator=(Handle other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Handle() { release(handle_); }

    // Returns a second owner of a handle, by adding a reference.
    [[nodiscard]] static Handle shared(const T* handle) noexcept {
        auto* const own = const_cast<T*>(handle);
        retain(own);
        return Handle(own);
    }

    [[nodiscard]] T* get() const noexcept { return handle_; }
    [[nodiscard]] explicit operator bool() const noexcept { return handle_ != nullptr; }
    [[nodiscard]] bool operator==(const Handle& other) const noexcept { return handle_ == other.handle_; }
    // Passes the reference to the caller. This handle becomes null.
    [[nodiscard]] T* take() noexcept { return std::exchange(handle_, nullptr); }

private:
    T* handle_ = nullptr;
};

using Model = Handle<hrbfnpr_model, hrbfnpr_model_retain, hrbfnpr_model_release>;
using PointSet = Handle<hrbfnpr_point_set, hrbfnpr_point_set_retain, hrbfnpr_point_set_release>;
using Field = Handle<hrbfnpr_field, hrbfnpr_field_retain, hrbfnpr_field_release>;
using LineSet = Handle<hrbfnpr_line_set, hrbfnpr_line_set_retain, hrbfnpr_line_set_release>;
using Occluders = Handle<hrbfnpr_occluders, hrbfnpr_occluders_retain, hrbfnpr_occluders_release>;
using Shading = Handle<hrbfnpr_shading, hrbfnpr_shading_retain, hrbfnpr_shading_release>;
using Mesh = Handle<hrbfnpr_mesh, hrbfnpr_mesh_retain, hrbfnpr_mesh_release>;
using Drawing = Handle<hrbfnpr_drawing, hrbfnpr_drawing_retain, hrbfnpr_drawing_release>;
using Renderer = Handle<hrbfnpr_renderer, hrbfnpr_renderer_retain, hrbfnpr_renderer_release>;
using Context = Handle<hrbfnpr_context, hrbfnpr_context_retain, hrbfnpr_context_release>;

// Makes a handle by a call of the library: f(&handle, &error) returns its status.
template <class H, class F>
[[nodiscard]] H make(F&& f) {
    decltype(std::declval<H>().get()) made = nullptr;
    call([&](hrbfnpr_error* error) { return f(&made, error); });
    return H(made);
}

} // namespace hrbfnpr::picture
