// SPDX-License-Identifier: MIT
// The C handles as owning C++ objects, and calls that throw with the message; for tests and benchmarks.
#pragma once

#include <hrbfnpr.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

namespace hrbfnpr::test {

struct Release {
    void operator()(hrbfnpr_context* handle) const { hrbfnpr_context_release(handle); }
    void operator()(hrbfnpr_operation* handle) const { hrbfnpr_operation_release(handle); }
    void operator()(const hrbfnpr_model* handle) const { hrbfnpr_model_release(handle); }
    void operator()(const hrbfnpr_point_set* handle) const { hrbfnpr_point_set_release(handle); }
    void operator()(const hrbfnpr_line_set* handle) const { hrbfnpr_line_set_release(handle); }
    void operator()(const hrbfnpr_field* handle) const { hrbfnpr_field_release(handle); }
    void operator()(const hrbfnpr_occluders* handle) const { hrbfnpr_occluders_release(handle); }
    void operator()(const hrbfnpr_shading* handle) const { hrbfnpr_shading_release(handle); }
    void operator()(const hrbfnpr_mesh* handle) const { hrbfnpr_mesh_release(handle); }
    void operator()(hrbfnpr_renderer* handle) const { hrbfnpr_renderer_release(handle); }
    void operator()(const hrbfnpr_drawing* handle) const { hrbfnpr_drawing_release(handle); }
    void operator()(hrbfnpr_picture* handle) const { hrbfnpr_picture_release(handle); }
    void operator()(const hrbfnpr_settings* handle) const { hrbfnpr_settings_release(handle); }
};

using Context = std::unique_ptr<hrbfnpr_context, Release>;
using Operation = std::unique_ptr<hrbfnpr_operation, Release>;
using Model = std::unique_ptr<hrbfnpr_model, Release>;
using PointSet = std::unique_ptr<hrbfnpr_point_set, Release>;
using LineSet = std::unique_ptr<hrbfnpr_line_set, Release>;
using Field = std::unique_ptr<const hrbfnpr_field, Release>;
using Occluders = std::unique_ptr<const hrbfnpr_occluders, Release>;
using Shading = std::unique_ptr<const hrbfnpr_shading, Release>;
using Mesh = std::unique_ptr<hrbfnpr_mesh, Release>;
using Renderer = std::unique_ptr<hrbfnpr_renderer, Release>;
using Drawing = std::unique_ptr<hrbfnpr_drawing, Release>;
using Picture = std::unique_ptr<hrbfnpr_picture, Release>;
using Settings = std::unique_ptr<hrbfnpr_settings, Release>;

// The error argument of a call. It throws with the status's name and the message.
class Check {
public:
    Check() { hrbfnpr_error_init(&error_, sizeof error_); }
    [[nodiscard]] hrbfnpr_error* error() { return &error_; }
    void operator()(hrbfnpr_status status) const {
        if (status != HRBFNPR_STATUS_OK)
            throw std::runtime_error(std::string(hrbfnpr_status_name(status)) + ": " + error_.message);
    }

private:
    hrbfnpr_error error_;
};

// Returns a struct that its `_init` function has initialised: made(hrbfnpr_style_init).
template <class T>
[[nodiscard]] T made(hrbfnpr_status (*init)(T*, std::uint32_t)) {
    T value;
    Check()(init(&value, sizeof value));
    return value;
}

} // namespace hrbfnpr::test

// The names that the scenes and the benchmarks use.
namespace scenes {
using hrbfnpr::test::Check;
using hrbfnpr::test::Context;
using hrbfnpr::test::Drawing;
using hrbfnpr::test::LineSet;
using hrbfnpr::test::made;
using hrbfnpr::test::Model;
using hrbfnpr::test::PointSet;
using hrbfnpr::test::Renderer;
} // namespace scenes
