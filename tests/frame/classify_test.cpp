// SPDX-License-Identifier: MIT
// Tests the positions of marks in the picture, and their classes.
#include "frame/hand_made.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace hrbfnpr::testing::classify_test {
namespace {

using drawing::Counts;
using drawing::MarkClass;
using frame::Item;
using ::testing::HasSubstr;

class Classify : public ::testing::Test {
protected:
    const Counts& draw(const marks::PointSet& set, const Style& style, const frame::Camera& camera,
                       const glm::dmat4& transform = glm::dmat4(1.0)) {
        const std::array items{item_of(set, style, transform)};
        frame.draw(items, camera);
        return frame.info();
    }

    base::Runtime runtime;
    DrawnFrame frame{runtime};
};

void expect_consistent(const Counts& info) {
    EXPECT_EQ(info.marks, info.outside + info.front + info.back + info.silhouette);
}

TEST_F(Classify, SharesOfADistantSphereAreProportionalToArea) {
    const int count = 20000;
    const marks::PointSet set = sphere(runtime.memory, count);
    for (const double threshold : {0.05, 0.2, 0.5}) {
        Style style = plain_style();
        style.silhouette_threshold = threshold;
        const Counts& info = draw(set, style, front_camera(100, 100));
        // n . v is uniform over the area of a sphere.
        EXPECT_NEAR(static_cast<double>(info.front), count * (1.0 - threshold) / 2.0, 3.0);
        EXPECT_NEAR(static_cast<double>(info.back), count * (1.0 - threshold) / 2.0, 3.0);
        EXPECT_NEAR(static_cast<double>(info.silhouette), count * threshold, 3.0);
        EXPECT_EQ(info.shown, info.front + info.silhouette);
        EXPECT_EQ(info.splats, 0);
        expect_consistent(info);
    }
}

TEST_F(Classify, PerspectiveLooksFromTheEye) {
    const int count = 20000;
    const marks::PointSet set = sphere(runtime.memory, count);
    frame::Camera camera = front_camera(100, 100);
    camera.view = frame::look_at({0.0, 0.0, 2.0}, glm::dvec3(0.0), {0.0, 1.0, 0.0});
    camera.projection = frame::perspective(1.5, 100, 100, 0.1, 20.0, camera.depth);
    Style style = plain_style();
    style.silhouette_threshold = 1e-4;
    const Counts& info = draw(set, style, camera);
    // From a distance of two radii a quarter of the sphere is visible: (1 - 1/2) / 2.
    EXPECT_NEAR(static_cast<double>(info.front), count * 0.25, 8.0);
}

TEST_F(Classify, AnOffAxisEyeIsTakenFromTheProjection) {
    // The projection contains a turn and a shift of the eye. This gives the same picture as with the shift in the view,
    // and so the same classes.
    const marks::PointSet set = sphere(runtime.memory, 5000);
    frame::Camera camera = front_camera(100, 100);
    camera.view = frame::look_at({0.3, 0.2, 3.0}, {0.1, 0.0, 0.0}, {0.0, 1.0, 0.0});
    camera.projection = frame::perspective(1.0, 100, 100, 0.1, 20.0, camera.depth);
    const Counts expected = draw(set, plain_style(), camera);
    camera.projection = camera.projection * camera.view;
    camera.view = glm::dmat4(1.0);
    const Counts& info = draw(set, plain_style(), camera);
    EXPECT_EQ(info.front, expected.front);
    EXPECT_EQ(info.back, expected.back);
    EXPECT_EQ(info.silhouette, expected.silhouette);
}

TEST_F(Classify, MarksLandOnTheirPixels) {
    for (const auto depth : {drawing::DepthConvention::negative_one_to_one, drawing::DepthConvention::zero_to_one,
                             drawing::DepthConvention::reversed}) {
        marks::PointSet set(runtime.memory);
        add_stipple(set, {0.25, 0.5, 1.0}, {0, 0, 1});
        frame::Camera camera = front_camera(200, 100, 1.0);
        camera.depth = depth;
        camera.projection = frame::orthographic(2.0, 200, 100, 1.0, 21.0, depth);
        camera.viewport = {30.0, 40.0, 200.0, 100.0};
        draw(set, plain_style(), camera);
        ASSERT_EQ(frame.discs().size(), 1U);
        const Disc& disc = frame.discs()[0];
        EXPECT_FLOAT_EQ(disc.x, 30.0F + 100.0F + 12.5F);
        EXPECT_FLOAT_EQ(disc.y, 40.0F + 50.0F - 25.0F);
        const float from_near = 8.0F / 20.0F; // 9 from the eye
        EXPECT_NEAR(disc.depth, depth == drawing::DepthConvention::reversed ? 1.0F - from_near : from_near, 1e-6F);
        EXPECT_EQ(disc.mark_class, MarkClass::front);
        EXPECT_EQ(disc.id, 1U);
        EXPECT_FALSE(disc.is_paper);
    }
}

TEST_F(Classify, MarksOutsideTheFrustumCountAsOutside) {
    marks::PointSet set(runtime.memory);
    const glm::dvec3 n(0.0, 0.0, 1.0);
    add_stipple(set, {0.0, 0.0, 0.0}, n);
    add_stipple(set, {1.0, 0.0, 0.0}, n);    // on the rim
    add_stipple(set, {1.019, 0.0, 0.0}, n);  // its disc still reaches in: 100 pixels per unit
    add_stipple(set, {1.5, 0.0, 0.0}, n);    // beside
    add_stipple(set, {0.0, -1.5, 0.0}, n);   // below
    add_stipple(set, {0.0, 0.0, 9.5}, n);    // in front of the near plane
    add_stipple(set, {0.0, 0.0, -10.5}, n);  // behind the far plane
    add_stipple(set, {0.0, 0.0, 1000.0}, n); // behind the camera
    Style style = plain_style();
    style.kind[0].radius = 1.5F;
    const Counts& info = draw(set, style, front_camera(200, 200, 1.0));
    EXPECT_EQ(info.marks, 8);
    EXPECT_EQ(info.front, 3);
    EXPECT_EQ(info.outside, 5);
    expect_consistent(info);
}

TEST_F(Classify, AMarkAtTheCameraStaysFinite) {
    marks::PointSet set(runtime.memory);
    set.spacing = 0.1;
    add_stipple(set, {0.0, 0.0, 10.0}, {0, 0, 1});
    add_stipple(set, {0.0, 0.0, 10.0 - 1e-7}, {0, 0, 1});
    add_stipple(set, {0.0, 0.0, 10.0 - 1e-3}, {0, 0, 1});
    frame::Camera camera = front_camera(100, 100);
    camera.projection = frame::perspective(1.0, 100, 100, 1e-9, 20.0, camera.depth);
    Style style;
    style.zoom_reference = 1.0;
    style.kind[0].radius_zoom = 1.0F;
    expect_consistent(draw(set, style, camera));
    for (const Disc& disc : frame.discs()) EXPECT_TRUE(std::isfinite(disc.radius) && std::isfinite(disc.x));
}

TEST_F(Classify, NonFiniteMarksCountAsOutside) {
    marks::PointSet set(runtime.memory);
    for (int i = 0; i < 6; ++i) add_stipple(set, {0.0, 0.0, 0.0}, {0, 0, 1});
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    set.layers[0].position[0] = nan;
    set.layers[0].position[3 + 1] = infinity;
    set.layers[0].position[6 + 2] = nan;
    set.layers[0].normal[9 + 1] = nan;
    for (int k = 0; k < 3; ++k) set.layers[0].normal[12 + k] = 0.0F;
    const Counts& info = draw(set, Style{}, front_camera(100, 100));
    EXPECT_EQ(info.outside, 5);
    EXPECT_EQ(info.front, 1);
}

// The ellipsoid's marks are made with the inverse of the transform, so that the frame sees a sphere.
TEST_F(Classify, NormalsFollowTheInverseTransposeAlsoUnderMirrors) {
    const int count = 5000;
    for (const glm::dvec3 scale : {glm::dvec3(1, 1, -1), glm::dvec3(-3, 0.5, 2), glm::dvec3(-2, -1, -0.25)}) {
        marks::PointSet set(runtime.memory);
        set.spacing = 0.05;
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 n = spiral_direction(i, count);
            add_stipple(set, n / scale, glm::normalize(n * scale));
        }
        glm::dmat4 transform(1.0);
        for (int k = 0; k < 3; ++k) transform[k][k] = scale[k];
        const Counts& info = draw(set, plain_style(), front_camera(100, 100), transform);
        EXPECT_NEAR(static_cast<double>(info.front), count * 0.4, 3.0);
        EXPECT_NEAR(static_cast<double>(info.back), count * 0.4, 3.0);
        for (const Disc& disc : frame.discs()) {
            const drawing::MarkSource source = frame.source(disc);
            ASSERT_NEAR(glm::dot(source.normal, source.position), 1.0F, 1e-4F);
            ASSERT_NEAR(glm::length(source.direction), 1.0F, 1e-5F);
            ASSERT_NEAR(glm::dot(source.normal, source.direction), 0.0F, 1e-4F);
        }
    }
}

TEST_F(Classify, DoesNotDependOnTheDistanceFromTheOrigin) {
    const marks::PointSet near_set = sphere(runtime.memory, 3000);
    draw(near_set, plain_style(), front_camera(500, 500));
    const std::vector<Disc> expected(frame.discs().begin(), frame.discs().end());

    const glm::dvec3 far(1e6, -1e6, 1e6 + 0.125);
    marks::PointSet far_set = sphere(runtime.memory, 3000);
    far_set.origin = far;
    frame::Camera camera = front_camera(500, 500);
    camera.view = frame::look_at(far + glm::dvec3(0, 0, 10), far, {0, 1, 0});
    draw(far_set, plain_style(), camera);
    ASSERT_EQ(frame.discs().size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_NEAR(frame.discs()[i].x, expected[i].x, 1e-4F);
        ASSERT_NEAR(frame.discs()[i].y, expected[i].y, 1e-4F);
    }
}

TEST_F(Classify, IdsCountHiddenLayersToo) {
    marks::PointSet first(runtime.memory);
    add_stipple(first, {0, 0, 0}, {0, 0, 1});
    add_stipple(first, {0, 0, 0.1}, {0, 0, 1});
    add_stroke(first, marks::Kind::own, {{0, 0, 0.2}}, {0, 0, 1});
    marks::PointSet second(runtime.memory);
    add_stipple(second, {0, 0, 0.3}, {0, 0, 1});
    Style no_stipples = plain_style();
    no_stipples.kind[0].shown = false;
    no_stipples.contour_kinds = 4;
    const std::array items{item_of(first, no_stipples), item_of(second, plain_style())};
    frame.draw(items, front_camera(100, 100));
    ASSERT_EQ(frame.discs().size(), 2U);
    EXPECT_EQ(frame.discs()[0].id, 3U);
    EXPECT_EQ(frame.discs()[1].id, 4U);
    EXPECT_EQ(frame.info().marks, 2);
    EXPECT_EQ(frame.source(frame.discs()[1]).position, glm::vec3(0.0F, 0.0F, 0.3F));
}

TEST_F(Classify, AcceptsNothingToDraw) {
    frame.draw({}, front_camera(100, 100));
    EXPECT_TRUE(frame.drawn());
    EXPECT_TRUE(frame.discs().empty());
    const marks::PointSet empty(runtime.memory);
    EXPECT_EQ(draw(empty, Style{}, front_camera(100, 100)).marks, 0);
    EXPECT_TRUE(frame.discs().empty());
}

} // namespace
} // namespace hrbfnpr::testing::classify_test
