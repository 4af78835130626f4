// SPDX-License-Identifier: MIT
// Tests images of depth cameras: which points are smoothed, which are not, and their normals.
#include "orient/depth_image.h"

#include "base/status.h"
#include "shapes.h"
#include "support/depth_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace orient_test::depth_image_test {
namespace {

using namespace hrbfnpr;
using test::DepthSensor;
using test::seen_depths;
using test::SeenDepths;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// A Kinect has 1 / z in steps of 0.0029 / m, with an error of half a step.
constexpr DepthSensor kinect{0.0014, 0.0029, 1.0};

orient::DepthImageInput input_of(const SeenDepths& image) {
    orient::DepthImageInput input;
    input.points = view(image.points);
    input.columns = image.columns;
    input.rows = image.rows;
    return input;
}

// Results use the memory of this runtime, so it lives as long as the program.
const base::Runtime& plain() {
    static const base::Runtime runtime;
    return runtime;
}

orient::DepthImage smoothed(const SeenDepths& image, const base::Runtime& runtime = plain()) {
    return orient::smooth_depth_image(runtime, input_of(image));
}

struct Errors {
    double depth = 0.0;  // root mean square, in 1 / z
    double normal = 0.0; // mean angle in degrees
    double worst = 0.0;  // largest error, in 1 / z
};

enum class Of { all, wall, ball };

Errors errors_of(const SeenDepths& image, const orient::DepthImage& result, Of of = Of::all) {
    const geometry::VecArray& point = result.point;
    const geometry::VecArray& normal = result.normal;
    const glm::dvec3 wall = at(image.normals, point.size() - 1);
    Errors errors;
    std::int64_t count = 0;
    for (std::int64_t i = 0; i < point.size(); ++i) {
        const bool of_wall = at(image.normals, i) == wall;
        if (std::isnan(point.z[i]) || (of == Of::wall && !of_wall) || (of == Of::ball && of_wall)) continue;
        const double off = 1.0 / point.z[i] - 1.0 / image.truth[static_cast<std::size_t>(i)];
        errors.depth += off * off;
        errors.worst = std::max(errors.worst, std::abs(off));
        const double cosine = glm::dot(normal[i], at(image.normals, i));
        errors.normal += std::acos(std::clamp(cosine, -1.0, 1.0)) * 57.29577951308232;
        ++count;
    }
    errors.depth = std::sqrt(errors.depth / static_cast<double>(count));
    errors.normal /= static_cast<double>(count);
    return errors;
}

TEST(DepthImage, RemovesMostOfTheNoise) {
    const SeenDepths image = seen_depths(320, 240, kinect);
    const orient::DepthImage result = smoothed(image);
    const Errors wall = errors_of(image, result, Of::wall);
    EXPECT_LT(wall.depth, 0.25 * kinect.noise);
    EXPECT_LT(wall.normal, 2.0);
    const Errors ball = errors_of(image, result, Of::ball); // smoothing flattens the ball over such a radius
    EXPECT_LT(ball.depth, 1.5 * kinect.noise);
    EXPECT_LT(ball.normal, 8.0);
    EXPECT_LT(std::max(wall.worst, ball.worst), 12.0 * kinect.noise) << "nothing is between the ball and the wall";
    const std::int64_t hidden = 40 * 30;
    EXPECT_EQ(result.report.seen, 320 * 240 - hidden);
    EXPECT_LT(result.report.left_out, 100);
    // Rounding adds step^2 / 12 to the variance.
    EXPECT_NEAR(result.report.noise, std::hypot(0.0014, 0.0029 / std::sqrt(12.0)), 0.0003);
    EXPECT_NEAR(result.report.focal_length, 256.0, 1e-6);
    EXPECT_NEAR(result.report.depth, 3.0, 0.3);
    EXPECT_GT(result.report.radius, 8.0);
}

// The planes are exact on the wall. On the ball, which is curved, they determine the error.
TEST(DepthImage, KeepsExactPointsInPlace) {
    const SeenDepths image = seen_depths(320, 240);
    const orient::DepthImage result = smoothed(image);
    const Errors errors = errors_of(image, result);
    EXPECT_LT(errors_of(image, result, Of::wall).worst, 1e-4);
    EXPECT_LT(errors_of(image, result, Of::wall).normal, 0.02) << "slopes are not drawn to 0";
    EXPECT_LT(errors.worst, 1e-2) << "at the ball's outline, 0.17 before the wall";
    EXPECT_LT(errors.depth, 3e-4);
    EXPECT_LT(errors.normal, 0.5);
    EXPECT_LT(result.report.left_out, 1200) << "the ball's outline";
    EXPECT_EQ(result.report.radius, 2.0);
}

TEST(DepthImage, IsEmptyWhereTheCameraSawNothing) {
    const SeenDepths image = seen_depths(64, 48, kinect);
    const orient::DepthImage result = smoothed(image);
    for (std::int32_t row = 0; row < 48 / 8; ++row)
        for (std::int32_t column = 0; column < 64 / 8; ++column) {
            const std::int64_t i = row * 64 + column;
            EXPECT_TRUE(std::isnan(result.point.x[i]) && std::isnan(result.point.z[i]));
            EXPECT_EQ(result.normal[i], glm::dvec3(0.0));
        }
    std::int64_t here = 0;
    for (std::int64_t i = 0; i < result.point.size(); ++i) {
        here += std::isnan(result.point.x[i]) ? 0 : 1;
        if (!std::isnan(result.point.x[i])) {
            EXPECT_NEAR(glm::length(result.normal[i]), 1.0, 1e-12);
        }
    }
    EXPECT_EQ(here, result.report.seen - result.report.left_out);
}

TEST(DepthImage, LeavesOutPointsOnNoSurface) {
    SeenDepths image = seen_depths(64, 48, kinect);
    const std::int64_t lone = 40 * 64 + 50; // halfway between the camera and the wall
    for (std::size_t axis = 0; axis < 3; ++axis) image.points[static_cast<std::size_t>(3 * lone) + axis] *= 0.5;
    const std::int64_t before = smoothed(seen_depths(64, 48, kinect)).report.left_out;
    const orient::DepthImage result = smoothed(image);
    EXPECT_TRUE(std::isnan(result.point.z[lone]));
    EXPECT_EQ(result.report.left_out, before + 1);
}

TEST(DepthImage, NormalsFaceTheCameraOnBothSides) {
    for (const double side : {1.0, -1.0}) {
        const SeenDepths image = seen_depths(128, 96, {0.0014, 0.0, side});
        const orient::DepthImage result = smoothed(image);
        EXPECT_LT(errors_of(image, result).normal, 6.0);
        for (std::int64_t i = 0; i < result.point.size(); ++i)
            if (!std::isnan(result.point.z[i])) {
                EXPECT_LT(glm::dot(result.point[i], result.normal[i]), 0.0);
            }
    }
}

TEST(DepthImage, CanKeepThePoints) {
    const SeenDepths image = seen_depths(64, 48, kinect);
    orient::DepthImageInput input = input_of(image);
    input.keep_points = true;
    const orient::DepthImage kept = orient::smooth_depth_image(plain(), input);
    const orient::DepthImage moved = smoothed(image);
    for (std::int64_t i = 0; i < kept.point.size(); ++i) {
        EXPECT_EQ(kept.normal[i], moved.normal[i]);
        if (!std::isnan(kept.point.z[i])) {
            EXPECT_EQ(kept.point[i], at(image.points, i));
        }
    }
}

TEST(DepthImage, IsSmootherOverAWiderDisc) {
    const SeenDepths image = seen_depths(320, 240, kinect);
    double last = std::numeric_limits<double>::infinity();
    for (const double smoothing : {0.25, 0.5, 1.0}) {
        orient::DepthImageInput input = input_of(image);
        input.smoothing = smoothing;
        const orient::DepthImage result = orient::smooth_depth_image(plain(), input);
        const double error = errors_of(image, result).normal;
        EXPECT_LT(error, 0.8 * last) << smoothing;
        last = error;
    }
}

TEST(DepthImage, UsesTheGivenNoise) {
    const SeenDepths image = seen_depths(64, 48);
    orient::DepthImageInput input = input_of(image);
    input.noise = 0.01;
    const orient::DepthImage result = orient::smooth_depth_image(plain(), input);
    EXPECT_NEAR(result.report.noise, 0.01, 1e-15);
    EXPECT_NEAR(result.report.radius, 12.0 * std::sqrt(0.01 * result.report.depth * result.report.focal_length), 1e-9);
}

// The result is the same in any unit and for any number of threads.
TEST(DepthImage, DoesNotDependOnUnitsOrThreads) {
    const SeenDepths image = seen_depths(64, 48, kinect);
    const orient::DepthImage one = smoothed(image);
    base::Runtime many;
    many.parallel = base::Parallel(3, nullptr, nullptr);
    const orient::DepthImage other = smoothed(image, many);
    SeenDepths small = image;
    for (double& x : small.points) x *= 0x1p-20;
    const orient::DepthImage scaled = smoothed(small);
    for (std::int64_t i = 0; i < one.point.size(); ++i) {
        EXPECT_EQ(std::memcmp(&one.point.z[i], &other.point.z[i], sizeof(double)), 0);
        EXPECT_EQ(one.normal[i], other.normal[i]);
        EXPECT_EQ(one.normal[i], scaled.normal[i]);
    }
    EXPECT_EQ(scaled.report.noise, one.report.noise * 0x1p20);
}

// Numbers that overflow in between cause no crash and no infinite results.
TEST(DepthImage, AcceptsExtremeNumbers) {
    SeenDepths image = seen_depths(64, 48, kinect);
    const double odd[] = {0.0, 1e308, 5e-324, std::numeric_limits<double>::infinity(), nan};
    for (std::size_t i = 0; i < 5; ++i) {
        const std::size_t pixel = 3 * (24 * 64 + 8 * i);
        const double factor = odd[i] / image.points[pixel + 2];
        for (std::size_t axis = 0; axis < 3; ++axis) image.points[pixel + axis] *= factor;
    }
    const orient::DepthImage result = smoothed(image);
    for (std::int64_t i = 0; i < result.point.size(); ++i) {
        EXPECT_FALSE(std::isinf(result.point.x[i]) || std::isinf(result.point.z[i]));
        EXPECT_TRUE(std::isfinite(glm::length(result.normal[i])));
    }
}

// The reference is least squares over the whole disc. plane_around() agrees with it if no point is beyond the gate.
TEST(DepthPlanes, AreExactOnPlanes) {
    base::Memory memory;
    orient::InverseDepth depth(memory);
    depth.columns = depth.rows = 120;
    for (std::int32_t row = 0; row < 120; ++row)
        for (std::int32_t column = 0; column < 120; ++column) depth.value.push_back(1.0 + 0.002 * column - 0.003 * row);
    const orient::Discs discs(memory);
    const auto first = [&](std::int32_t column, std::int32_t row) {
        return orient::SmallPlane{{depth.at(column, row), 0.00195, -0.00305}, 1e-3};
    };
    for (std::int32_t radius = orient::Discs::least; radius <= orient::Discs::most; radius += 5) {
        const auto plane = orient::plane_around(depth, 60, 55, discs.of(radius), first(60, 55));
        ASSERT_TRUE(plane.has_value()) << radius;
        EXPECT_NEAR(plane->value, depth.at(60, 55), 1e-6);
        EXPECT_NEAR(plane->across, 0.002, 1e-4);
        EXPECT_NEAR(plane->down, -0.003, 1e-4);
        EXPECT_TRUE(orient::plane_around(depth, 0, 119, discs.of(radius), first(0, 119)).has_value()) << "in a corner";
    }
    const auto small = orient::small_plane(depth, 60, 55);
    ASSERT_TRUE(small.has_value());
    EXPECT_NEAR(small->plane.across, 0.002, 1e-12);
    EXPECT_NEAR(small->error, 0.0, 1e-12);
    EXPECT_FALSE(orient::small_plane(depth, 1, 55).has_value()) << "too near to the border";
}

TEST(DepthPlanes, IgnorePointsBeyondAnEdge) {
    base::Memory memory;
    orient::InverseDepth depth(memory);
    depth.columns = depth.rows = 60;
    for (std::int32_t row = 0; row < 60; ++row)
        for (std::int32_t column = 0; column < 60; ++column) depth.value.push_back(column < 30 ? 1.0 : 0.9);
    const orient::Discs discs(memory);
    for (const std::int32_t column : {28, 29, 30, 31}) {
        const auto plane =
            orient::plane_around(depth, column, 30, discs.of(12), {{depth.at(column, 30), 0.0, 0.0}, 1e-3});
        ASSERT_TRUE(plane.has_value());
        EXPECT_NEAR(plane->value, column < 30 ? 1.0 : 0.9, 1e-12);
        EXPECT_NEAR(plane->across, 0.0, 1e-12);
    }
}

} // namespace
} // namespace orient_test::depth_image_test
