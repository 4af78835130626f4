// SPDX-License-Identifier: MIT
// The table of bad inputs, first half: contexts, models and arrays. Every row changes one thing of a valid call and
// names the status and the words of the error.
#include "fixture.h"

#include <cmath>
#include <functional>
#include <limits>

namespace api_test::bad_model_input_test {
namespace {

constexpr auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr auto largest = std::numeric_limits<std::int64_t>::max();
constexpr auto lowest = std::numeric_limits<std::int64_t>::min();

template <class T>
struct Row {
    std::function<void(T&)> change;
    hrbfnpr_status status;
    const char* message;
};

// The data of a valid call, for the rows to change.
struct FitCall {
    scenes::Samples samples = scenes::sphere_6();
    std::vector<float> floats = std::vector<float>(18, 1.0F);
    hrbfnpr_fit_desc desc = fit_desc(samples);
};

const std::vector<Row<FitCall>>& fit_rows() {
    static const auto& rows = *new std::vector<Row<FitCall>>{
        {[](FitCall& c) { c.samples.points[7] = nan; }, invalid, "points[2] is NaN or infinite"},
        {[](FitCall& c) { c.samples.points[17] = -infinity; }, invalid, "points[5] is NaN or infinite"},
        {[](FitCall& c) { c.samples.points[0] = 1e101; }, invalid, "points[0] has a coordinate beyond 1e100"},
        {[](FitCall& c) { c.samples.normals[3] = nan; }, invalid, "normals[1] is NaN or infinite"},
        {[](FitCall& c) { c.samples.normals.assign(18, 0.0); }, invalid, "normals[0] is zero"},
        {[](FitCall& c) {
             c.desc.points = {nullptr, 0, 0, 0, 0};
         },
         invalid, "fit_desc.points is empty"},
        {[](FitCall& c) { c.desc.points.count = 0; }, invalid, "fit_desc.points is empty"},
        {[](FitCall& c) {
             c.desc.normals = {nullptr, 0, 0, 0, 0};
         },
         invalid, "fit_desc.normals has 0 elements, but points has 6"},
        {[](FitCall& c) { c.desc.normals.count = 5; }, invalid,
         "fit_desc.normals has 5 elements, but points has 6; give one normal for each point"},
        {[](FitCall& c) { c.desc.points.data = nullptr; }, invalid,
         "fit_desc.points.data is NULL, but its count is 6; give the data, or set count to 0"},
        {[](FitCall& c) { c.desc.points.count = -1; }, invalid, "fit_desc.points.count is -1; it must be 0 or more"},
        {[](FitCall& c) { c.desc.points.scalar = 0; }, invalid,
         "fit_desc.points.scalar is 0; it must be HRBFNPR_SCALAR_FLOAT32 or _FLOAT64"},
        {[](FitCall& c) { c.desc.points.scalar = 5; }, invalid, "fit_desc.points.scalar is 5"},
        {[](FitCall& c) { c.desc.points.scalar = 33; }, invalid, "fit_desc.points.scalar is 33"},
        {[](FitCall& c) { c.desc.normals.scalar = HRBFNPR_SCALAR_UINT8; }, invalid, "fit_desc.normals.scalar is 3"},
        {[](FitCall& c) { c.desc.points.components = 2; }, invalid, "fit_desc.points.components is 2; it must be 3"},
        {[](FitCall& c) { c.desc.points.components = 0; }, invalid, "fit_desc.points.components is 0; it must be 3"},
        {[](FitCall& c) { c.desc.points.stride = 23; }, invalid,
         "fit_desc.points.stride is 23, but an element has 24 bytes"},
        {[](FitCall& c) { c.desc.points.stride = -23; }, invalid, "fit_desc.points.stride is -23"},
        {[](FitCall& c) { c.desc.points.stride = largest; }, invalid,
         "fit_desc.points: count 6 times stride 9223372036854775807 exceeds the address space"},
        {[](FitCall& c) { c.desc.points.stride = lowest; }, invalid, "exceeds the address space"},
        {[](FitCall& c) { c.desc.points.stride = largest / 5; }, invalid, "exceeds the address space"},
        {[](FitCall& c) { c.desc.points.stride = -(std::int64_t{1} << 62); }, invalid, "exceeds the address space"},
        {[](FitCall& c) { c.desc.points.count = largest; }, invalid, "exceeds the address space"},
        {[](FitCall& c) { c.desc.points.count = largest / 24 + 1; }, invalid, "exceeds the address space"},
        {[](FitCall& c) { c.desc.kernel = 3; }, invalid, "fit_desc.kernel is 3; it must be one of HRBFNPR_KERNEL_*"},
        {[](FitCall& c) { c.desc.polynomial_degree = 3; }, invalid, "do not determine such a polynomial"},
        {[](FitCall& c) { c.desc.outliers = HRBFNPR_REPAIR_REORIENT; }, invalid,
         "fit_desc.outliers is 2; it must be one of HRBFNPR_REPAIR_KEEP and _DROP"},
        {[](FitCall& c) { c.desc.flipped_normals = 3; }, invalid, "fit_desc.flipped_normals is 3"},
        {[](FitCall& c) {
             c.desc.regularization_mode = HRBFNPR_REGULARIZATION_AUTO;
             c.desc.regularization = 0.5;
         },
         invalid,
         "fit_desc.regularization is 0.5, but regularization_mode is AUTO; set it to 0, or the mode to "
         "HRBFNPR_REGULARIZATION_GIVEN"},
        {[](FitCall& c) { c.desc.struct_size = 0; }, HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "fit_desc.struct_size is 0"},
        {[](FitCall& c) { c.desc.struct_size = 8; }, invalid, "fit_desc.points is empty"},
        {[](FitCall& c) {
             for (int axis = 0; axis < 3; ++axis)
                 c.samples.points[static_cast<std::size_t>(axis)] =
                     c.samples.points[static_cast<std::size_t>(3 + axis)];
         },
         invalid, "points[0] and points[1] coincide, but their normals differ by"},
    };
    return rows;
}

TEST(BadInput, IsRefusedByFit) {
    const Context context = make_context();
    const std::int64_t before = info_of(context).bytes_now;
    for (const Row<FitCall>& row : fit_rows()) {
        Error error;
        FitCall call;
        row.change(call);
        auto* model = reinterpret_cast<hrbfnpr_model*>(&call);
        EXPECT_FAILS(hrbfnpr_model_fit(context.get(), &call.desc, nullptr, &model, error), row.status, row.message);
        EXPECT_EQ(model, nullptr) << row.message;
    }
    EXPECT_EQ(info_of(context).bytes_now, before);
}

TEST(BadInput, NullPointersAreRefusedByFit) {
    Error error;
    const Context context = make_context();
    const FitCall call;
    hrbfnpr_model* model = nullptr;
    EXPECT_FAILS(hrbfnpr_model_fit(nullptr, &call.desc, nullptr, &model, error), invalid, "context is NULL");
    EXPECT_FAILS(hrbfnpr_model_fit(context.get(), nullptr, nullptr, &model, error), invalid, "fit_desc is NULL");
    EXPECT_FAILS(hrbfnpr_model_fit(context.get(), &call.desc, nullptr, nullptr, error), invalid, "out_model is NULL");
    EXPECT_EQ(hrbfnpr_model_fit(context.get(), nullptr, nullptr, &model, nullptr), invalid);
}

TEST(BadInput, IsRefusedByContextCreation) {
    const std::vector<Row<hrbfnpr_context_desc>> rows = {
        {[](auto& d) { d.abi_version = 77; }, HRBFNPR_STATUS_VERSION_MISMATCH,
         "context_desc.abi_version is 77, but the library's is "},
        {[](auto& d) { d.thread_count = -1; }, invalid, "context_desc.thread_count is -1"},
        {[](auto& d) { d.thread_backend = HRBFNPR_THREAD_BACKEND_RUN_TASKS; }, invalid,
         "context_desc.run_tasks is NULL"},
        {[](auto& d) {
             d.thread_backend = HRBFNPR_THREAD_BACKEND_POOL;
             d.run_tasks = [](void*, hrbfnpr_task_fn, void*, std::int64_t) {};
         },
         invalid, "context_desc.thread_backend is 1, but run_tasks is given"},
        {[](auto& d) { d.log_level = 3; }, invalid,
         "context_desc.log_level is 3; it must be one of HRBFNPR_LOG_* (0 to 2)"},
        {[](auto& d) { d.allocate = Allocator::allocate; }, invalid, "context_desc.deallocate is NULL; give both"},
        {[](auto& d) { d.deallocate = Allocator::deallocate; }, invalid, "context_desc.allocate is NULL; give both"}};
    for (const auto& row : rows) {
        Error error;
        auto desc = made(hrbfnpr_context_desc_init);
        row.change(desc);
        auto* context = reinterpret_cast<hrbfnpr_context*>(&desc);
        EXPECT_FAILS(hrbfnpr_context_create(&desc, &context, error), row.status, row.message);
        EXPECT_EQ(context, nullptr);
    }
}

TEST(BadInput, IsRefusedByCustomModels) {
    const std::vector<Row<hrbfnpr_custom_desc>> rows = {
        {[](auto& d) { d.function = nullptr; }, invalid, "custom_desc.function is NULL"},
        {[](auto& d) { d.bounds_min[1] = nan; }, invalid, "custom_desc.bounds_min is nan"},
        {[](auto& d) { d.bounds_min[2] = 1.5; }, invalid, "custom_desc.bounds_min[2] is 1.5, above bounds_max[2]"},
        {[](auto& d) {
             for (int axis = 0; axis < 3; ++axis) d.bounds_max[axis] = d.bounds_min[axis];
         },
         invalid, "give a box with the diagonal"},
        {[](auto& d) { d.difference_step = -1; }, invalid, "custom_desc.difference_step is -1"}};
    const Context context = make_context();
    Sphere sphere;
    for (const auto& row : rows) {
        Error error;
        hrbfnpr_custom_desc desc = sphere_desc(sphere, 0);
        row.change(desc);
        hrbfnpr_model* model = nullptr;
        EXPECT_FAILS(hrbfnpr_model_create_custom(context.get(), &desc, &model, error), row.status, row.message);
    }
    EXPECT_EQ(sphere.releases, 0);
}

// The arguments of _evaluate, _project and _curvature.
struct Query {
    std::vector<double> point{0.5, 0, 0, 0, 0.5, 0};
    std::vector<double> number{-7, -7};
    std::vector<double> vector = std::vector<double>(6, -7);
    std::vector<double> hessian = std::vector<double>(12, -7);
    std::vector<std::uint8_t> byte{77, 77};
    hrbfnpr_array points = in(point);
    hrbfnpr_array_out numbers = out(number, 1);
    hrbfnpr_array_out vectors = out(vector);
    hrbfnpr_array_out hessians = out(hessian, 6);
    hrbfnpr_array_out bytes = out(byte, 1);
    hrbfnpr_project_desc desc = made(hrbfnpr_project_desc_init);
};

// All failures leave all outputs untouched.
void expect_untouched(const Query& query) {
    for (const double value : query.number) EXPECT_EQ(value, -7);
    for (const double value : query.vector) EXPECT_EQ(value, -7);
    for (const double value : query.hessian) EXPECT_EQ(value, -7);
    for (const std::uint8_t value : query.byte) EXPECT_EQ(value, 77);
}

TEST(BadInput, IsRefusedByEvaluate) {
    const std::vector<Row<Query>> rows = {
        {[](Query& q) { q.points.data = nullptr; }, invalid,
         "points.data is NULL, but its count is 2; give the data, or set count to 0"},
        {[](Query& q) { q.numbers.count = 1; }, invalid, "value.count is 1; it must be 2"},
        {[](Query& q) { q.numbers.count = -2; }, invalid, "value.count is -2"},
        {[](Query& q) { q.numbers.data = nullptr; }, invalid,
         "value.data is NULL, but its count is 2; give the data, or set count to 0"},
        {[](Query& q) { q.numbers.components = 3; }, invalid, "value.components is 3; it must be 1"},
        {[](Query& q) { q.vectors.components = 1; }, invalid, "gradient.components is 1; it must be 3"},
        {[](Query& q) { q.vectors.scalar = HRBFNPR_SCALAR_UINT32; }, invalid, "gradient.scalar is 4"},
        {[](Query& q) { q.hessians.components = 9; }, invalid, "hessian.components is 9; it must be 6"},
        {[](Query& q) { q.hessians.stride = 8; }, invalid, "hessian.stride is 8, but an element has 48 bytes"},
        {[](Query& q) { q.hessians.stride = lowest; }, invalid, "exceeds the address space"}};
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    for (const auto& row : rows) {
        Error error;
        Query query;
        row.change(query);
        EXPECT_FAILS(hrbfnpr_model_evaluate(model.get(), &query.points, &query.numbers, &query.vectors, &query.hessians,
                                            nullptr, error),
                     row.status, row.message);
        expect_untouched(query);
    }
    Error error;
    Query query;
    EXPECT_FAILS(hrbfnpr_model_evaluate(nullptr, &query.points, nullptr, nullptr, nullptr, nullptr, error), invalid,
                 "model is NULL");
    EXPECT_FAILS(hrbfnpr_model_evaluate(model.get(), nullptr, nullptr, nullptr, nullptr, nullptr, error), invalid,
                 "points is NULL");
}

TEST(BadInput, IsRefusedByProject) {
    const std::vector<Row<Query>> rows = {
        {[](Query& q) { q.vectors.count = 3; }, invalid, "projection.position.count is 3; it must be 2"},
        {[](Query& q) { q.bytes.scalar = HRBFNPR_SCALAR_FLOAT32; }, invalid,
         "projection.status.scalar is 1; it must be HRBFNPR_SCALAR_UINT8 or _UINT32"},
        {[](Query& q) { q.desc.armijo_factor = nan; }, invalid, "project_desc.armijo_factor is nan"}};
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    for (const auto& row : rows) {
        Error error;
        Query query;
        row.change(query);
        auto projection = made(hrbfnpr_projection_init);
        projection.position = query.vectors;
        projection.status = query.bytes;
        projection.converged = -7;
        EXPECT_FAILS(hrbfnpr_model_project(model.get(), &query.points, &query.desc, &projection, nullptr, error),
                     row.status, row.message);
        EXPECT_EQ(projection.converged, -7);
        expect_untouched(query);
    }
    Error error;
    const Query query;
    EXPECT_FAILS(hrbfnpr_model_project(model.get(), &query.points, nullptr, nullptr, nullptr, error), invalid,
                 "projection is NULL");
    auto projection = made(hrbfnpr_projection_init);
    projection.reserved = 1;
    EXPECT_FAILS(hrbfnpr_model_project(model.get(), &query.points, nullptr, &projection, nullptr, error), invalid,
                 "projection.reserved is 1; it must be 0");
}

TEST(BadInput, IsRefusedByCurvature) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    Query query;
    query.numbers.count = 7;
    const auto call = [&](hrbfnpr_array_out hrbfnpr_curvature::*which) {
        auto curvature = made(hrbfnpr_curvature_init);
        curvature.*which = query.numbers;
        return hrbfnpr_model_curvature(model.get(), &query.points, &curvature, nullptr, error);
    };
    EXPECT_FAILS(call(&hrbfnpr_curvature::k1), invalid, "curvature.k1.count is 7; it must be 2");
    EXPECT_FAILS(call(&hrbfnpr_curvature::k2), invalid, "curvature.k2.count is 7");
    EXPECT_FAILS(call(&hrbfnpr_curvature::d1), invalid, "curvature.d1.components is 1; it must be 3");
    EXPECT_FAILS(call(&hrbfnpr_curvature::d2), invalid, "curvature.d2.components is 1");
    EXPECT_FAILS(call(&hrbfnpr_curvature::confidence), invalid, "curvature.confidence.count is 7");
    EXPECT_FAILS(hrbfnpr_model_curvature(model.get(), &query.points, nullptr, nullptr, error), invalid,
                 "curvature is NULL");
    auto curvature = made(hrbfnpr_curvature_init);
    curvature.reserved = 1;
    EXPECT_FAILS(hrbfnpr_model_curvature(model.get(), &query.points, &curvature, nullptr, error), invalid,
                 "curvature.reserved is 1; it must be 0");
}

TEST(BadInput, HugeStridesOfASingleElementAreFine) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    Query query;
    query.points.count = query.numbers.count = 1;
    query.points.stride = largest;
    query.numbers.stride = lowest;
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &query.points, &query.numbers, nullptr, nullptr, nullptr, error));
    EXPECT_EQ(query.number[0], 0.5 * (0.25 - 1.0));
}

} // namespace
} // namespace api_test::bad_model_input_test
