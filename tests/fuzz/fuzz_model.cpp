// SPDX-License-Identifier: MIT
// Loads a model and uses it: every query, a few rays, a few marks, which are drawn, lines, a trim.
#include "fuzz.h"
#include "limits.h"

#include <cmath>
#include <cstring>

namespace {

using namespace fuzz;

constexpr std::size_t count = 5; // points and rays
using Scalars = std::array<double, count>;
using Vectors = std::array<double, 3 * count>;

template <class T>
hrbfnpr_array_out out(T& numbers) {
    constexpr std::size_t components = std::tuple_size_v<T> / count;
    constexpr auto scalar = sizeof(numbers[0]) == 8   ? HRBFNPR_SCALAR_FLOAT64
                            : sizeof(numbers[0]) == 1 ? HRBFNPR_SCALAR_UINT8
                                                      : HRBFNPR_SCALAR_UINT32;
    return {numbers.data(), count, 0, scalar, components};
}

hrbfnpr_array in(const Vectors& vectors) { return {vectors.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3}; }

bool finite(std::span<const double> numbers) {
    for (const double number : numbers)
        if (!std::isfinite(number)) return false;
    return true;
}

hrbfnpr_model_info info_of(const hrbfnpr_model* model) {
    hrbfnpr_model_info info;
    hrbfnpr_model_info_init(&info, sizeof info);
    Call call("model_get_info");
    call.expect(hrbfnpr_model_get_info(model, &info, call.error()));
    require((info.centres >= 1) == (info.kernel != HRBFNPR_KERNEL_CSG), "a fit has a centre, and a tree none");
    return info;
}

// A point outside, the middle and two corners of the bounds, and one sample.
Vectors points_of(const hrbfnpr_model* model, const hrbfnpr_model_info& info) {
    Vectors points{};
    Call call("model_view");
    hrbfnpr_array samples;
    call.expect(hrbfnpr_model_view(model, HRBFNPR_MODEL_ATTRIBUTE_POSITION, &samples, call.error()));
    // A model of sheets has places all over the surface here; a tree has none.
    require((samples.count >= 1) == (info.centres >= 1), "the centres, or places of the surface, can be seen");
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double size = info.bounds_max[axis] - info.bounds_min[axis];
        points[axis] = info.bounds_max[axis] + 0.1 * static_cast<double>(1 + axis) * size;
        points[3 + axis] = 0.5 * (info.bounds_min[axis] + info.bounds_max[axis]);
        points[6 + axis] = info.bounds_min[axis];
        points[9 + axis] = info.bounds_max[axis];
    }
    std::memcpy(&points[12], samples.count > 0 ? samples.data : &points[3], 3 * sizeof(double));
    return points;
}

struct Fields {
    Scalars value{};
    Vectors gradient{};
    std::array<double, 6 * count> hessian{};
};

Fields evaluate(const hrbfnpr_model* model, const Vectors& points) {
    Fields fields;
    const hrbfnpr_array at = in(points);
    const auto value = out(fields.value);
    const auto gradient = out(fields.gradient);
    const auto hessian = out(fields.hessian);
    Call call("model_evaluate");
    call.expect(hrbfnpr_model_evaluate(model, &at, &value, &gradient, &hessian, nullptr, call.error()));
    return fields;
}

void project(const hrbfnpr_model* model, const Vectors& points) {
    Vectors position{};
    Vectors normal{};
    std::array<std::uint8_t, count> status{};
    const hrbfnpr_array at = in(points);
    hrbfnpr_projection projection;
    hrbfnpr_projection_init(&projection, sizeof projection);
    projection.position = out(position);
    projection.normal = out(normal);
    projection.status = out(status);
    Call call("model_project");
    call.expect(hrbfnpr_model_project(model, &at, nullptr, &projection, nullptr, call.error()));
    std::int64_t counted = 0;
    for (std::size_t i = 0; i < count; ++i) {
        require(status[i] <= HRBFNPR_PROJECTION_NOT_FINITE, "a projection ends in one of four ways");
        if (status[i] != HRBFNPR_PROJECTION_CONVERGED) continue;
        ++counted;
        require(finite(std::span(position).subspan(3 * i, 3)), "a converged projection is finite");
        require(finite(std::span(normal).subspan(3 * i, 3)), "a converged projection has a normal");
    }
    require(counted == projection.converged, "converged projections are counted");
}

void curvature(const hrbfnpr_model* model, const Vectors& points) {
    Scalars k1{};
    Scalars k2{};
    Vectors d1{};
    Vectors d2{};
    Scalars confidence{};
    const hrbfnpr_array at = in(points);
    hrbfnpr_curvature result;
    hrbfnpr_curvature_init(&result, sizeof result);
    result.k1 = out(k1);
    result.k2 = out(k2);
    result.d1 = out(d1);
    result.d2 = out(d2);
    result.confidence = out(confidence);
    Call call("model_curvature");
    call.expect(hrbfnpr_model_curvature(model, &at, &result, nullptr, call.error()));
    for (std::size_t i = 0; i < count; ++i)
        if (std::isfinite(k1[i]) && std::isfinite(k2[i])) require(k1[i] >= k2[i], "k1 is the larger curvature");
}

// Casts rays from the points towards their middle and beyond.
void cast(const hrbfnpr_model* model, const Vectors& points) {
    Vectors directions{};
    for (std::size_t i = 0; i < directions.size(); ++i) directions[i] = points[3 + i % 3] - points[i];
    for (std::size_t i = 0; i < count; ++i) {
        const auto direction = std::span(directions).subspan(3 * i, 3);
        if (!finite(direction) || (direction[0] == 0.0 && direction[1] == 0.0 && direction[2] == 0.0))
            std::fill(direction.begin(), direction.end(), 1.0);
    }
    constexpr std::size_t most = 2;
    hrbfnpr_cast_desc desc;
    hrbfnpr_cast_desc_init(&desc, sizeof desc);
    desc.maximum_hits = most;
    desc.evaluation_limit = 100;
    desc.lipschitz = 4.0; // the default evaluates 24^3 points
    std::array<std::uint32_t, count> hits{};
    std::array<double, most * count> t{};
    std::array<double, 3 * most * count> position{};
    std::array<std::uint8_t, count> status{};
    const hrbfnpr_array from = in(points);
    const hrbfnpr_array along = in(directions);
    hrbfnpr_ray_hits result;
    hrbfnpr_ray_hits_init(&result, sizeof result);
    result.count = out(hits);
    result.t = out(t);
    result.position = out(position);
    result.status = out(status);
    Call call("model_cast_rays");
    call.expect(hrbfnpr_model_cast_rays(model, &from, &along, &desc, &result, nullptr, call.error()));
    for (std::size_t i = 0; i < count; ++i) {
        require(status[i] <= HRBFNPR_RAY_NOT_FINITE && hits[i] <= most, "a ray ends in one of five ways");
        require(finite(std::span(t).subspan(most * i, hits[i])), "a hit has a place on its ray");
        require(finite(std::span(position).subspan(3 * most * i, 3 * hits[i])), "a hit has a position");
    }
}

void contain(const hrbfnpr_model* model, const Vectors& points) {
    std::array<std::uint8_t, count> inside{};
    std::int64_t total = 0;
    const hrbfnpr_array at = in(points);
    const auto insides = out(inside);
    Call call("model_contains");
    call.expect(hrbfnpr_model_contains(model, &at, &insides, &total, nullptr, call.error()));
    std::int64_t counted = 0;
    for (const std::uint8_t one : inside) counted += one;
    require(counted == total, "points inside are counted");
}

void generate(Context& context, const hrbfnpr_model* model, std::uint32_t choice) {
    hrbfnpr_generate_desc desc;
    hrbfnpr_generate_desc_init(&desc, sizeof desc);
    desc.distribution = choice % 128 != 0 ? HRBFNPR_DISTRIBUTION_PUBLISHED : HRBFNPR_DISTRIBUTION_BLUE_NOISE;
    hrbfnpr_layer_desc layer;
    hrbfnpr_layer_desc_init(&layer, sizeof layer);
    layer.kind = HRBFNPR_LAYER_KIND_STIPPLES + choice / 128 % 2;
    layer.levels = 1;
    layer.budget = 12;
    desc.layers = &layer;
    desc.layer_count = 1;
    desc.seed_source = choice / 512 % 3; // automatic, samples, box
    desc.box_resolution = 2;
    Input none(nullptr, 0);
    const Operation operation(context, none);
    Call call("point_set_generate");
    hrbfnpr_point_set* set = nullptr;
    const bool made =
        call.expect(hrbfnpr_point_set_generate(context.handle, model, &desc, operation.handle, &set, call.error()),
                    {HRBFNPR_STATUS_INVALID_ARGUMENT, HRBFNPR_STATUS_NOT_CONVERGED, HRBFNPR_STATUS_OUT_OF_MEMORY,
                     HRBFNPR_STATUS_CANCELLED});
    if (made) {
        require_sound_marks(set);
        require_same_set(context, set);
        draw(context, set, choice);
    }
    hrbfnpr_point_set_release(set);
}

constexpr std::initializer_list<hrbfnpr_status> failures = {HRBFNPR_STATUS_INVALID_ARGUMENT,
                                                            HRBFNPR_STATUS_NOT_CONVERGED, HRBFNPR_STATUS_OUT_OF_MEMORY,
                                                            HRBFNPR_STATUS_CANCELLED};

// Makes lines of the whole surface, or of a surface that ends with its samples.
void make_lines(Context& context, const hrbfnpr_model* model, std::uint32_t choice) {
    hrbfnpr_line_set_desc desc;
    hrbfnpr_line_set_desc_init(&desc, sizeof desc);
    desc.support = choice % 2 != 0 ? 1.5 : 0.0;
    desc.flags = choice / 2 % 2 != 0 ? HRBFNPR_LINE_SET_WITH_CURVATURE : 0;
    Input none(nullptr, 0);
    const Operation operation(context, none);
    hrbfnpr_line_set* lines = nullptr;
    Call call("line_set_create");
    const bool made = call.expect(
        hrbfnpr_line_set_create(context.handle, model, &desc, operation.handle, &lines, call.error()), failures);
    require(made == (lines != nullptr), "a handle comes with success only");
    hrbfnpr_line_set_release(lines);
}

void trim(Context& context, const hrbfnpr_model* model) {
    Input none(nullptr, 0);
    const Operation operation(context, none);
    hrbfnpr_model* trimmed = nullptr;
    Call call("model_trim");
    if (!call.expect(hrbfnpr_model_trim(model, nullptr, operation.handle, &trimmed, call.error()), failures)) return;
    const Bytes file = save(trimmed, hrbfnpr_model_save_memory);
    auto* const again = load<hrbfnpr_model>(context, file, hrbfnpr_model_load_memory);
    require(again != nullptr, "a trimmed model loads");
    hrbfnpr_model_release(again);
    hrbfnpr_model_release(trimmed);
}

void require_same_model(Context& context, const hrbfnpr_model* model, const Vectors& points, const Fields& fields) {
    const Bytes first = save(model, hrbfnpr_model_save_memory);
    auto* const again = load<hrbfnpr_model>(context, first, hrbfnpr_model_load_memory);
    require(again != nullptr, "a saved model loads");
    require(save(again, hrbfnpr_model_save_memory) == first, "a loaded model saves to the same bytes");
    const Fields same = evaluate(again, points);
    require(std::memcmp(&fields, &same, sizeof fields) == 0, "a loaded model evaluates to the same bits");
    hrbfnpr_model_release(again);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes file = signed_file(data, size);
    Context context;
    auto* const model = load<hrbfnpr_model>(context, file, hrbfnpr_model_load_memory);
    if (model == nullptr) return 0;
    const hrbfnpr_model_info info = info_of(model);
    const Vectors points = points_of(model, info);
    require_same_model(context, model, points, evaluate(model, points));
    project(model, points);
    curvature(model, points);
    cast(model, points);
    contain(model, points);
    // Marks take many times as long as everything else, and BLUE_NOISE takes longest.
    if (const std::uint32_t choice = choice_of(file); info.centres <= 16 && choice % 16 == 0)
        generate(context, model, choice / 16);
    else if (info.centres <= 16 && choice % 64 == 1)
        make_lines(context, model, choice / 64);
    else if (info.centres <= 16 && choice % 64 == 2)
        trim(context, model);
    hrbfnpr_model_release(model);
    return 0;
}
