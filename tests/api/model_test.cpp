// SPDX-License-Identifier: MIT
#include "fixture.h"

#include <cmath>

namespace api_test::model_test {
namespace {

// A plane through six samples is fitted exactly, so every number is known.
scenes::Samples plane() {
    scenes::Samples samples;
    for (const double x : {0.0, 1.0, 2.0})
        for (const double y : {0.0, 1.0}) samples.add({x, y, 0.5}, {0.0, 0.0, 1.0});
    return samples;
}

TEST(Model, InfoDescribesTheFit) {
    Error error;
    const Context context = make_context();
    scenes::Samples samples = scenes::sphere_6();
    samples.add({1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}); // a duplicate of a sample
    samples.normals[5] *= 2.0;                     // z of the second normal, which is rescaled if z is not 0
    samples.normals[0] = 3.0 * samples.normals[0];
    const Model model = fit(context, samples);
    auto info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(model.get(), &info, error));
    EXPECT_EQ(info.kernel, static_cast<std::uint32_t>(HRBFNPR_KERNEL_TRIHARMONIC));
    EXPECT_EQ(info.polynomial_degree, 1);
    EXPECT_EQ(info.solver, static_cast<std::uint32_t>(HRBFNPR_SOLVER_DIRECT));
    EXPECT_EQ(info.samples, 7);
    EXPECT_EQ(info.centres, 6);
    EXPECT_EQ(info.merged_samples, 1);
    EXPECT_GE(info.rescaled_normals, 1);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(info.bounds_min[axis], -1.0);
        EXPECT_EQ(info.bounds_max[axis], 1.0);
    }
    EXPECT_NEAR(info.spacing, std::sqrt(2.0), 1e-12);
    EXPECT_LT(info.value_residual_max, 1e-9);
    EXPECT_LT(info.gradient_residual_max, 1e-9);
    EXPECT_GE(info.condition_estimate, 1.0);
    EXPECT_EQ(info.fallback, 0U);
    EXPECT_GT(info.seconds_total, 0.0);
    EXPECT_GT(info.bytes, 6 * 10 * 8);
}

TEST(Model, GivesViewsOfItsSamples) {
    Error error;
    const Context context = make_context();
    const scenes::Samples samples = scenes::sphere_6();
    const Model model = fit(context, samples);
    hrbfnpr_array view{};
    EXPECT_OK(hrbfnpr_model_view(model.get(), HRBFNPR_MODEL_ATTRIBUTE_POSITION, &view, error));
    EXPECT_EQ(elements<double>(view), samples.points);
    EXPECT_OK(hrbfnpr_model_view(model.get(), HRBFNPR_MODEL_ATTRIBUTE_NORMAL, &view, error));
    EXPECT_EQ(elements<double>(view), samples.normals);
    EXPECT_EQ(view.stride, 24);
    EXPECT_FAILS(hrbfnpr_model_view(model.get(), 3, &view, error), HRBFNPR_STATUS_INVALID_ARGUMENT, "attribute is 3");
}

TEST(Model, EvaluatesAnyLayout) {
    Error error;
    const Context context = make_context();
    const Model model = fit(context, plane());
    // Floats: every other point of four numbers, from the last to the first.
    const std::vector<float> wide{0, 0, 1, -9, 9, 9, 9, 9, 1, 0, 2.5F, -9};
    const hrbfnpr_array strided{wide.data(), 2, 32, HRBFNPR_SCALAR_FLOAT32, 3};
    const hrbfnpr_array backward{wide.data() + 8, 2, -32, HRBFNPR_SCALAR_FLOAT32, 3};
    std::vector<float> value(5, -1.0F);
    const hrbfnpr_array_out values{value.data() + 1, 2, 8, HRBFNPR_SCALAR_FLOAT32, 1};
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &strided, &values, nullptr, nullptr, nullptr, error));
    EXPECT_NEAR(value[1], 0.5F, 1e-6F);
    EXPECT_NEAR(value[3], 2.0F, 1e-6F);
    EXPECT_EQ(value[2], -1.0F);
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &backward, &values, nullptr, nullptr, nullptr, error));
    EXPECT_NEAR(value[1], 2.0F, 1e-6F);
    EXPECT_NEAR(value[3], 0.5F, 1e-6F);
    const hrbfnpr_array_out reversed{value.data() + 3, 2, -8, HRBFNPR_SCALAR_FLOAT32, 1};
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &backward, &reversed, nullptr, nullptr, nullptr, error));
    EXPECT_NEAR(value[1], 0.5F, 1e-6F);
}

TEST(Model, EvaluatesUnalignedElements) {
    Error error;
    const Context context = make_context();
    const Model model = fit(context, plane());
    std::vector<std::uint8_t> bytes(1 + 25 * 2);
    const double points[2][3] = {{0, 0, 1}, {1, 1, 0.25}};
    std::memcpy(&bytes[1], points[0], 24);
    std::memcpy(&bytes[26], points[1], 24);
    const hrbfnpr_array unaligned{&bytes[1], 2, 25, HRBFNPR_SCALAR_FLOAT64, 3};
    std::vector<std::uint8_t> result(20);
    const hrbfnpr_array_out values{&result[3], 2, 8, HRBFNPR_SCALAR_FLOAT64, 1};
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &unaligned, &values, nullptr, nullptr, nullptr, error));
    double value[2];
    std::memcpy(value, &result[3], 16);
    EXPECT_NEAR(value[0], 0.5, 1e-12);
    EXPECT_NEAR(value[1], -0.25, 1e-12);
}

TEST(Model, EvaluatesManyPointsOrNoPoints) {
    Error error;
    const Context context = make_context();
    const Model model = fit(context, plane());
    std::vector<double> point;
    for (int i = 0; i < 150000; ++i) point.insert(point.end(), {0.0, 0.0, 0.001 * i});
    std::vector<double> value(150000);
    std::vector<double> hessian(6 * value.size(), -1.0);
    const hrbfnpr_array points = in(point);
    const hrbfnpr_array_out values = out(value, 1);
    const hrbfnpr_array_out hessians = out(hessian, 6);
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &points, &values, nullptr, &hessians, nullptr, error));
    for (std::size_t i = 0; i < value.size(); i += 997) {
        ASSERT_NEAR(value[i], 0.001 * static_cast<double>(i) - 0.5, 1e-9);
        for (std::size_t c = 0; c < 6; ++c) ASSERT_NEAR(hessian[6 * i + c], 0.0, 1e-9);
    }
    const hrbfnpr_array none{nullptr, 0, 0, 0, 0};
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &none, nullptr, nullptr, nullptr, nullptr, error));
}

TEST(Model, ProjectsOntoThePlane) {
    Error error;
    const Context context = make_context();
    const Model model = fit(context, plane());
    std::vector<double> point{0.5, 0.5, 0.9, 1.5, 0.25, -0.4};
    std::vector<float> normal(6);
    std::vector<std::uint32_t> status(2, 99);
    const hrbfnpr_array points = in(point);
    auto projection = made(hrbfnpr_projection_init);
    projection.position = out(point); // in place
    projection.normal = out(normal);
    projection.status = out(status, 1);
    EXPECT_OK(hrbfnpr_model_project(model.get(), &points, nullptr, &projection, nullptr, error));
    EXPECT_EQ(projection.converged, 2);
    EXPECT_EQ(status, (std::vector<std::uint32_t>{0, 0}));
    const std::vector<double> wanted{0.5, 0.5, 0.5, 1.5, 0.25, 0.5};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(point[i], wanted[i], 1e-8);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(normal[i], i % 3 == 2 ? 1.0F : 0.0F, 1e-6F);
}

TEST(Model, ReportsWhichPointsDoNotProject) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    std::vector<double> point{0.0, 0.0, 0.0, 2.0, 0.0, 0.0}; // the centre has no gradient
    std::vector<std::uint8_t> status(2, 99);
    std::vector<double> normal(6, 9.0);
    const hrbfnpr_array points = in(point);
    auto projection = made(hrbfnpr_projection_init);
    projection.normal = out(normal);
    projection.status = out(status, 1);
    EXPECT_OK(hrbfnpr_model_project(model.get(), &points, nullptr, &projection, nullptr, error));
    EXPECT_EQ(status[0], HRBFNPR_PROJECTION_ZERO_GRADIENT);
    EXPECT_EQ(status[1], HRBFNPR_PROJECTION_CONVERGED);
    EXPECT_EQ(projection.converged, 1);
    EXPECT_EQ(normal, (std::vector<double>{0, 0, 0, 1, 0, 0}));
    auto desc = made(hrbfnpr_project_desc_init);
    desc.evaluation_limit = 1;
    projection.normal = {};
    EXPECT_OK(hrbfnpr_model_project(model.get(), &points, &desc, &projection, nullptr, error));
    EXPECT_EQ(status[1], HRBFNPR_PROJECTION_NOT_CONVERGED);
    EXPECT_EQ(projection.converged, 0);
}

TEST(Model, GivesTheCurvatureOfASphere) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    std::vector<double> point{2.0, 0.0, 0.0, 0.0, 0.6, 0.8};
    std::vector<double> k1(2);
    std::vector<float> k2(2);
    std::vector<double> d1(6);
    std::vector<double> d2(6);
    std::vector<double> confidence(2, 9.0);
    const hrbfnpr_array points = in(point);
    auto curvature = made(hrbfnpr_curvature_init);
    curvature.k1 = out(k1, 1);
    curvature.k2 = out(k2, 1);
    curvature.d1 = out(d1);
    curvature.d2 = out(d2);
    curvature.confidence = out(confidence, 1);
    EXPECT_OK(hrbfnpr_model_curvature(model.get(), &points, &curvature, nullptr, error));
    EXPECT_NEAR(k1[0], -0.5, 1e-12); // the level set of radius 2
    EXPECT_NEAR(k2[1], -1.0F, 1e-6F);
    EXPECT_NEAR(confidence[0], 0.0, 1e-9);
    for (std::size_t i = 0; i < 2; ++i) {
        double dot = 0.0;
        double radial = 0.0;
        double length = 0.0;
        for (std::size_t axis = 3 * i; axis < 3 * i + 3; ++axis) {
            dot += d1[axis] * d2[axis];
            radial += d1[axis] * point[axis];
            length += d1[axis] * d1[axis];
        }
        EXPECT_NEAR(dot, 0.0, 1e-9);
        EXPECT_NEAR(radial, 0.0, 1e-9);
        EXPECT_NEAR(length, 1.0, 1e-9);
    }
}

} // namespace
} // namespace api_test::model_test
