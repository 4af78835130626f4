// SPDX-License-Identifier: MIT
// Tests cameras: matrices, depth conventions, the fit to a box, and bad arguments.
#include "frame/hand_made.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>

namespace hrbfnpr::testing::camera_test {
namespace {

using frame::Camera;
using frame::DepthConvention;
using ::testing::HasSubstr;

constexpr std::array conventions{DepthConvention::negative_one_to_one, DepthConvention::zero_to_one,
                                 DepthConvention::reversed};

glm::dvec3 project(const Camera& camera, const glm::dvec3& p) {
    const glm::dvec4 clip = camera.projection * camera.view * glm::dvec4(p, 1.0);
    return glm::dvec3(clip) / clip.w;
}

double clip_near(DepthConvention depth) {
    return depth == DepthConvention::negative_one_to_one ? -1.0 : depth == DepthConvention::reversed ? 1.0 : 0.0;
}
double clip_far(DepthConvention depth) { return depth == DepthConvention::reversed ? 0.0 : 1.0; }

TEST(LookAt, PutsTheTargetOnNegativeZAndKeepsUpUpward) {
    const glm::dvec3 eye(1.0, 2.0, 3.0);
    const glm::dvec3 target(4.0, -2.0, 3.0);
    const glm::dmat4 view = frame::look_at(eye, target, {0.1, 0.0, 2.0});
    EXPECT_LT(glm::length(glm::dvec3(view * glm::dvec4(eye, 1.0))), 1e-14);
    const glm::dvec4 t = view * glm::dvec4(target, 1.0);
    EXPECT_NEAR(t.x, 0.0, 1e-14);
    EXPECT_NEAR(t.y, 0.0, 1e-14);
    EXPECT_NEAR(t.z, -5.0, 1e-14);
    const glm::dvec4 up = view * glm::dvec4(0.1, 0.0, 2.0, 0.0);
    EXPECT_NEAR(up.x, 0.0, 1e-14);
    EXPECT_GT(up.y, 0.0);
    EXPECT_NEAR(glm::determinant(view), 1.0, 1e-14);
}

TEST(LookAt, WorksFarFromTheOriginAndWithTinyVectors) {
    const glm::dvec3 eye(1e6, -2e6, 1e6);
    const glm::dvec4 t = frame::look_at(eye, eye + glm::dvec3(0.0, 1.0, 0.0), {0.0, 0.0, 1e-200}) *
                         glm::dvec4(eye + glm::dvec3(0.25, 1.0, 0.5), 1.0);
    EXPECT_NEAR(t.x, 0.25, 1e-8);
    EXPECT_NEAR(t.y, 0.5, 1e-8);
    EXPECT_NEAR(t.z, -1.0, 1e-8);
}

TEST(Perspective, MapsTheFrustumToClipSpace) {
    for (const DepthConvention depth : conventions) {
        const glm::dmat4 p = frame::perspective(0.8, 400.0, 200.0, 0.5, 50.0, depth);
        const double y = std::tan(0.4);
        const auto at = [&](double fx, double fy, double z) {
            const glm::dvec4 clip = p * glm::dvec4(fx * 2.0 * y * z, fy * y * z, -z, 1.0);
            return glm::dvec3(clip) / clip.w;
        };
        EXPECT_LT(glm::length(at(1.0, 1.0, 0.5) - glm::dvec3(1.0, 1.0, clip_near(depth))), 1e-12);
        EXPECT_LT(glm::length(at(-1.0, 1.0, 50.0) - glm::dvec3(-1.0, 1.0, clip_far(depth))), 1e-12);
    }
}

TEST(Orthographic, MapsTheSlabToClipSpaceWithPlanesOfEitherSign) {
    for (const DepthConvention depth : conventions) {
        const glm::dmat4 p = frame::orthographic(4.0, 300.0, 200.0, -2.0, 6.0, depth);
        EXPECT_LT(glm::length(glm::dvec3(p * glm::dvec4(3.0, 2.0, 2.0, 1.0)) - glm::dvec3(1, 1, clip_near(depth))),
                  1e-12);
        EXPECT_LT(glm::length(glm::dvec3(p * glm::dvec4(-3.0, 2.0, -6.0, 1.0)) - glm::dvec3(-1, 1, clip_far(depth))),
                  1e-12);
    }
}

// The half extents of the box's image around the picture's centre, from its corners.
glm::dvec2 image_reach(const Camera& camera, const geometry::Bounds& box) {
    glm::dvec2 most(0.0);
    for (unsigned i = 0; i < 8; ++i) {
        const glm::dvec3 corner((i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
                                (i & 4U) != 0 ? box.max.z : box.min.z);
        const glm::dvec3 at = project(camera, corner);
        most = glm::max(most, glm::abs(glm::dvec2(at)));
        EXPECT_GT(at.z, std::min(clip_near(camera.depth), clip_far(camera.depth)));
        EXPECT_LT(at.z, std::max(clip_near(camera.depth), clip_far(camera.depth)));
    }
    return most;
}

TEST(FitBounds, FillsThePictureExceptTheMargin) {
    const geometry::Bounds box{{-1.0, 2.0, 5.0}, {3.0, 3.0, 7.0}};
    for (const DepthConvention depth : conventions) {
        for (const double angle : {0.0, 0.3, 1.5}) {
            for (const double margin : {0.0, 0.05, 0.45}) {
                for (const glm::dvec2 size : {glm::dvec2(800, 300), glm::dvec2(200, 900)}) {
                    const Camera camera =
                        frame::fit_bounds(box, {0.3, -1.0, 0.4}, {0, 0, 1}, angle, size.x, size.y, margin, depth);
                    const glm::dvec2 reach = image_reach(camera, box);
                    EXPECT_NEAR(std::max(reach.x, reach.y), 1.0 - 2.0 * margin, 1e-9) << angle << " " << margin;
                    EXPECT_EQ(camera.viewport, glm::dvec4(0.0, 0.0, size.x, size.y));
                    EXPECT_LT(glm::length(glm::dvec2(project(camera, box.centre()))), 1e-12);
                }
            }
        }
    }
}

TEST(FitBounds, KeepsTheEyeOffTheBoxUnderAVeryWideAngle) {
    const geometry::Bounds box{{-1.0, 2.0, 5.0}, {3.0, 3.0, 7.0}};
    const Camera camera =
        frame::fit_bounds(box, {0.3, -1.0, 0.4}, {0, 0, 1}, 2.8, 300, 200, 0.05, DepthConvention::zero_to_one);
    const glm::dvec2 reach = image_reach(camera, box);
    EXPECT_LE(std::max(reach.x, reach.y), 0.9);
}

TEST(FitBounds, ShowsFlatThinAndPointBoxes) {
    for (const double angle : {0.0, 0.6}) {
        for (const glm::dvec3 size : {glm::dvec3(0.0), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 0)}) {
            const glm::dvec3 corner(10.0, 20.0, 30.0);
            const Camera camera = frame::fit_bounds({corner, corner + size}, {0, 0, -1}, {0, 1, 0}, angle, 100, 100,
                                                    0.1, DepthConvention::zero_to_one);
            const glm::dvec2 reach = image_reach(camera, {corner, corner + size});
            EXPECT_LE(std::max(reach.x, reach.y), 0.8 + 1e-9);
        }
    }
}

// The points fill the picture in one direction, and are centred in both.
TEST(FitPoints, FillThePictureAndLieInItsMiddle) {
    const std::array<float, 12> points = {0.0F, 0.0F, 0.0F, 3.0F, 0.5F, 0.0F, 1.0F, 2.0F, -1.0F, 0.2F, 0.3F, 4.0F};
    const base::InView view{reinterpret_cast<const std::byte*>(points.data()), 4, 12, base::Scalar::float32, 3};
    const glm::dvec3 origin(100.0, -50.0, 20.0);
    for (const double angle : {0.0, 0.6, 1.0}) {
        for (const glm::dvec2 size : {glm::dvec2(300, 200), glm::dvec2(200, 500)}) {
            const Camera camera = frame::fit_points(view, origin, {0.3, -1.0, 0.4}, {0, 0, 1}, angle, size.x, size.y,
                                                    0.1, DepthConvention::zero_to_one);
            glm::dvec3 low(1e9);
            glm::dvec3 high(-1e9);
            for (std::size_t i = 0; i < 4; ++i) {
                const glm::dvec3 p =
                    project(camera, origin + glm::dvec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]));
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
            EXPECT_NEAR(std::max(high.x - low.x, high.y - low.y), 1.6, 1e-6) << angle;
            EXPECT_GT(low.z, 0.0);
            EXPECT_LT(high.z, 1.0);
            if (angle > 0.0) continue; // perspective centres the cone of sight, not the picture's extents
            EXPECT_LT(glm::length(glm::dvec2(low + high)), 1e-6);
        }
    }
}

TEST(FitPoints, ShowsOnePoint) {
    const std::array<double, 3> point = {5.0, 6.0, 7.0};
    const base::InView view{reinterpret_cast<const std::byte*>(point.data()), 1, 24, base::Scalar::float64, 3};
    for (const double angle : {0.0, 0.6}) {
        const Camera camera = frame::fit_points(view, glm::dvec3(0.0), {0, 0, -1}, {0, 1, 0}, angle, 100, 100, 0.1,
                                                DepthConvention::zero_to_one);
        EXPECT_LT(glm::length(glm::dvec2(project(camera, {5.0, 6.0, 7.0}))), 1e-9);
    }
}

struct BadCamera {
    const char* named;
    std::function<void()> call;
};

} // namespace
} // namespace hrbfnpr::testing::camera_test
