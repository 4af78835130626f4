// SPDX-License-Identifier: MIT
// Parts that the tests of the C boundary share: handles, small models, views of vectors.
#pragma once

#include "scenes/shapes.h"
#include "support/allocator.h"
#include "support/generation.h"
#include "support/handles.h"
#include "support/test_backend.h"
#include "support/watcher.h"

#include <gtest/gtest.h>
#include <hrbfnpr.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace api_test {

using hrbfnpr::test::Allocator;
using hrbfnpr::test::Context;
using hrbfnpr::test::Drawing;
using hrbfnpr::test::Generation;
using hrbfnpr::test::made;
using hrbfnpr::test::Mesh;
using hrbfnpr::test::Model;
using hrbfnpr::test::one_layer;
using hrbfnpr::test::Operation;
using hrbfnpr::test::Picture;
using hrbfnpr::test::PointSet;
using hrbfnpr::test::Renderer;
using hrbfnpr::test::Settings;
using hrbfnpr::test::Watcher;

// An error record with the message of the last call.
struct Error {
    Error() { hrbfnpr_error_init(&record, sizeof record); }
    operator hrbfnpr_error*() { return &record; } // NOLINT: stands for the last argument of every call
    hrbfnpr_error record;
};

// EXPECT_OK(hrbfnpr_...(…, error)) with an Error named `error` in scope.
#define EXPECT_OK(call) EXPECT_EQ((call), HRBFNPR_STATUS_OK) << error.record.message
#define ASSERT_OK(call) ASSERT_EQ((call), HRBFNPR_STATUS_OK) << error.record.message

// Expects that a call fails with a status, and that the message contains a part.
#define EXPECT_FAILS(call, wanted, part)                                                                               \
    do {                                                                                                               \
        const hrbfnpr_status got_ = (call);                                                                            \
        EXPECT_STREQ(hrbfnpr_status_name(got_), hrbfnpr_status_name(wanted)) << error.record.message;                  \
        EXPECT_NE(std::string(error.record.message).find(part), std::string::npos)                                     \
            << "message: " << error.record.message << "\nwanted:  " << (part);                                         \
    } while (false)

template <class T>
constexpr std::uint32_t scalar_of() {
    if constexpr (std::is_same_v<T, float>)
        return HRBFNPR_SCALAR_FLOAT32;
    else if constexpr (std::is_same_v<T, double>)
        return HRBFNPR_SCALAR_FLOAT64;
    else if constexpr (std::is_same_v<T, std::uint8_t>)
        return HRBFNPR_SCALAR_UINT8;
    else if constexpr (std::is_same_v<T, std::int32_t>)
        return HRBFNPR_SCALAR_INT32;
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return HRBFNPR_SCALAR_INT64;
    else {
        static_assert(std::is_same_v<T, std::uint32_t>);
        return HRBFNPR_SCALAR_UINT32;
    }
}

template <class T>
hrbfnpr_array in(const std::vector<T>& data, std::uint32_t components = 3) {
    return {data.data(), static_cast<std::int64_t>(data.size() / components), 0, scalar_of<T>(), components};
}

template <class T>
hrbfnpr_array_out out(std::vector<T>& data, std::uint32_t components = 3) {
    return {data.data(), static_cast<std::int64_t>(data.size() / components), 0, scalar_of<T>(), components};
}

inline Context make_context(std::int32_t threads = 2) {
    Error error;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = threads;
    desc.thread_backend = hrbfnpr::test::test_backend();
    hrbfnpr_context* context = nullptr;
    EXPECT_OK(hrbfnpr_context_create(&desc, &context, error));
    return Context(context);
}

inline Operation make_operation(const Context& context) {
    Error error;
    hrbfnpr_operation* operation = nullptr;
    EXPECT_OK(hrbfnpr_operation_create(context.get(), &operation, error));
    return Operation(operation);
}

inline hrbfnpr_fit_desc fit_desc(const scenes::Samples& samples) {
    auto desc = made(hrbfnpr_fit_desc_init);
    desc.points = in(samples.points);
    desc.normals = in(samples.normals);
    return desc;
}

inline Model fit(const Context& context, const scenes::Samples& samples) {
    Error error;
    const hrbfnpr_fit_desc desc = fit_desc(samples);
    hrbfnpr_model* model = nullptr;
    EXPECT_OK(hrbfnpr_model_fit(context.get(), &desc, nullptr, &model, error));
    return Model(model);
}

// The layers of small_desc().
enum : std::int64_t { stipples = 0, by_curvature = 1, by_combing = 2 };

// Stipples, hatching by curvature and hatching by combing, with few marks.
inline Generation small_desc(std::uint32_t distribution = HRBFNPR_DISTRIBUTION_BLUE_NOISE) {
    Generation desc = hrbfnpr::test::three_layers(distribution == HRBFNPR_DISTRIBUTION_BLUE_NOISE ? 300 : 0);
    desc.distribution = distribution;
    for (hrbfnpr_layer_desc& layer : desc.layer) layer.levels = 2;
    return desc;
}

inline PointSet generate(const Context& context, const Model& model, Generation desc) {
    Error error;
    hrbfnpr_point_set* set = nullptr;
    EXPECT_OK(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &set, error));
    return PointSet(set);
}

inline hrbfnpr_point_set_info info_of(const PointSet& set) {
    Error error;
    auto info = made(hrbfnpr_point_set_info_init);
    EXPECT_OK(hrbfnpr_point_set_get_info(set.get(), &info, error));
    return info;
}

inline hrbfnpr_layer_info layer_info(const PointSet& set, std::int64_t layer) {
    Error error;
    auto info = made(hrbfnpr_layer_info_init);
    EXPECT_OK(hrbfnpr_point_set_get_layer_info(set.get(), layer, &info, error));
    return info;
}

inline Renderer make_renderer(const Context& context) {
    Error error;
    hrbfnpr_renderer* renderer = nullptr;
    EXPECT_OK(hrbfnpr_renderer_create(context.get(), &renderer, error));
    return Renderer(renderer);
}

// A camera that sees a box of +-1.5 from the front, in size x size pixels.
inline hrbfnpr_camera front_camera(double size = 64.0) {
    Error error;
    auto camera = made(hrbfnpr_camera_init);
    const double low[3] = {-1.5, -1.5, -1.5};
    const double high[3] = {1.5, 1.5, 1.5};
    const double direction[3] = {0.0, 0.3, -1.0};
    const double up[3] = {0.0, 1.0, 0.0};
    EXPECT_OK(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.6, size, size, 0.05, error));
    return camera;
}

inline hrbfnpr_item item_of(const PointSet& set, const hrbfnpr_style* style = nullptr) {
    auto item = made(hrbfnpr_item_init);
    item.point_set = set.get();
    item.style = style;
    return item;
}

inline hrbfnpr_image image_of(std::vector<std::uint8_t>& pixels, std::int32_t size) {
    auto image = made(hrbfnpr_image_init);
    pixels.assign(static_cast<std::size_t>(4 * size * size), 0);
    image.width = image.height = size;
    image.pixels = pixels.data();
    return image;
}

// Draws one item. `drawing` is NULL if that fails.
inline hrbfnpr_status try_to_draw(const Renderer& renderer, const hrbfnpr_item& item, const hrbfnpr_camera& camera,
                                  Drawing& drawing, Error& error) {
    hrbfnpr_drawing* made_drawing = nullptr;
    const hrbfnpr_status status = hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &camera, &made_drawing, error);
    drawing.reset(made_drawing);
    return status;
}

// Draws one item. Returns NULL and reports the error if that fails.
inline Drawing draw_item(const Renderer& renderer, const hrbfnpr_item& item, const hrbfnpr_camera& camera) {
    Error error;
    Drawing drawing;
    EXPECT_OK(try_to_draw(renderer, item, camera, drawing, error));
    return drawing;
}

inline hrbfnpr_drawing_info info_of(const Drawing& drawing) {
    Error error;
    auto info = made(hrbfnpr_drawing_info_init);
    EXPECT_OK(hrbfnpr_drawing_get_info(drawing.get(), &info, error));
    return info;
}

// The picture as size x size pixels in RGBA.
inline std::vector<std::uint8_t> rasterize(const Drawing& drawing, std::int32_t size) {
    Error error;
    std::vector<std::uint8_t> pixels;
    const hrbfnpr_image image = image_of(pixels, size);
    EXPECT_OK(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, error));
    return pixels;
}

// The picture of a set, size x size.
inline std::vector<std::uint8_t> draw(const Renderer& renderer, const PointSet& set, std::int32_t size = 64) {
    return rasterize(draw_item(renderer, item_of(set), front_camera(size)), size);
}

// A vertex layout together with the list that it points to.
struct Layout : hrbfnpr_vertex_layout {
    std::vector<hrbfnpr_vertex_attribute> attribute;

    explicit Layout(std::uint32_t primitive_wanted = HRBFNPR_PRIMITIVE_POINTS)
        : hrbfnpr_vertex_layout(made(hrbfnpr_vertex_layout_init)) {
        primitive = primitive_wanted;
    }
    Layout& add(std::uint32_t which, std::uint32_t scalar, std::size_t offset) {
        attribute.push_back(made(hrbfnpr_vertex_attribute_init));
        attribute.back().attribute = which;
        attribute.back().scalar = scalar;
        attribute.back().offset = static_cast<std::uint32_t>(offset);
        return *this;
    }
    const hrbfnpr_vertex_layout* get() {
        attributes = attribute.data();
        attribute_count = static_cast<std::int64_t>(attribute.size());
        return this;
    }
};

inline std::vector<std::uint8_t> saved(const Model& model) {
    Error error;
    std::int64_t size = 0;
    hrbfnpr_model_save_memory(model.get(), nullptr, 0, &size, nullptr);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
    EXPECT_OK(hrbfnpr_model_save_memory(model.get(), bytes.data(), size, &size, error));
    return bytes;
}

inline std::vector<std::uint8_t> saved(const PointSet& set) {
    Error error;
    std::int64_t size = 0;
    hrbfnpr_point_set_save_memory(set.get(), nullptr, 0, &size, nullptr);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
    EXPECT_OK(hrbfnpr_point_set_save_memory(set.get(), bytes.data(), size, &size, error));
    return bytes;
}

// The elements of a view as a vector.
template <class T>
std::vector<T> elements(const hrbfnpr_array& view) {
    EXPECT_EQ(view.scalar, scalar_of<T>());
    const auto* data = static_cast<const T*>(view.data);
    return data == nullptr ? std::vector<T>() : std::vector<T>(data, data + view.count * view.components);
}

template <class T>
std::vector<T> attribute(const PointSet& set, std::int64_t layer, std::uint32_t which) {
    Error error;
    hrbfnpr_array view{};
    EXPECT_OK(hrbfnpr_point_set_view(set.get(), layer, which, &view, error));
    return elements<T>(view);
}

// A sphere of radius 1 as a custom function that counts its calls and releases.
struct Sphere {
    std::atomic<int> calls{0};
    int fail_at = 0; // the number of the call that fails, from 1 on; 0 = none
    std::atomic<int> releases{0};

    static std::int32_t call(void* user, std::int64_t count, const double* points, double* value, double* gradient,
                             double* hessian);
    static void release(void* user) { static_cast<Sphere*>(user)->releases.fetch_add(1); }
};

inline std::int32_t Sphere::call(void* user, std::int64_t count, const double* points, double* value, double* gradient,
                                 double* hessian) {
    auto& self = *static_cast<Sphere*>(user);
    if (self.calls.fetch_add(1) + 1 == self.fail_at) return 7;
    for (std::int64_t i = 0; i < count; ++i) {
        const double* p = points + 3 * i;
        value[i] = 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1.0);
        for (int c = 0; gradient != nullptr && c < 3; ++c) gradient[3 * i + c] = p[c];
        for (int c = 0; hessian != nullptr && c < 6; ++c) hessian[6 * i + c] = c == 0 || c == 3 || c == 5 ? 1.0 : 0.0;
    }
    return 0;
}

inline hrbfnpr_custom_desc sphere_desc(Sphere& sphere, std::uint32_t flags) {
    auto desc = made(hrbfnpr_custom_desc_init);
    desc.flags = flags;
    desc.function = Sphere::call;
    desc.user = &sphere;
    desc.release = Sphere::release;
    for (int axis = 0; axis < 3; ++axis) {
        desc.bounds_min[axis] = -1.0;
        desc.bounds_max[axis] = 1.0;
    }
    return desc;
}

inline Model custom_sphere(const Context& context, Sphere& sphere,
                           std::uint32_t flags = HRBFNPR_CUSTOM_HAS_GRADIENT | HRBFNPR_CUSTOM_HAS_HESSIAN) {
    Error error;
    const hrbfnpr_custom_desc desc = sphere_desc(sphere, flags);
    hrbfnpr_model* model = nullptr;
    EXPECT_OK(hrbfnpr_model_create_custom(context.get(), &desc, &model, error));
    return Model(model);
}

inline hrbfnpr_context_desc allocator_desc(Allocator& allocator, std::int32_t threads = 1) {
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = threads;
    desc.thread_backend = hrbfnpr::test::test_backend();
    desc.allocate = Allocator::allocate;
    desc.deallocate = Allocator::deallocate;
    desc.allocator_user = &allocator;
    return desc;
}

inline Context make_context(const hrbfnpr_context_desc& desc) {
    Error error;
    hrbfnpr_context* context = nullptr;
    EXPECT_OK(hrbfnpr_context_create(&desc, &context, error));
    return Context(context);
}

inline hrbfnpr_context_info info_of(const Context& context) {
    Error error;
    auto info = made(hrbfnpr_context_info_init);
    EXPECT_OK(hrbfnpr_context_get_info(context.get(), &info, error));
    return info;
}

} // namespace api_test
