// SPDX-License-Identifier: MIT
// Tests surfaces that end where their samples end: the parts that are left out, the parts that stay, and an error that
// names every bad argument.
#include "trimmed.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace api_test::trim_test {
namespace {

constexpr auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
Model trimmed(const Model& model, const hrbfnpr_trim_desc* desc = nullptr) {
    Error error;
    hrbfnpr_model* made = nullptr;
    EXPECT_OK(hrbfnpr_model_trim(model.get(), desc, nullptr, &made, error));
    return Model(made);
}

TEST(Trim, EndsAnOpenScanNearItsSamples) {
    const Context context = make_context();
    const Model open = fit_whole(context, zone(-1.0, 1.0, true));
    const Model model = trimmed(open);
    const hrbfnpr_trim_info info = info_of(model);
    EXPECT_EQ(info.is_trimmed, 1U);
    EXPECT_NEAR(static_cast<double>(info.samples), 0.5 * whole, 5.0);
    EXPECT_EQ(info.parts, 1);
    EXPECT_GT(info.share, 0.05);
    EXPECT_GT(info.farthest, sphere_spacing);
    const std::vector<float> stipples = stipples_of(context, model);
    EXPECT_GT(stipples.size(), std::size_t{3 * 3900});
    EXPECT_GT(lowest(stipples), -1.0 * sphere_spacing);
    EXPECT_LT(lowest(stipples), -0.2 * sphere_spacing);
    EXPECT_LT(lowest(stipples_of(context, open)), -2.0 * sphere_spacing); // the fit continues beyond its samples
}

// The surface has a gap in its samples, which is trimmed or not by the size of the hole.
TEST(Trim, KeepsSmallHolesClosed) {
    const Context context = make_context();
    const Model model = fit_whole(context, zone(-1.0, 0.9)); // 0.45 from the hole's rim to its middle
    auto desc = made(hrbfnpr_trim_desc_init);
    desc.hole = 0.2; // share of the diagonal, 3.5
    EXPECT_EQ(info_of(trimmed(model, &desc)).is_trimmed, 0U);
    desc.hole = 0.05;
    const Model open = trimmed(model, &desc);
    EXPECT_EQ(info_of(open).parts, 1);
    EXPECT_EQ(info_of(open).parts_to_end, 0);
    EXPECT_NEAR(info_of(open).share, 0.05, 0.03);
}

// The hole of 0.45 is not found if spacings count as at least 0.2 diagonals.
TEST(Trim, TreatsSpacingsAsAtLeastClosest) {
    const Context context = make_context();
    const Model model = fit_whole(context, zone(-1.0, 0.9));
    auto desc = made(hrbfnpr_trim_desc_init);
    desc.closest = 0.01; // in diagonals of 3.5: less than the samples' own spacing of 0.11
    const hrbfnpr_trim_info own = info_of(trimmed(model, &desc));
    EXPECT_EQ(own.is_trimmed, 1U);
    desc.closest = 0.2;
    const hrbfnpr_trim_info wide = info_of(trimmed(model, &desc));
    EXPECT_EQ(wide.is_trimmed, 0U);
    EXPECT_GT(wide.spacing, 4.0 * own.spacing);
}

// A sphere with a tube that leaves it; no sample is on the tube.
int tube_function(void* /*user*/, int64_t count, const double* points, double* value, double* gradient,
                  double* /*hessian*/) {
    for (int64_t i = 0; i < count; ++i) {
        const double* p = points + 3 * i;
        const double of_sphere = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        const double way = std::clamp(p[2], 0.0, 1.8);
        const double of_tube = std::sqrt(p[0] * p[0] + p[1] * p[1] + (p[2] - way) * (p[2] - way));
        const bool tube = of_tube - 0.15 < of_sphere - 1.0;
        value[i] = tube ? of_tube - 0.15 : of_sphere - 1.0;
        for (int c = 0; gradient != nullptr && c < 3; ++c)
            gradient[3 * i + c] = (p[c] - (tube && c == 2 ? way : 0.0)) / (tube ? of_tube : of_sphere);
    }
    return 0;
}

Model sphere_with_tube(const Context& context) {
    Error error;
    auto desc = made(hrbfnpr_custom_desc_init);
    desc.function = tube_function;
    desc.flags = HRBFNPR_CUSTOM_HAS_GRADIENT | HRBFNPR_CUSTOM_THREAD_SAFE;
    for (int c = 0; c < 3; ++c) {
        desc.bounds_min[c] = -1.1;
        desc.bounds_max[c] = c < 2 ? 1.1 : 2.1;
    }
    hrbfnpr_model* model = nullptr;
    EXPECT_OK(hrbfnpr_model_create_custom(context.get(), &desc, &model, error));
    return Model(model);
}

TEST(Trim, LeavesOutSheetsFarFromAllSamples) {
    const Context context = make_context();
    const scenes::Samples samples = zone(-1.0, 1.0);
    auto desc = made(hrbfnpr_trim_desc_init);
    desc.points = in(samples.points);
    desc.normals = in(samples.normals);
    const Model model = trimmed(sphere_with_tube(context), &desc);
    EXPECT_EQ(info_of(model).parts, 1);
    EXPECT_EQ(info_of(model).parts_to_end, 0);
    EXPECT_NEAR(info_of(model).farthest, 0.95, 0.1);
    const std::vector<float> stipples = stipples_of(context, model);
    for (std::size_t i = 2; i < stipples.size(); i += 3) EXPECT_LT(stipples[i], 1.0 + 1.5 * sphere_spacing);
}

TEST(Trim, AppliesToRaysAndLines) {
    Error error;
    const Context context = make_context();
    const Model model = trimmed(fit_whole(context, zone(0.0, 1.0)));
    // One ray goes down through the cap and then the open side, the other across below the cap.
    const std::vector<double> origin{0.1, 0.2, 3.0, 3.0, 0.0, -0.2};
    const std::vector<double> direction{0.0, 0.0, -1.0, -1.0, 0.0, 0.0};
    const hrbfnpr_array origins = in(origin);
    const hrbfnpr_array directions = in(direction);
    std::vector<std::uint32_t> count(2);
    std::vector<double> t(8);
    auto cast = made(hrbfnpr_cast_desc_init);
    cast.maximum_hits = 4;
    auto hits = made(hrbfnpr_ray_hits_init);
    hits.count = out(count, 1);
    hits.t = out(t, 4);
    ASSERT_OK(hrbfnpr_model_cast_rays(model.get(), &origins, &directions, &cast, &hits, nullptr, error));
    EXPECT_EQ(count, (std::vector<std::uint32_t>{1, 0}));
    EXPECT_NEAR(t[0], 3.0 - std::sqrt(1.0 - 0.05), 1e-2);

    hrbfnpr_line_set* made_set = nullptr;
    ASSERT_OK(hrbfnpr_line_set_create(context.get(), model.get(), nullptr, nullptr, &made_set, error));
    const hrbfnpr::test::LineSet lines(made_set);
    auto info = made(hrbfnpr_line_set_info_init);
    ASSERT_OK(hrbfnpr_line_set_get_info(lines.get(), &info, error));
    EXPECT_EQ(info.borders, 1);
    EXPECT_GT(info.left_out, 0.01);
}

TEST(Trim, KeepsItsSourceModelAlive) {
    Error error;
    const Context context = make_context();
    Model open = fit_whole(context, zone(0.0, 1.0));
    Model once = trimmed(open);
    open.reset();
    const Model again = trimmed(once);
    once.reset();
    EXPECT_EQ(info_of(again).parts, 1);
    auto info = made(hrbfnpr_model_info_init);
    ASSERT_OK(hrbfnpr_model_get_info(again.get(), &info, error));
    EXPECT_EQ(info.centres, whole / 2);
}

TEST(Trim, IsSavedWithTheModel) {
    Error error;
    const Context context = make_context();
    const Model model = trimmed(fit_whole(context, zone(0.0, 1.0)));
    std::int64_t size = 0;
    ASSERT_EQ(hrbfnpr_model_save_memory(model.get(), nullptr, 0, &size, error), HRBFNPR_STATUS_BUFFER_TOO_SMALL);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
    ASSERT_OK(hrbfnpr_model_save_memory(model.get(), bytes.data(), size, &size, error));
    hrbfnpr_model* made = nullptr;
    ASSERT_OK(hrbfnpr_model_load_memory(context.get(), bytes.data(), size, &made, error));
    const Model loaded(made);
    const hrbfnpr_trim_info before = info_of(model);
    const hrbfnpr_trim_info after = info_of(loaded);
    EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0);
    EXPECT_EQ(stipples_of(context, loaded), stipples_of(context, model));
    bytes[bytes.size() - 100] ^= 1U;
    EXPECT_EQ(hrbfnpr_model_load_memory(context.get(), bytes.data(), size, &made, error), HRBFNPR_STATUS_CORRUPT_DATA);
}

TEST(Trim, RefusesInvalidDescriptors) {
    Error error;
    const Context context = make_context();
    const Model model = fit_whole(context, zone(0.0, 1.0));
    const std::vector<double> two{0, 0, 1, 0, 0, nan};
    const std::vector<double> one{0, 0, 1};
    const std::vector<double> none{0, 0, 0};
    const auto refused = [&](const Model& of, const std::function<void(hrbfnpr_trim_desc&)>& change, const char* part) {
        auto desc = made(hrbfnpr_trim_desc_init);
        change(desc);
        hrbfnpr_model* got = nullptr;
        EXPECT_FAILS(hrbfnpr_model_trim(of.get(), &desc, nullptr, &got, error), invalid, part);
        EXPECT_EQ(got, nullptr);
    };
    refused(
        model, [&](auto& desc) { desc.points = in(two); }, "trim_desc.points[1]");
    refused(
        model,
        [&](auto& desc) {
            desc.points = in(one);
            desc.normals = in(none);
        },
        "trim_desc.normals[0] is zero");
    refused(
        model, [&](auto& desc) { desc.normals = in(one); }, "trim_desc.normals has 1 elements");
    refused(
        sphere_with_tube(context), [](auto&) {}, "trim_desc.points is empty");
}

// The fit of one sample is a plane without an end.
TEST(Trim, RefusesAModelOfOneSample) {
    Error error;
    const Context context = make_context();
    scenes::Samples samples;
    samples.points = {1.0, 2.0, 3.0};
    samples.normals = {0.0, 0.0, 1.0};
    const Model model = fit_whole(context, samples);
    hrbfnpr_model* got = nullptr;
    EXPECT_FAILS(hrbfnpr_model_trim(model.get(), nullptr, nullptr, &got, error), HRBFNPR_STATUS_NOT_CONVERGED,
                 "no part of the surface is near the samples");
}

} // namespace
} // namespace api_test::trim_test
