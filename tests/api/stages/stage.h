// SPDX-License-Identifier: MIT
// A list of every kind of call that succeeds; each stage returns all that it makes as bytes.
#pragma once

#include "fixture.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace api_test {

using Bytes = std::vector<std::uint8_t>;

// Wraps each call into the library, and nothing else. A test overrides begin() and end(), for example to refuse memory.
class Attempt {
public:
    Attempt() = default;
    Attempt(const Attempt&) = delete;
    Attempt& operator=(const Attempt&) = delete;
    virtual ~Attempt() = default;

    hrbfnpr_operation* operation = nullptr; // for the calls that take one

    template <class Call>
    hrbfnpr_status operator()(Call&& call) {
        begin();
        const hrbfnpr_status status = call();
        end();
        return status;
    }

protected:
    virtual void begin() {}
    virtual void end() {}
};

struct Stage {
    std::string name;
    // Makes its calls with the same objects each time, and appends the results of calls that succeed. The handle of a
    // failed call must be NULL; otherwise the stage reports an error.
    std::function<hrbfnpr_status(Attempt&, Bytes&, hrbfnpr_error*)> call;
    // Makes the objects anew in which calls leave data, such as a renderer. May be empty.
    std::function<void()> renew;
    // Limits how many calls are refused in a stage that takes long and asks for memory thousands of times.
    std::int64_t most_refusals = 1 << 30;
};

template <class Call>
Stage& add(std::vector<Stage>& stages, const std::string& name, Call call, std::function<void()> renew = {}) {
    stages.push_back({name, std::move(call), std::move(renew)});
    return stages.back();
}

// The amount of work.
struct StageSizes {
    int samples = 40;       // samples of a fit
    int dense_samples = 50; // from which centres are chosen
    int half_samples = 80;  // samples of a sphere that has them on one half
    int cloud = 9;          // points without normals
    std::int64_t marks = 60;
    std::int64_t places = 100; // points of queries
    std::int32_t pixels = 24;
    int mesh_around = 12;
};

// ---- Results as bytes. Reports contain seconds, so they are left out. --------------------------

template <class T>
void append(Bytes& bytes, const std::vector<T>& values) {
    const auto* begin = reinterpret_cast<const std::uint8_t*>(values.data());
    bytes.insert(bytes.end(), begin, begin + values.size() * sizeof(T));
}

template <class T>
void append_value(Bytes& bytes, const T& value) {
    append(bytes, std::vector<T>{value});
}

inline void append(Bytes& bytes, const Model& model) {
    Error error;
    for (const std::uint32_t which :
         {HRBFNPR_MODEL_ATTRIBUTE_POSITION, HRBFNPR_MODEL_ATTRIBUTE_NORMAL, HRBFNPR_MODEL_ATTRIBUTE_RESIDUAL_HISTORY}) {
        hrbfnpr_array view{};
        EXPECT_OK(hrbfnpr_model_view(model.get(), which, &view, error));
        append(bytes, elements<double>(view));
    }
    auto info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(model.get(), &info, error));
    append(bytes, std::vector<double>{info.kernel_radius, info.regularization, info.value_residual_rms,
                                      info.gradient_residual_rms, info.input_distance_rms, info.solver_residual,
                                      info.normals_confidence});
    std::vector<double> points;
    for (int i = 0; i < 3 * 50; ++i) points.push_back(0.017 * ((i * 37) % 150) - 1.3);
    std::vector<double> value(50), gradient(150);
    const hrbfnpr_array from = in(points);
    const hrbfnpr_array_out values = out(value, 1), gradients = out(gradient);
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &from, &values, &gradients, nullptr, nullptr, error));
    append(bytes, value);
    append(bytes, gradient);
}

inline void append(Bytes& bytes, const PointSet& set) {
    for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer) {
        for (const std::uint32_t which :
             {HRBFNPR_MARK_ATTRIBUTE_POSITION, HRBFNPR_MARK_ATTRIBUTE_NORMAL, HRBFNPR_MARK_ATTRIBUTE_DIRECTION,
              HRBFNPR_MARK_ATTRIBUTE_CURVATURE, HRBFNPR_MARK_ATTRIBUTE_RANK, HRBFNPR_MARK_ATTRIBUTE_WIDTH,
              HRBFNPR_MARK_ATTRIBUTE_TONE_NORMAL})
            append(bytes, attribute<float>(set, layer, which));
        append(bytes, attribute<std::uint8_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_LEVEL));
        for (const std::uint32_t which :
             {HRBFNPR_MARK_ATTRIBUTE_STROKE, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST, HRBFNPR_MARK_ATTRIBUTE_STROKE_ORDER})
            append(bytes, attribute<std::uint32_t>(set, layer, which));
    }
}

inline void append(Bytes& bytes, const hrbfnpr_mesh* mesh) {
    Error error;
    hrbfnpr_array view{};
    for (const std::uint32_t which : {HRBFNPR_MESH_ATTRIBUTE_VERTEX, HRBFNPR_MESH_ATTRIBUTE_CORNER_NORMAL}) {
        EXPECT_OK(hrbfnpr_mesh_view(mesh, which, &view, error));
        append(bytes, elements<double>(view));
    }
    for (const std::uint32_t which :
         {HRBFNPR_MESH_ATTRIBUTE_TRIANGLE, HRBFNPR_MESH_ATTRIBUTE_COMPONENT, HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE}) {
        EXPECT_OK(hrbfnpr_mesh_view(mesh, which, &view, error));
        append(bytes, elements<std::int32_t>(view));
    }
}

} // namespace api_test
