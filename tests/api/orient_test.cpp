// SPDX-License-Identifier: MIT
// Tests hrbfnpr_orient, and the fit's normal_mode.
#include "fixture.h"

#include <cmath>
#include <cstddef>
#include <functional>

namespace api_test::orient_test {
namespace {

scenes::Samples shape() { return scenes::torus(300); }

hrbfnpr_orient_desc desc_of(const scenes::Samples& samples, std::uint32_t mode) {
    auto desc = made(hrbfnpr_orient_desc_init);
    desc.points = in(samples.points);
    if (mode != HRBFNPR_NORMALS_NONE) desc.normals = in(samples.normals);
    desc.mode = mode;
    return desc;
}

scenes::Samples inward(scenes::Samples samples) {
    for (double& x : samples.normals) x = -x;
    return samples;
}

TEST(Orient, WritesNormalsAndInfo) {
    Error error;
    const Context context = make_context();
    const scenes::Samples samples = shape();
    const auto desc = desc_of(samples, HRBFNPR_NORMALS_NONE);
    std::vector<float> normals(samples.points.size());
    const hrbfnpr_array_out target = out(normals);
    auto info = made(hrbfnpr_orient_info_init);
    ASSERT_OK(hrbfnpr_orient(context.get(), &desc, nullptr, &target, &info, error));
    for (std::size_t i = 0; i < normals.size(); i += 3) {
        double cosine = 0.0;
        for (std::size_t c = i; c < i + 3; ++c) cosine += static_cast<double>(normals[c]) * samples.normals[c];
        EXPECT_GT(cosine, 0.9) << i;
    }
    EXPECT_EQ(info.found, static_cast<std::uint32_t>(HRBFNPR_NORMALS_NONE));
    EXPECT_EQ(info.made, 300);
    EXPECT_EQ(info.turned, 0);
    EXPECT_TRUE(std::isnan(info.direction_change));
    EXPECT_EQ(info.closed, 1U);
    EXPECT_EQ(info.components, 1);
    EXPECT_GT(info.confidence, 0.9);
    EXPECT_GT(info.seconds, 0.0);
}

TEST(Orient, RepairsInPlace) {
    Error error;
    const Context context = make_context();
    const scenes::Samples right = shape();
    scenes::Samples samples = inward(right);
    const auto desc = desc_of(samples, HRBFNPR_NORMALS_AUTO);
    const hrbfnpr_array_out target = out(samples.normals);
    auto info = made(hrbfnpr_orient_info_init);
    ASSERT_OK(hrbfnpr_orient(context.get(), &desc, nullptr, &target, &info, error));
    EXPECT_EQ(samples.normals, right.normals);
    EXPECT_EQ(info.found, static_cast<std::uint32_t>(HRBFNPR_NORMALS_INWARD));
    EXPECT_EQ(info.turned, 300);
    EXPECT_OK(hrbfnpr_orient(context.get(), &desc, nullptr, &target, nullptr, error));
    EXPECT_EQ(samples.normals, right.normals);
}

TEST(Orient, BadInputsAreNamed) {
    struct Row {
        std::function<void(hrbfnpr_orient_desc&, hrbfnpr_array_out&)> change;
        const char* message;
    };
    const Row rows[] = {
        {[](auto& d, auto&) { d.mode = 6; }, "orient_desc.mode is 6"},
        {[](auto& d, auto&) { d.points.count = 0; }, "orient_desc.points is empty"},
        {[](auto& d, auto&) { d.normals.count = 7; }, "orient_desc.normals has 7 elements, but points has"},
        {[](auto& d, auto&) {
             d.normals = {};
             d.mode = HRBFNPR_NORMALS_MIXED;
         },
         "orient_desc.normals has 0 elements"},
        {[](auto& d, auto&) { d.up[2] = 0.0; }, "orient_desc.up is 0 0 0"},
        {[](auto&, auto& o) { o.count = 3; }, "out_normals.count is 3; it must be 300"},
        {[](auto&, auto& o) { o = {}; }, "out_normals is empty"},
        {[](auto&, auto& o) { o.scalar = HRBFNPR_SCALAR_UINT8; }, "out_normals.scalar"},
        {[](auto& d, auto&) { d.points.count = d.normals.count = 3; }, "out_normals.count is 300; it must be 3"},
    };
    const Context context = make_context();
    const scenes::Samples samples = shape();
    for (const Row& row : rows) {
        Error error;
        auto desc = desc_of(samples, HRBFNPR_NORMALS_AUTO);
        std::vector<double> normals(samples.points.size(), 7.0);
        hrbfnpr_array_out target = out(normals);
        row.change(desc, target);
        EXPECT_FAILS(hrbfnpr_orient(context.get(), &desc, nullptr, &target, nullptr, error),
                     HRBFNPR_STATUS_INVALID_ARGUMENT, row.message);
        EXPECT_EQ(normals, std::vector<double>(samples.points.size(), 7.0));
    }
}

hrbfnpr_model_info fitted(const scenes::Samples& samples, std::uint32_t mode, bool with_normals, double* inside) {
    Error error;
    const Context context = make_context();
    auto desc = fit_desc(samples);
    desc.normal_mode = mode;
    if (!with_normals) desc.normals = {};
    hrbfnpr_model* made_model = nullptr;
    EXPECT_OK(hrbfnpr_model_fit(context.get(), &desc, nullptr, &made_model, error));
    const Model model(made_model);
    const std::vector<double> place{1.0, 0.0, 0.0}; // in the middle of the tube
    std::vector<double> value(1);
    const hrbfnpr_array points = in(place);
    const hrbfnpr_array_out values = out(value, 1);
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &points, &values, nullptr, nullptr, nullptr, error));
    *inside = value[0];
    auto info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(model.get(), &info, error));
    return info;
}

TEST(Orient, WorksAsAModeOfTheFit) {
    double inside = 0.0;
    const auto without = fitted(shape(), HRBFNPR_NORMALS_NONE, false, &inside);
    EXPECT_LT(inside, 0.0);
    EXPECT_EQ(without.normals_found, static_cast<std::uint32_t>(HRBFNPR_NORMALS_NONE));
    EXPECT_GT(without.normals_confidence, 0.9);
    EXPECT_GT(without.seconds_orient, 0.0);
    const auto turned = fitted(inward(shape()), HRBFNPR_NORMALS_AUTO, true, &inside);
    EXPECT_LT(inside, 0.0);
    EXPECT_EQ(turned.normals_found, static_cast<std::uint32_t>(HRBFNPR_NORMALS_INWARD));
    EXPECT_EQ(turned.normals_turned, 300);
    EXPECT_EQ(turned.normals_inward, 0U);
}

TEST(Orient, AFitReportsThatGivenNormalsPointInward) {
    double inside = 0.0;
    const auto wrong = fitted(inward(shape()), HRBFNPR_NORMALS_GIVEN, true, &inside);
    EXPECT_GT(inside, 0.0); // the normals are used as given
    EXPECT_EQ(wrong.normals_inward, 1U);
    EXPECT_TRUE(std::isnan(wrong.normals_confidence));
    EXPECT_EQ(fitted(shape(), HRBFNPR_NORMALS_GIVEN, true, &inside).normals_inward, 0U);
    EXPECT_LT(inside, 0.0);
}

TEST(Orient, AFitWithoutNormalsSaysHowToGetThem) {
    Error error;
    const Context context = make_context();
    const scenes::Samples samples = shape();
    auto desc = fit_desc(samples);
    desc.normals = {};
    hrbfnpr_model* model = nullptr;
    EXPECT_FAILS(hrbfnpr_model_fit(context.get(), &desc, nullptr, &model, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "normal_mode HRBFNPR_NORMALS_NONE");
    desc.normal_mode = 6;
    EXPECT_FAILS(hrbfnpr_model_fit(context.get(), &desc, nullptr, &model, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "fit_desc.normal_mode is 6");
}

// The descriptor is that of a program built before normal modes existed.
TEST(Orient, OldDescriptorsKeepTheGivenNormals) {
    Error error;
    const Context context = make_context();
    const scenes::Samples samples = shape();
    auto desc = fit_desc(samples);
    desc.normal_mode = HRBFNPR_NORMALS_INWARD; // beyond the size that the caller states
    desc.struct_size = offsetof(hrbfnpr_fit_desc, normal_mode);
    hrbfnpr_model* made_model = nullptr;
    ASSERT_OK(hrbfnpr_model_fit(context.get(), &desc, nullptr, &made_model, error));
    const Model model(made_model);
    auto info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(model.get(), &info, error));
    EXPECT_EQ(info.normals_turned, 0);
}

} // namespace
} // namespace api_test::orient_test
