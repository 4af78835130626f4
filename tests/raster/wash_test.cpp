// SPDX-License-Identifier: MIT
// The paper of a layer must not wash out the ink of the same layer, but it must wash out the ink farther from the eye.
#include "raster/picture.h"

#include <gtest/gtest.h>

namespace hrbfnpr::testing::wash_test {
namespace {

using frame::HiddenLines;

Style inked(HiddenLines hidden_lines) {
    Style style;
    style.hidden_lines = hidden_lines;
    style.tone = frame::Tone::none;
    style.kind[0].radius = 1.2F;
    return style;
}

class Wash : public ::testing::Test {
protected:
    // Returns the darkness with attenuation over that without.
    double kept(const marks::PointSet& set, const frame::Camera& camera, const Style& style, int size) {
        Style shown = style;
        shown.hidden_lines = HiddenLines::show;
        const std::array with{item_of(set, style)};
        const std::array without{item_of(set, shown)};
        return picture_of(runtime, with, camera, size, size).darkness() /
               picture_of(runtime, without, camera, size, size).darkness();
    }

    base::Runtime runtime;
};

TEST_F(Wash, APlaneKeepsItsInkAtAnyTilt) {
    const marks::PointSet set = plane(runtime.memory, 80);
    for (const double tilt : {0.0, 0.3, 0.7, 1.0, 1.2, 1.35}) {
        frame::Camera camera = front_camera(400, 400);
        const glm::dvec3 eye(0.0, -10.0 * std::sin(tilt), 10.0 * std::cos(tilt));
        camera.view = frame::look_at(eye, glm::dvec3(0.0), {1, 0, 0});
        EXPECT_GT(kept(set, camera, inked(HiddenLines::attenuate), 400), 0.99) << tilt;
        camera.projection = frame::perspective(0.25, 400, 400, 1.0, 30.0, camera.depth);
        EXPECT_GT(kept(set, camera, inked(HiddenLines::attenuate), 400), 0.99) << tilt;
    }
}

TEST_F(Wash, ASphereKeepsItsInkAndItsContour) {
    for (const int count : {3000, 20000}) {
        const marks::PointSet set = sphere(runtime.memory, count);
        // Draws all ink, then the contour alone. The far half of the contour's band is under the near one.
        Style style = inked(HiddenLines::attenuate);
        EXPECT_GT(kept(set, front_camera(500, 500), style, 500), 0.97) << count;
        style.kind[0].shown = false;
        EXPECT_GT(kept(set, front_camera(500, 500), style, 500), 0.94) << count;
        style.silhouette_threshold = 0.08;
        EXPECT_GT(kept(set, front_camera(500, 500), style, 500), 0.93) << count;
    }
}

TEST_F(Wash, AScaledMirroredAndTurnedSphereKeepsItsInk) {
    const marks::PointSet set = sphere(runtime.memory, 10000, 0.1);
    glm::dmat4 transform(0.0);
    transform[1][0] = -10.0;
    transform[0][1] = 10.0;
    transform[2][2] = -10.0;
    transform[3][3] = 1.0;
    Style style = inked(HiddenLines::attenuate);
    const std::array with{item_of(set, style, transform)};
    style.hidden_lines = HiddenLines::show;
    const std::array without{item_of(set, style, transform)};
    const double dark = picture_of(runtime, without, front_camera(400, 400), 400, 400).darkness();
    EXPECT_GT(picture_of(runtime, with, front_camera(400, 400), 400, 400).darkness(), 0.97 * dark);
}

// Turns about z, so that the marks of two layers do not coincide in a lattice.
glm::dmat4 turned(double angle, double z) {
    glm::dmat4 m(1.0);
    m[0] = {std::cos(angle), std::sin(angle), 0.0, 0.0};
    m[1] = {-std::sin(angle), std::cos(angle), 0.0, 0.0};
    m[3] = {0.0, 0.0, z, 1.0};
    return m;
}

// Returns the darkness of one layer's ink behind the paper of another.
double darkness_behind(const base::Runtime& runtime, const Style& style, double gap, int side) {
    const marks::PointSet set = plane(runtime.memory, side);
    Style paper_only = style;
    paper_only.kind[0].share = 0.0F;
    const std::array items{item_of(set, style, turned(0.4, -gap)), item_of(set, paper_only)};
    const Picture picture = picture_of(runtime, items, front_camera(300, 300), 300, 300);
    return picture.darkness(50, 50, 250, 250);
}

TEST_F(Wash, AFrontLayerHasItsOpacityAtAnyDensity) {
    for (const int side : {40, 80, 120}) {
        Style style = inked(HiddenLines::attenuate);
        style.attenuation_front = 0.0;
        const double bare = darkness_behind(runtime, style, 0.5, side);
        for (const double lambda : {0.1, 0.3}) {
            for (const float layers : {1.0F, 3.0F}) {
                style.attenuation_front = lambda;
                style.splat_overlap = layers;
                const double left = darkness_behind(runtime, style, 0.5, side) / bare;
                EXPECT_NEAR(left, std::pow(1.0 - lambda, static_cast<double>(layers)), 0.03) << side;
            }
        }
        style.attenuation_front = 1.0;
        EXPECT_EQ(darkness_behind(runtime, style, 0.5, side), 0.0) << "gaps in the paper";
    }
}

TEST_F(Wash, EachLayerAttenuatesByTheSameFactor) {
    const marks::PointSet set = plane(runtime.memory, 60);
    Style style = inked(HiddenLines::attenuate);
    style.attenuation_front = 0.3;
    style.splat_overlap = 2.0F;
    Style paper_only = style;
    paper_only.kind[0].share = 0.0F;
    std::vector<frame::Item> items{item_of(set, style)};
    double before = 0.0;
    for (int layers = 0; layers < 4; ++layers) {
        const double darkness = picture_of(runtime, items, front_camera(300, 300), 300, 300).darkness(50, 50, 250, 250);
        if (layers > 0) {
            EXPECT_NEAR(darkness / before, 0.49, 0.04);
        }
        before = darkness;
        items.push_back(item_of(set, paper_only, turned(0.4 * (layers + 1), 0.5 * (layers + 1))));
    }
}

TEST_F(Wash, AHaloSurroundsTheFrontItem) {
    // Dark ink is far behind a sphere. The paper of the sphere's back marks clears a rim around it.
    const marks::PointSet ball = sphere(runtime.memory, 20000, 0.5);
    const marks::PointSet wall = plane(runtime.memory, 100);
    Style style = inked(HiddenLines::attenuate);
    Style blank = style;
    blank.kind[0].share = 0.0F;
    blank.contour_kinds = 0;
    blank.splat_radius = 1.0F;
    glm::dmat4 behind(1.0);
    behind[3][2] = -2.0;
    const auto ring = [&](float halo) {
        blank.halo_width = halo;
        const std::array items{item_of(wall, style, behind), item_of(ball, blank)};
        const Picture picture = picture_of(runtime, items, front_camera(500, 500), 500, 500);
        double dark = 0.0;
        int count = 0;
        for (int y = 0; y < 500; ++y) {
            for (int x = 0; x < 500; ++x) {
                const double r = std::hypot(x + 0.5 - 250.0, y + 0.5 - 250.0);
                if (r < 103.0 || r > 107.0) continue; // the ball's radius is 100 pixels
                dark += 1.0 - picture.at(x, y, 0) / 255.0;
                ++count;
            }
        }
        return dark / count;
    };
    const double bare = ring(0.0F);
    EXPECT_GT(bare, 0.1);
    EXPECT_LT(ring(10.0F), 0.5 * bare);
    blank.splat_overlap = 0.0F; // as in the published method
    EXPECT_LT(ring(10.0F), 0.02 * bare);
}

} // namespace
} // namespace hrbfnpr::testing::wash_test
