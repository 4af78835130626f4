// SPDX-License-Identifier: MIT
// Tests which marks become ink: tone, depth, zoom, share, sets and callbacks.
#include "frame/hand_made.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace hrbfnpr::testing::shade_test {
namespace {

using drawing::Counts;
using frame::Tone;
using frame::ToneRule;
using ::testing::HasSubstr;

constexpr int side = 150;

// A plane that faces the camera, so all of its marks have one tone.
class Shade : public ::testing::Test {
protected:
    const Counts& draw(const Style& style) { return draw(style, front_camera(300, 300)); }
    const Counts& draw(const Style& style, const frame::Camera& camera) {
        const std::array items{item_of(set, style)};
        frame.draw(items, camera);
        const Counts& info = frame.info();
        EXPECT_EQ(info.marks, info.outside + info.front + info.back + info.silhouette);
        EXPECT_EQ(info.front + info.silhouette,
                  info.shown + info.dropped_tone + info.dropped_zoom + info.dropped_depth + info.dropped_hidden);
        return info;
    }
    [[nodiscard]] double shown_share() const {
        return static_cast<double>(frame.info().shown) / static_cast<double>(frame.info().marks);
    }
    // Three standard deviations of a share of the marks.
    static double doubt(double share) { return 3.0 * std::sqrt(share * (1.0 - share)) / side; }

    base::Runtime runtime;
    marks::PointSet set = plane(runtime.memory, side);
    DrawnFrame frame{runtime};
};

TEST_F(Shade, TheShareShownIsOneMinusTheTone) {
    for (const ToneRule rule : {ToneRule::share, ToneRule::published}) {
        for (const double cosine : {0.0, 0.2, 0.5, 0.9, 1.0}) {
            for (const double exponent : {0.5, 1.0, 2.0}) {
                Style style = plain_style();
                style.tone = Tone::light;
                style.tone_rule = rule;
                style.tone_exponent = exponent;
                style.light = {3.0 * std::sqrt(1.0 - cosine * cosine), 0.0, 3.0 * cosine};
                const double expected = 1.0 - std::pow(cosine, exponent);
                const Counts& info = draw(style);
                EXPECT_NEAR(shown_share(), expected, doubt(expected) + 1e-9);
                EXPECT_EQ(info.dropped_tone, info.front - info.shown);
            }
        }
    }
}

TEST_F(Shade, LightIsInCameraOrWorldSpace) {
    Style style = plain_style();
    style.tone = Tone::light;
    style.light = {0.0, 0.6, 0.8};
    frame::Camera camera = front_camera(300, 300);
    // The camera looks from the side and is rolled by a quarter turn; the plane's normal is then (0.6, 0, 0.8) for the
    // eye.
    camera.view = frame::look_at({0.0, -6.0, 8.0}, glm::dvec3(0.0), {1.0, 0.0, 0.0});
    style.light_space = frame::LightSpace::world;
    draw(style, camera);
    EXPECT_NEAR(shown_share(), 1.0 - 0.8, doubt(0.2));
    style.light_space = frame::LightSpace::camera;
    draw(style, camera);
    EXPECT_NEAR(shown_share(), 1.0 - 0.64, doubt(0.36));
}

TEST_F(Shade, ShareThinsFrontMarksOnly) {
    Style style = plain_style();
    style.kind[0].share = 0.3F;
    const Counts& info = draw(style);
    EXPECT_NEAR(shown_share(), 0.3, doubt(0.3));
    EXPECT_EQ(info.dropped_tone, info.front - info.shown);
    // A plane that is seen edge-on is all silhouette, and all of it is drawn.
    frame::Camera camera = front_camera(300, 300);
    camera.view = frame::look_at({0.0, -10.0, 0.0}, glm::dvec3(0.0), {0.0, 0.0, 1.0});
    draw(style, camera);
    EXPECT_EQ(frame.info().silhouette, side * side);
    EXPECT_EQ(frame.info().shown, side * side);
}

TEST_F(Shade, DepthAttenuationThinsFrontAndSilhouetteMarks) {
    frame::Camera edge_on = front_camera(300, 300);
    edge_on.view = frame::look_at({0.0, -10.0, 0.0}, glm::dvec3(0.0), {0.0, 0.0, 1.0});
    for (const ToneRule rule : {ToneRule::share, ToneRule::published}) {
        Style style = plain_style();
        style.tone_rule = rule;
        style.depth_min = 5.0;
        style.depth_max = 20.0; // at 10, their geometric mean, half of the marks remain
        const Counts& info = draw(style);
        EXPECT_NEAR(shown_share(), 0.5, doubt(0.5));
        EXPECT_EQ(info.dropped_depth, info.front - info.shown);
        style.depth_min = 9.0;
        style.depth_max = 11.0;
        draw(style, edge_on);
        EXPECT_NEAR(shown_share(), 0.5, 0.1);
        EXPECT_EQ(frame.info().dropped_depth, frame.info().silhouette - frame.info().shown);
        style.depth_min = 1.0;
        style.depth_max = 9.9;
        EXPECT_EQ(draw(style).shown, 0);
    }
}

TEST_F(Shade, DepthIsTheDistanceFromTheEye) {
    // A mark to the side is farther from the eye than one straight ahead in the same plane.
    marks::PointSet two(runtime.memory);
    add_stipple(two, {0.0, 0.0, 0.0}, {0, 0, 1});
    add_stipple(two, {5.0, 0.0, 0.0}, {0, 0, 1}); // 11.18 from the eye
    frame::Camera camera = front_camera(100, 100);
    camera.projection = frame::perspective(1.2, 100, 100, 1.0, 100.0, camera.depth);
    Style style = plain_style();
    style.depth_min = 10.5;
    style.depth_max = 11.0;
    const std::array items{item_of(two, style)};
    frame.draw(items, camera);
    ASSERT_EQ(frame.info().shown, 1);
    EXPECT_EQ(frame.discs()[0].id, 1U);
    EXPECT_EQ(frame.info().dropped_depth, 1);
}

TEST_F(Shade, ZoomThinsFrontMarksAndScalesRadii) {
    for (const ToneRule rule : {ToneRule::share, ToneRule::published}) {
        Style style = plain_style();
        style.tone_rule = rule;
        style.zoom_reference = 240.0; // the camera shows 2.5 units on 300 pixels: 120
        style.zoom_exponent = 2.0;
        style.kind[0].radius = 3.0F;
        style.kind[0].radius_zoom = 1.0F;
        const Counts& info = draw(style);
        EXPECT_NEAR(shown_share(), 0.25, doubt(0.25));
        EXPECT_EQ(info.dropped_zoom, info.front - info.shown);
        for (const Disc& disc : frame.discs()) ASSERT_NEAR(disc.radius, 1.5F, 1e-5F);
        style.zoom_reference = 60.0;
        EXPECT_EQ(draw(style).shown, side * side);
        for (const Disc& disc : frame.discs()) ASSERT_NEAR(disc.radius, 6.0F, 1e-5F);
    }
}

TEST_F(Shade, ZoomIsPixelsPerWorldUnitAtTheMark) {
    frame::Camera camera = front_camera(300, 200);
    const double angle = 0.7;
    camera.projection = frame::perspective(angle, 300, 200, 1.0, 100.0, camera.depth);
    Style style = plain_style();
    style.zoom_reference = 1.0;
    style.kind[0].radius_zoom = 1.0F;
    style.kind[0].radius = 0.5F;
    marks::PointSet one(runtime.memory);
    add_stipple(one, glm::dvec3(0.0, 0.0, 6.0), {0, 0, 1}); // 4 from the eye
    glm::dmat4 doubled(2.0);
    doubled[3] = {0.0, 0.0, -6.0, 1.0}; // the item's own scale does not matter
    for (const glm::dmat4& transform : {glm::dmat4(1.0), doubled}) {
        const std::array items{item_of(one, style, transform)};
        frame.draw(items, camera);
        EXPECT_NEAR(static_cast<double>(frame.discs()[0].radius), 0.5 * 100.0 / (4.0 * std::tan(angle / 2.0)), 1e-4);
    }
}

TEST_F(Shade, SetsChooseTheStrokesOfOneDirection) {
    marks::PointSet strokes(runtime.memory);
    for (std::uint32_t i = 0; i < 30; ++i)
        add_mark(layer_of(strokes, marks::Kind::hatch), {0.01 * i, 0, 0}, {0, 0, 1}, {1, 0, 0}, i / 3, i % 3);
    marks::index_strokes(strokes.layers[0]);
    for (const std::uint32_t sets : {0U, 1U, 2U, 3U}) {
        Style style = plain_style();
        style.kind[1].sets = sets;
        const std::array items{item_of(strokes, style)};
        frame.draw(items, front_camera(100, 100));
        EXPECT_EQ(frame.info().shown, sets == 3 ? 30 : sets == 0 ? 0 : 15);
        for (const Disc& disc : frame.discs()) EXPECT_NE(sets >> ((disc.id - 1) / 3 % 2) & 1U, 0U);
    }
}

TEST_F(Shade, LayersHaveTheirOwnInk) {
    marks::PointSet layers(runtime.memory);
    add_stipple(layers, {0, 0, 0}, {0, 0, 1});
    add_stroke(layers, marks::Kind::hatch, {{0, 0, 0.1}}, {0, 0, 1});
    add_stroke(layers, marks::Kind::own, {{0, 0, 0.2}}, {0, 0, 1});
    add_stipple(layers, {0, 0, 0.5}, {1, 0, 0}); // silhouette
    Style style = plain_style();
    for (std::size_t g = 0; g < 3; ++g) {
        style.kind[g].ink = {0.1F * static_cast<float>(g + 1), 0.0F, 1.0F, 0.5F};
        style.kind[g].radius = static_cast<float>(g + 1);
    }
    style.silhouette_ink = {0.0F, 1.0F, 0.0F, 1.0F};
    style.silhouette_radius = 7.0F;
    style.contour_kinds = 1;
    const std::array items{item_of(layers, style)};
    frame.draw(items, front_camera(100, 100));
    ASSERT_EQ(frame.discs().size(), 4U);
    for (std::size_t g = 0; g < 3; ++g) {
        EXPECT_EQ(frame.discs()[g].color, style.kind[g].ink);
        EXPECT_EQ(frame.discs()[g].radius, static_cast<float>(g + 1));
    }
    EXPECT_EQ(frame.discs()[3].color, style.silhouette_ink);
    EXPECT_EQ(frame.discs()[3].radius, 7.0F);
    EXPECT_EQ(frame.discs()[3].mark_class, drawing::MarkClass::silhouette);
}

TEST_F(Shade, WidthTapersTheInkOfFrontMarksOnly) {
    marks::PointSet stroke(runtime.memory);
    for (int i = 0; i < 4; ++i)
        add_mark(layer_of(stroke, marks::Kind::hatch), {0.1 * i, 0, 0},
                 i < 3 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0), {0, 1, 0}, 0, 0);
    marks::index_strokes(stroke.layers[0]);
    for (const float width : {0.25F, 0.5F, 1.0F, 0.25F}) stroke.layers[0].width.push_back(width);
    Style style = plain_style();
    style.kind[1].radius = 8.0F;
    style.silhouette_radius = 6.0F;
    style.contour_kinds = 2;
    const std::array items{item_of(stroke, style)};
    frame.draw(items, front_camera(100, 100));
    ASSERT_EQ(frame.discs().size(), 4U);
    std::vector<float> radii;
    for (const Disc& disc : frame.discs()) radii.push_back(disc.radius);
    EXPECT_THAT(radii, ::testing::UnorderedElementsAre(2.0F, 4.0F, 8.0F, 6.0F));
}

TEST_F(Shade, SilhouettesComeFromTheirLayersAndHiddenLayersStayOut) {
    marks::PointSet ball = sphere(runtime.memory, 4000);
    Style style = plain_style();
    style.kind[0].shown = false;
    std::array items{item_of(ball, style)};
    frame.draw(items, front_camera(100, 100));
    EXPECT_EQ(frame.info().shown, frame.info().silhouette);
    style.contour_kinds = 6;
    items[0] = item_of(ball, style);
    frame.draw(items, front_camera(100, 100));
    EXPECT_EQ(frame.info().marks, 0);
}

struct Checker {
    std::int64_t calls = 0, marks = 0, most = 0;
    float tau = 0.0F;
    std::int32_t result = 0;
};

std::int32_t tone_function(void* user, std::int64_t count, const float* positions, const float* normals, float* tau) {
    auto& checker = *static_cast<Checker*>(user);
    ++checker.calls;
    checker.marks += count;
    checker.most = std::max(checker.most, count);
    for (std::int64_t i = 0; i < count; ++i) {
        // The world's left half is light; all normals are +z.
        tau[i] = positions[3 * i] < 0.0F ? 1.5F : checker.tau;
        EXPECT_EQ(normals[3 * i + 2], 1.0F);
    }
    return checker.result;
}

TEST_F(Shade, ACallbackGivesTheTone) {
    Checker checker;
    Style style = plain_style();
    style.tone = Tone::callback;
    style.tone_function = tone_function;
    style.tone_user = &checker;
    const Counts& info = draw(style);
    EXPECT_EQ(checker.marks, side * side);
    EXPECT_LE(checker.most, 4096);
    EXPECT_EQ(info.shown, side * side / 2);
    EXPECT_EQ(info.dropped_tone, side * side / 2);
    for (const Disc& disc : frame.discs()) ASSERT_GT(disc.x, 150.0F);
    checker.tau = -3.0F; // clamped to 0
    EXPECT_EQ(draw(style).shown, side * side / 2);
}

TEST_F(Shade, EachItemHasItsOwnCallback) {
    Checker first;
    Checker second;
    second.tau = 1.0F;
    Style style = plain_style();
    style.tone = Tone::callback;
    style.tone_function = tone_function;
    style.tone_user = &first;
    std::array items{item_of(set, style), item_of(set, style), item_of(set, plain_style())};
    items[1].style.tone_user = &second;
    frame.draw(items, front_camera(100, 100));
    EXPECT_EQ(first.marks, side * side);
    EXPECT_EQ(second.marks, side * side);
    EXPECT_EQ(frame.info().shown, side * side / 2 + side * side);
}

TEST_F(Shade, ACallbackThatFailsOrGivesNaNFailsTheFrame) {
    Checker checker;
    Style style = plain_style();
    style.tone = Tone::callback;
    style.tone_function = tone_function;
    style.tone_user = &checker;
    const std::array items{item_of(set, style)};
    const auto expect_failure = [&](const char* text) {
        try {
            frame.draw(items, front_camera(100, 100));
            ADD_FAILURE() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::callback);
            EXPECT_THAT(error.what(), HasSubstr(text));
        }
        EXPECT_FALSE(frame.drawn());
    };
    checker.result = 42;
    expect_failure("tone_function returned 42");
    checker.result = 0;
    checker.tau = std::numeric_limits<float>::quiet_NaN();
    expect_failure("NaN");
    checker.tau = 0.0F; // the renderer works again
    EXPECT_EQ(draw(style).shown, side * side / 2);
}

} // namespace
} // namespace hrbfnpr::testing::shade_test
