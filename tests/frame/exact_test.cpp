// SPDX-License-Identifier: MIT
// Tests visibility that is computed from the surface itself.
#include "frame/line_of_sight.h"
#include "frame/scene/light.h"
#include "support/analytic.h"

#include <gtest/gtest.h>

#include <array>

namespace hrbfnpr::testing::exact_test {
namespace {

using frame::HiddenLines;

constexpr int size = 500;
constexpr double half = 1.6;
constexpr double pixel = 2.0 * half / size;

class ExactVisibility : public ::testing::Test {
protected:
    std::vector<float> shares(const Style& style, const frame::Camera& camera, const glm::dmat4& transform,
                              bool exact = true) {
        frame::Item item = layered_item(set, style, transform);
        if (exact) item.model = &solid;
        const std::array items{item};
        frame.draw(items, camera);
        return seen_share(frame, set.layers[0].count());
    }

    base::Runtime runtime;
    test::Torus solid{1.0, 0.45};
    marks::PointSet set = clustered(runtime, torus(runtime.memory, 160));
    DrawnFrame frame{runtime};
};

TEST_F(ExactVisibility, FrontMarksAreHiddenWhereTheLineOfSightIsBlocked) {
    Style style = all_front(HiddenLines::hide);
    style.halo_width = 0.0F;
    for (const double tilt : {0.9, 1.2, 1.4}) {
        const glm::dvec3 toward(0.0, -std::sin(tilt), std::cos(tilt));
        const std::vector<float> share = shares(style, camera_from(toward, size, half), glm::dmat4(1.0));
        int hidden = 0;
        int seen = 0;
        for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
            const Mark mark = mark_of(set, i);
            const float drawn = share[static_cast<std::size_t>(i) + 1];
            if (glm::dot(mark.normal, toward) < 0.25) continue;
            // A ray starts half a pixel outside.
            const double clear = own_clearance(ring(), mark.position + 0.5 * pixel * mark.normal, toward);
            if (std::abs(clear) < 0.05 * pixel) continue;
            ASSERT_EQ(drawn > 0.0F, clear > 0.0) << tilt << " " << i << " " << clear / pixel;
            ++(clear > 0.0 ? seen : hidden);
        }
        EXPECT_GT(seen, 3000);
        EXPECT_GT(hidden, tilt > 1.0 ? 300 : -1);
        EXPECT_EQ(frame.info().dropped_hidden + frame.info().shown, frame.info().front);
    }
}

TEST_F(ExactVisibility, FollowsTheTransformAndThePerspective) {
    Style style = all_front(HiddenLines::hide);
    style.halo_width = 0.0F;
    const double tilt = 1.25;
    const glm::dvec3 toward(0.0, -std::sin(tilt), std::cos(tilt));
    const std::vector<float> plain = shares(style, camera_from(toward, size, half), glm::dmat4(1.0));
    // Everything is twice as large, moved and seen from there, which gives the same picture.
    glm::dmat4 larger(2.0);
    larger[3] = glm::dvec4(3.0, -1.0, 5.0, 1.0);
    frame::Camera camera = camera_from(toward, size, 2.0 * half);
    camera.view = camera.view * shifted({-3.0, 1.0, -5.0});
    EXPECT_EQ(shares(style, camera, larger), plain);
    // In perspective, the eye sees the far side of the tube through the hole.
    frame::Camera near_by = camera_from(toward, size, half);
    const glm::dvec3 eye = 4.0 * toward;
    near_by.view = frame::look_at(eye, glm::dvec3(0.0), {0, 0, 1});
    near_by.projection = frame::perspective(0.9, size, size, 0.5, 20.0, near_by.depth);
    const std::vector<float> share = shares(style, near_by, glm::dmat4(1.0));
    int selected = 0;
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
        const Mark mark = mark_of(set, i);
        const glm::dvec3 sight = glm::normalize(eye - mark.position);
        if (glm::dot(mark.normal, sight) < 0.25) continue;
        const double clear = own_clearance(ring(), mark.position + 0.003 * mark.normal, sight, 3.0);
        if (std::abs(clear) < 0.005) continue;
        ASSERT_EQ(share[static_cast<std::size_t>(i) + 1] > 0.0F, clear > 0.0) << i << " " << clear;
        ++selected;
    }
    EXPECT_GT(selected, 3000);
}

TEST_F(ExactVisibility, DimsByTheLawsOfTheLayersThatALineCrosses) {
    Style style = all_front(HiddenLines::attenuate);
    style.halo_width = 0.0F;
    style.attenuation_front = 0.4;
    style.attenuation_back = 0.3;
    style.splat_overlap = 2.0F;
    const double tilt = 1.25;
    const glm::dvec3 toward(0.0, -std::sin(tilt), std::cos(tilt));
    const frame::Camera camera = camera_from(toward, size, half);
    const std::vector<float> exact = shares(style, camera, glm::dmat4(1.0));
    int dimmed = 0;
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
        const Mark mark = mark_of(set, i);
        const float drawn = exact[static_cast<std::size_t>(i) + 1];
        if (glm::dot(mark.normal, toward) < 0.3) continue;
        if (std::abs(own_clearance(ring(), mark.position + 0.5 * pixel * mark.normal, toward)) < pixel) continue;
        // The law uses the normals where the line goes through the surface.
        double law = 1.0;
        double before = 1.0;
        for (double t = 0.02; t < 4.0; t += 0.001) {
            const glm::dvec3 p = mark.position + t * toward;
            const double d = ring()(p);
            if (t > 0.021 && (d < 0.0) != (before < 0.0)) {
                const test::Field field = solid.at(p);
                law *= static_cast<double>(frame::layer_transmittance(
                    style, static_cast<float>(-glm::dot(glm::normalize(field.gradient), toward)), false));
            }
            before = d;
        }
        ASSERT_NEAR(static_cast<double>(drawn), law, 0.02) << i; // rays start half a pixel outside
        dimmed += law < 0.9;
    }
    EXPECT_GT(dimmed, 300);
}

TEST_F(ExactVisibility, ShowLeavesHiddenMarksUndimmed) {
    const double tilt = 1.25;
    const frame::Camera camera = camera_from({0.0, -std::sin(tilt), std::cos(tilt)}, size, half);
    const std::vector<float> share = shares(all_front(HiddenLines::show), camera, glm::dmat4(1.0));
    EXPECT_EQ(frame.info().dropped_hidden, 0);
    EXPECT_EQ(frame.info().shown, frame.info().front);
    for (const float drawn : share) EXPECT_TRUE(drawn == 1.0F || drawn == -1.0F) << drawn;
}

} // namespace
} // namespace hrbfnpr::testing::exact_test
