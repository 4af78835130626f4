// SPDX-License-Identifier: MIT
// Tests hrbfnpr_smooth_depth_image.
#include "fixture.h"
#include "support/depth_image.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace api_test::depth_image_test {
namespace {

using hrbfnpr::test::seen_depths;
using hrbfnpr::test::SeenDepths;

SeenDepths image() { return seen_depths(64, 48, {0.0014, 0.0029, 1.0}); }

hrbfnpr_depth_image_desc desc_of(const SeenDepths& seen) {
    auto desc = made(hrbfnpr_depth_image_desc_init);
    desc.columns = seen.columns;
    desc.rows = seen.rows;
    desc.points = in(seen.points);
    return desc;
}

TEST(DepthImage, WritesPointsNormalsAndInfo) {
    Error error;
    const Context context = make_context();
    const SeenDepths seen = image();
    const auto desc = desc_of(seen);
    std::vector<double> points(seen.points.size());
    std::vector<float> normals(seen.points.size());
    const hrbfnpr_array_out to_points = out(points), to_normals = out(normals);
    auto info = made(hrbfnpr_depth_image_info_init);
    ASSERT_OK(hrbfnpr_smooth_depth_image(context.get(), &desc, nullptr, &to_points, &to_normals, &info, error));
    double before = 0.0;
    double after = 0.0;
    std::int64_t there = 0;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        if (std::isnan(points[i])) {
            EXPECT_TRUE(normals[i] == 0.0F && normals[i + 1] == 0.0F && normals[i + 2] == 0.0F);
            continue;
        }
        ++there;
        EXPECT_NEAR(std::hypot(normals[i], normals[i + 1], normals[i + 2]), 1.0, 1e-6);
        before += std::abs(1.0 / seen.points[i + 2] - 1.0 / seen.truth[i / 3]);
        after += std::abs(1.0 / points[i + 2] - 1.0 / seen.truth[i / 3]);
    }
    EXPECT_LT(after, 0.8 * before); // holds for so small an image; room tests have the numbers
    EXPECT_EQ(info.seen, 64 * 48 - 8 * 6);
    EXPECT_EQ(there, info.seen - info.left_out);
    EXPECT_NEAR(info.noise, 0.0016, 0.0005);
    EXPECT_NEAR(info.focal_length, 51.2, 1e-6);
    EXPECT_NEAR(info.depth, 3.0, 0.3);
    EXPECT_GT(info.radius, 2.0);
    EXPECT_GT(info.seconds, 0.0);

    // Smoothing in place works, and neither output array is required.
    SeenDepths in_place = seen;
    const auto over = desc_of(in_place);
    const hrbfnpr_array_out there_too = out(in_place.points);
    ASSERT_OK(hrbfnpr_smooth_depth_image(context.get(), &over, nullptr, &there_too, nullptr, nullptr, error));
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_TRUE(in_place.points[i] == points[i] || std::isnan(points[i]));
    EXPECT_OK(hrbfnpr_smooth_depth_image(context.get(), &desc, nullptr, nullptr, nullptr, &info, error));
}

TEST(DepthImage, BadInputsAreNamed) {
    struct Row {
        std::function<void(hrbfnpr_depth_image_desc&, hrbfnpr_array_out&)> change;
        const char* message;
    };
    const Row rows[] = {
        {[](auto& d, auto&) { d.columns = 7; }, "depth_image_desc.columns is 7"},
        {[](auto& d, auto&) { d.rows = -1; }, "depth_image_desc.rows is -1"},
        {[](auto& d, auto&) { d.rows = 65536; }, "depth_image_desc.rows is 65536"},
        {[](auto& d, auto&) { d.keep_points = 2; }, "depth_image_desc.keep_points is 2"},
        {[](auto& d, auto&) { d.noise = -1.0; }, "depth_image_desc.noise"},
        {[](auto& d, auto&) { d.noise = NAN; }, "depth_image_desc.noise"},
        {[](auto& d, auto&) { d.smoothing = 0.0; }, "depth_image_desc.smoothing"},
        {[](auto& d, auto&) { d.smoothing = 101.0; }, "depth_image_desc.smoothing"},
        {[](auto& d, auto&) { d.rows = 47; }, "64 columns x 47 rows are 3008"},
        {[](auto& d, auto&) { d.points = {}; }, "depth_image_desc.points has 0 elements"},
        {[](auto& d, auto&) { d.points.components = 2; }, "depth_image_desc.points"},
        {[](auto& d, auto&) { std::swap(d.columns, d.rows); }, "not an image of a camera at the origin"},
        {[](auto&, auto& o) { o.count = 3; }, "out_points.count is 3; it must be 3072"},
        {[](auto&, auto& o) { o.scalar = HRBFNPR_SCALAR_UINT8; }, "out_points.scalar"},
    };
    const Context context = make_context();
    const SeenDepths seen = image();
    for (const Row& row : rows) {
        Error error;
        auto desc = desc_of(seen);
        std::vector<double> points(seen.points.size(), 7.0);
        hrbfnpr_array_out target = out(points);
        row.change(desc, target);
        EXPECT_FAILS(hrbfnpr_smooth_depth_image(context.get(), &desc, nullptr, &target, nullptr, nullptr, error),
                     HRBFNPR_STATUS_INVALID_ARGUMENT, row.message);
        EXPECT_EQ(points, std::vector<double>(points.size(), 7.0));
    }
    Error error;
    EXPECT_FAILS(hrbfnpr_smooth_depth_image(context.get(), nullptr, nullptr, nullptr, nullptr, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "depth_image_desc");
}

// A result that FLOAT32 cannot hold is an error, and nothing is written.
TEST(DepthImage, RefusesResultsThatFloatsCannotHold) {
    Error error;
    const Context context = make_context();
    SeenDepths seen = image();
    for (double& x : seen.points) x *= 1e60;
    const auto desc = desc_of(seen);
    std::vector<float> points(seen.points.size(), 7.0F);
    const hrbfnpr_array_out target = out(points);
    EXPECT_FAILS(hrbfnpr_smooth_depth_image(context.get(), &desc, nullptr, &target, nullptr, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "too large for FLOAT32; give a FLOAT64 array");
    EXPECT_EQ(points, std::vector<float>(points.size(), 7.0F));
}

} // namespace
} // namespace api_test::depth_image_test
