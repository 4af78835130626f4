// SPDX-License-Identifier: MIT
// Tests which surfaces hide others, and the discs of paper.
#include "frame/hand_made.h"
#include "frame/scene/light.h"

#include <gtest/gtest.h>

namespace hrbfnpr::testing::visibility_test {
namespace {

using drawing::Counts;
using drawing::MarkClass;
using frame::HiddenLines;

Style hiding_style() {
    Style style;
    style.tone = frame::Tone::none;
    style.hidden_lines = HiddenLines::hide;
    return style;
}

glm::dmat4 moved(const glm::dvec3& by) {
    glm::dmat4 m(1.0);
    m[3] = glm::dvec4(by, 1.0);
    return m;
}

class Visibility : public ::testing::Test {
protected:
    const Counts& draw(std::span<const frame::Item> items, const frame::Camera& camera) {
        frame.draw(items, camera);
        return frame.info();
    }

    base::Runtime runtime;
    DrawnFrame frame{runtime};
};

TEST_F(Visibility, ALayerDoesNotHideItselfAtAnyTilt) {
    const marks::PointSet set = plane(runtime.memory, 100);
    const std::array items{item_of(set, hiding_style())};
    for (const double tilt : {0.0, 0.3, 0.6, 0.9, 1.2, 1.35}) {
        frame::Camera camera = front_camera(400, 400);
        camera.view = frame::look_at({0.0, -10.0 * std::sin(tilt), 10.0 * std::cos(tilt)}, glm::dvec3(0.0), {1, 0, 0});
        const Counts& info = draw(items, camera);
        EXPECT_EQ(info.shown, 10000) << tilt;
        EXPECT_EQ(info.dropped_hidden, 0);
        EXPECT_EQ(info.splats, 0);
    }
}

TEST_F(Visibility, ASphereKeepsItsFrontAndItsContour) {
    for (const int count : {2000, 10000, 50000}) {
        const marks::PointSet set = sphere(runtime.memory, count);
        const std::array items{item_of(set, hiding_style())};
        const Counts& info = draw(items, front_camera(600, 600));
        std::int64_t front = 0;
        std::int64_t near_silhouette = 0;
        for (const Disc& disc : frame.discs()) {
            if (disc.mark_class == MarkClass::front)
                ++front;
            else if (frame.source(disc).normal.z > 0.0F)
                ++near_silhouette;
        }
        EXPECT_EQ(front, info.front);
        // The picture shows the nearer half of the contour's band.
        EXPECT_GT(static_cast<double>(near_silhouette), 0.49 * static_cast<double>(info.silhouette)) << count;
    }
}

TEST_F(Visibility, ASphereHidesAnotherBehindIt) {
    const marks::PointSet set = sphere(runtime.memory, 20000);
    const marks::PointSet small = sphere(runtime.memory, 3000, 0.5);
    std::array items{item_of(set, hiding_style()), item_of(small, hiding_style(), moved({0.2, 0.0, -2.0}))};
    draw(items, front_camera(500, 500));
    for (const Disc& disc : frame.discs()) EXPECT_LE(disc.id, 20000U);
    EXPECT_GE(frame.info().dropped_hidden, 3000 * 0.6 - 3);
    // In front of the larger sphere all of the near side is shown. With SHOW the hidden marks are shown, too.
    items[1].transform = moved({0.2, 0.0, 2.0});
    std::int64_t small_front = 0;
    draw(items, front_camera(500, 500));
    for (const Disc& disc : frame.discs()) small_front += disc.id > 20000 && disc.mark_class == MarkClass::front;
    EXPECT_NEAR(static_cast<double>(small_front), 3000 * 0.4, 3.0);
    items[1].transform = moved({0.2, 0.0, -2.0});
    for (frame::Item& item : items) item.style.hidden_lines = HiddenLines::show;
    EXPECT_EQ(draw(items, front_camera(500, 500)).dropped_hidden, 0);
    EXPECT_NEAR(static_cast<double>(frame.info().shown), 23000 * 0.6, 6.0);
}

TEST_F(Visibility, TheBackOfAnOpenLayerHidesToo) {
    const marks::PointSet set = plane(runtime.memory, 60);
    glm::dmat4 turned(1.0); // turns its back to the camera
    turned[0][0] = -1.0;
    turned[2][2] = -1.0;
    const std::array items{item_of(set, hiding_style(), turned), item_of(set, hiding_style(), moved({0.0, 0.0, -1.0}))};
    const Counts& info = draw(items, front_camera(200, 200));
    EXPECT_EQ(info.back, 3600);
    EXPECT_EQ(info.shown, 0);
    EXPECT_EQ(info.dropped_hidden, 3600);
}

TEST_F(Visibility, TheContoursOfATorusAreHiddenWhereItsTubeIsInFront) {
    const marks::PointSet set = torus(runtime.memory, 160);
    Style style = hiding_style();
    style.kind[0].shown = false;
    const std::array items{item_of(set, style)};
    frame::Camera camera = front_camera(500, 500, 1.6);
    camera.view = frame::look_at({0.0, -9.0, 4.0}, glm::dvec3(0.0), {0, 0, 1});
    draw(items, camera);
    // Sphere tracing tells which contour marks the tube really hides.
    std::int64_t wrong = 0;
    std::int64_t hidden = 0;
    const glm::dvec3 toward = glm::normalize(glm::dvec3(0.0, -9.0, 4.0));
    std::vector<bool> drawn(static_cast<std::size_t>(set.layers[0].count()) + 1);
    for (const Disc& disc : frame.discs()) drawn[disc.id] = true;
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
        const glm::dvec3 p(set.layers[0].position[3 * i], set.layers[0].position[3 * i + 1],
                           set.layers[0].position[3 * i + 2]);
        const glm::dvec3 n(set.layers[0].normal[3 * i], set.layers[0].normal[3 * i + 1],
                           set.layers[0].normal[3 * i + 2]);
        if (std::abs(glm::dot(n, toward)) > 0.2) continue;
        double least = 1.0; // clearance of the line of sight, away from the mark itself
        for (double t = 0.35; t < 4.0; t += 0.01) {
            const glm::dvec3 q = p + t * toward;
            least = std::min(least, std::hypot(std::hypot(q.x, q.y) - 1.0, q.z) - 0.45);
        }
        const bool is_hidden = least < -0.05;
        const bool is_seen = least > 0.05 && glm::dot(n, toward) > 0.03;
        hidden += is_hidden;
        wrong += (is_hidden && drawn[static_cast<std::size_t>(i) + 1]) ||
                 (is_seen && !drawn[static_cast<std::size_t>(i) + 1]);
    }
    EXPECT_GT(hidden, 500);
    EXPECT_EQ(wrong, 0);
}

TEST_F(Visibility, AHugeViewportGetsACoarserMap) {
    const marks::PointSet set = sphere(runtime.memory, 500);
    const std::array items{item_of(set, hiding_style()), item_of(set, hiding_style(), moved({0.0, 0.0, -3.0}))};
    frame::Camera camera = front_camera(9000, 9000);
    camera.viewport = {-100.0, 50.0, 9000.0, 9000.0};
    const Counts& info = draw(items, camera);
    EXPECT_EQ(info.dropped_hidden + info.shown, info.front + info.silhouette);
    EXPECT_GE(info.dropped_hidden, 200);
    EXPECT_LT(info.scratch_bytes, std::int64_t{100} << 20);
}

TEST_F(Visibility, PaperFollowsTheLawsOfAttenuation) {
    const marks::PointSet set = sphere(runtime.memory, 5000);
    Style style;
    style.splat_radius = 6.0F;
    style.attenuation_front = 0.7;
    style.attenuation_back = 0.4;
    for (const float layers : {0.0F, 5.0F}) {
        style.splat_overlap = layers;
        const std::array items{item_of(set, style)};
        const Counts& info = draw(items, front_camera(500, 500));
        EXPECT_EQ(info.splats, info.front + info.back);
        std::int64_t paper = 0;
        for (const Disc& disc : frame.discs()) {
            if (!disc.is_paper) continue;
            ++paper;
            const float nu = -frame.source(disc).normal.z;
            const bool back = disc.mark_class == MarkClass::back;
            ASSERT_EQ(disc.radius, back ? 8.0F : 6.0F);
            const float alpha = back ? frame::back_alpha(nu, 0.4F) : frame::front_alpha(nu, 0.7F);
            const float spacing = static_cast<float>(set.spacing) * 200.0F;
            const float expected =
                frame::disc_opacity(alpha, layers, frame::expected_overlap(disc.radius, spacing, nu));
            ASSERT_NEAR(disc.color.w, expected, 1e-4F);
            ASSERT_EQ(glm::vec3(disc.color), glm::vec3(1.0F));
        }
        EXPECT_EQ(paper, info.splats);
    }
    style.attenuation_front = 0.0;
    style.attenuation_back = 0.0;
    const std::array items{item_of(set, style)};
    EXPECT_EQ(draw(items, front_camera(500, 500)).splats, 0);
}

TEST_F(Visibility, OneLayerPaintsPaperExceptAsPublished) {
    marks::PointSet set = sphere(runtime.memory, 1000);
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 n = spiral_direction(i, 3000);
        add_mark(layer_of(set, marks::Kind::hatch), n, n, geometry::any_perpendicular(n), 0, 0);
    }
    marks::index_strokes(set.layers[1]);
    set.spacing = std::sqrt(4.0 * pi / 3000.0); // spacing of the largest layer
    Style style;
    const auto paper_discs = [&] {
        const std::array items{item_of(set, style)};
        return draw(items, front_camera(500, 500)).splats;
    };
    // There are at least a quarter as many stipples as marks of strokes, so the stipples paint.
    EXPECT_NEAR(static_cast<double>(paper_discs()), 800.0, 4.0);
    float radius = 0.0F;
    for (const Disc& disc : frame.discs()) {
        if (disc.is_paper && disc.mark_class == MarkClass::front) radius = disc.radius;
    }
    EXPECT_NEAR(static_cast<double>(radius), 1.5 * std::sqrt(4.0 * pi / 1000.0) * 200.0, 0.01);
    style.splat_overlap = 0.0F;
    EXPECT_NEAR(static_cast<double>(paper_discs()), 3200.0, 8.0);
    style.splat_overlap = 8.0F;
    style.contour_kinds = 2;
    style.kind[0].shown = false;
    EXPECT_NEAR(static_cast<double>(paper_discs()), 2400.0, 6.0);
}

} // namespace
} // namespace hrbfnpr::testing::visibility_test
