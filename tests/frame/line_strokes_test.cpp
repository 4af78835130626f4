// SPDX-License-Identifier: MIT
// Tests lines of items as strokes: of spheres, whose outlines are circles, and of tori, which hide themselves.
#include "frame/hand_made.h"
#include "support/analytic.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace hrbfnpr::testing::line_strokes_test {
namespace {

using drawing::Cap;
using drawing::Stroke;
using drawing::StrokePoint;
using frame::HiddenParts;
using frame::LineStyle;

constexpr int size = 500; // 200 pixels per unit

// Marks define the surface, but none is drawn.
const std::array<frame::LayerStyle, 1> blank{[] {
    frame::LayerStyle style;
    style.share = 0.0F;
    return style;
}()};

curves::LineSetSettings cells(double side) {
    curves::LineSetSettings settings;
    settings.side = side;
    return settings;
}

glm::dmat4 moved(const glm::dvec3& to, double scale) {
    glm::dmat4 m(scale);
    m[3] = glm::dvec4(to, 1.0);
    return m;
}

class LineStrokes : public ::testing::Test {
protected:
    [[nodiscard]] frame::Item item_of(const curves::LineSet* lines, const glm::dmat4& transform = glm::dmat4(1.0)) {
        frame::Item item = layered_item(set, frame::Style(), transform);
        item.style.hidden_lines = frame::HiddenLines::show;
        item.style.tone = frame::Tone::none;
        item.style.layers = blank;
        item.style.lines = style;
        item.style.halo_width = halo;
        item.lines = lines;
        return item;
    }
    const drawing::Drawing& draw(std::span<const frame::Item> items) { return draw(items, front_camera(size, size)); }
    const drawing::Drawing& draw(std::span<const frame::Item> items, const frame::Camera& camera) {
        frame.draw(items, camera);
        expect_sound();
        return frame.drawing();
    }
    [[nodiscard]] std::span<const StrokePoint> points_of(const Stroke& stroke) const {
        return frame.drawing().points.span().subspan(static_cast<std::size_t>(stroke.first),
                                                     static_cast<std::size_t>(stroke.count));
    }
    // The length along the points.
    [[nodiscard]] double length_of(const Stroke& stroke) const {
        double sum = 0.0;
        const auto points = points_of(stroke);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            sum += std::hypot(static_cast<double>(points[i + 1].x - points[i].x),
                              static_cast<double>(points[i + 1].y - points[i].y));
        return sum;
    }
    // The strokes of an item.
    [[nodiscard]] std::vector<Stroke> strokes_of(std::int32_t item) const {
        std::vector<Stroke> found;
        for (const Stroke& stroke : frame.drawing().strokes)
            if (frame.drawing().layers[stroke.layer].item == item) found.push_back(stroke);
        return found;
    }

    base::Runtime runtime = test::with_threads(2);
    test::SquareSphere ball;
    test::Torus ring{1.0, 0.4};
    curves::LineSet ball_lines{runtime, ball, std::make_unique<implicit::DifferencedShape>(ball), cells(0.1)};
    curves::LineSet ring_lines{runtime, ring, std::make_unique<implicit::DifferencedShape>(ring), cells(0.1)};
    marks::PointSet set = clustered(runtime, sphere(runtime.memory, 2000));
    std::array<LineStyle, 1> style{};
    DrawnFrame frame{runtime};
    float halo = 0.0F;       // pixels
    double stretched = 1e-3; // largest error of lengths, as a share

private:
    void expect_sound() {
        const drawing::Drawing& drawing = frame.drawing();
        for (const Stroke& stroke : drawing.strokes) {
            EXPECT_GE(stroke.count, 2);
            const drawing::Layer& layer = drawing.layers[stroke.layer];
            EXPECT_EQ(layer.layer, -1);
            EXPECT_TRUE(layer.as_strokes);
            EXPECT_EQ(layer.line_kind, 1U);
            float before = 0.0F;
            for (const StrokePoint& p : points_of(stroke)) {
                EXPECT_TRUE(std::isfinite(p.x + p.y + p.radius + p.opacity + p.depth + p.window + p.pixels_per_unit));
                EXPECT_GE(p.length, before);
                EXPECT_EQ(p.id, 0U);
                before = p.length;
            }
            EXPECT_NEAR(static_cast<double>(before), length_of(stroke), 0.1 + stretched * length_of(stroke));
            const StrokePoint& a = points_of(stroke).front();
            const StrokePoint& b = points_of(stroke).back();
            if (stroke.closed) {
                EXPECT_NEAR(a.x, b.x, 1e-3F);
                EXPECT_NEAR(a.y, b.y, 1e-3F);
            }
        }
    }
};

TEST_F(LineStrokes, TheOutlineOfASphereIsOneClosedStroke) {
    style[0].width = 3.0F;
    const std::array items{item_of(&ball_lines)};
    const drawing::Drawing& drawing = draw(items);
    ASSERT_EQ(drawing.strokes.size(), 1);
    const Stroke& stroke = drawing.strokes[0];
    EXPECT_TRUE(stroke.closed);
    EXPECT_NEAR(length_of(stroke), 2.0 * pi * 200.0, 0.001 * 2.0 * pi * 200.0);
    for (const StrokePoint& p : points_of(stroke)) {
        EXPECT_NEAR(std::hypot(p.x - 250.0F, p.y - 250.0F), 200.0F, 0.02F);
        EXPECT_EQ(p.radius, 1.5F);
        EXPECT_EQ(p.opacity, 1.0F);
        EXPECT_NEAR(p.depth, 10.0F, 1e-3F);
        EXPECT_NEAR(p.pixels_per_unit, 200.0F, 1e-2F);
    }
    EXPECT_EQ(drawing.line_counts.curves, 1);
    EXPECT_EQ(drawing.line_counts.cusps + drawing.line_counts.crossings + drawing.line_counts.broken, 0);
}

// In perspective the contour is where the cone of sight touches the sphere.
TEST_F(LineStrokes, AContourInPerspectiveHasTheRightLength) {
    for (const glm::dvec3& from : {glm::dvec3(3.0, 0.0, 0.0), {1.0, -2.0, 2.0}, {-2.0, 1.5, 1.66}}) {
        frame::Camera camera;
        camera.view = frame::look_at(from, glm::dvec3(0.0), {0.1, 0.2, 1.0});
        camera.projection = frame::perspective(0.9, size, size, 0.1, 20.0, camera.depth);
        camera.viewport = {0.0, 0.0, size, size};
        const std::array items{item_of(&ball_lines)};
        const drawing::Drawing& drawing = draw(items, camera);
        ASSERT_EQ(drawing.strokes.size(), 1);
        const double radius = std::tan(std::asin(1.0 / glm::length(from))) * 0.5 * size / std::tan(0.45);
        EXPECT_NEAR(length_of(drawing.strokes[0]), 2.0 * pi * radius, 0.001 * 2.0 * pi * radius);
    }
}

// Marks draw no contours, with and without lines.
TEST_F(LineStrokes, OnlyLineStrokesDrawContours) {
    frame::Item item = item_of(nullptr);
    draw(std::array{item});
    EXPECT_GT(frame.drawing().counts.front, 100);
    EXPECT_EQ(frame.drawing().counts.silhouette, 0);
    EXPECT_EQ(frame.discs().size(), 0U);
    EXPECT_EQ(frame.drawing().strokes.size(), 0);
    for (const drawing::Layer& layer : frame.drawing().layers) EXPECT_GE(layer.layer, 0);
    item.lines = &ball_lines;
    draw(std::array{item});
    EXPECT_EQ(frame.discs().size(), 0U);
    EXPECT_EQ(frame.drawing().strokes.size(), 1);
    item.style.lines = {}; // without a style for lines none is drawn
    draw(std::array{item});
    EXPECT_EQ(frame.discs().size(), 0U);
    EXPECT_EQ(frame.drawing().strokes.size(), 0);
}

// A drawing that is filled again keeps nothing of the one before.
TEST_F(LineStrokes, CountsDescribeTheLastDrawing) {
    frame::Item item = item_of(&ring_lines);
    draw(std::array{item});
    EXPECT_EQ(frame.drawing().line_counts.curves, 2);
    item.lines = nullptr;
    draw(std::array{item});
    EXPECT_EQ(frame.drawing().line_counts.curves, 0);
    EXPECT_EQ(frame.drawing().line_counts.nanoseconds, 0);
}

TEST_F(LineStrokes, DoNotChangeItemsWithoutLines) {
    frame::Item plain = item_of(nullptr, moved({0.5, 0.0, 0.0}, 0.6));
    draw(std::array{plain});
    std::vector<Disc> before(frame.discs().begin(), frame.discs().end());
    const std::array items{plain, item_of(&ball_lines, moved({-0.4, 0.2, 0.0}, 0.5))};
    draw(items);
    std::vector<Disc> after(frame.discs().begin(), frame.discs().end());
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(before[i].x, after[i].x);
        EXPECT_EQ(before[i].y, after[i].y);
        EXPECT_EQ(before[i].color.w, after[i].color.w);
    }
    EXPECT_EQ(strokes_of(0).size(), 0U);
    EXPECT_EQ(strokes_of(1).size(), 1U);
}

// Two circles of 100 and 80 pixels; the smaller one is behind and half hidden.
class HiddenPart : public LineStrokes {
protected:
    // Tells whether a place is in the nearer circle.
    [[nodiscard]] static bool covered(const StrokePoint& p, double slack = 0.0) {
        return std::hypot(static_cast<double>(p.x) - 250.0, static_cast<double>(p.y) - 250.0) < 100.0 + slack;
    }
    [[nodiscard]] std::vector<Stroke> far_strokes(HiddenParts hidden) {
        style[0].hidden = hidden;
        const std::array items{item_of(&ball_lines, moved({0.0, 0.0, 3.0}, 0.5)),
                               item_of(&ball_lines, moved({0.5, 0.0, 0.0}, 0.4))};
        draw(items);
        EXPECT_EQ(strokes_of(0).size(), 1U);
        return strokes_of(1);
    }
    // The length of the arc inside of the other circle, in pixels; the centres are 100 apart.
    const double arc = 2.0 * 80.0 * std::acos((100.0 * 100.0 + 80.0 * 80.0 - 100.0 * 100.0) / (2.0 * 100.0 * 80.0));
    const double whole = 2.0 * pi * 80.0;
};

TEST_F(HiddenPart, CanBeOmitted) {
    const std::vector<Stroke> strokes = far_strokes(HiddenParts::none);
    ASSERT_EQ(strokes.size(), 1U);
    EXPECT_FALSE(strokes[0].closed);
    EXPECT_NEAR(length_of(strokes[0]), whole - arc, 0.2);
    for (const StrokePoint& p : points_of(strokes[0])) {
        EXPECT_FALSE(covered(p, -0.1));
        EXPECT_EQ(p.radius, 0.5F * style[0].width); // a hidden part does not make a free end
    }
}

// On both sides the gap is the halo plus half of either line's width, as the lines cross at more than 30 degrees.
TEST_F(HiddenPart, HasHaloGapsAtItsEnds) {
    halo = 3.0F;
    const std::vector<Stroke> strokes = far_strokes(HiddenParts::none);
    ASSERT_EQ(strokes.size(), 1U);
    EXPECT_NEAR(length_of(strokes[0]), whole - arc - 2.0 * static_cast<double>(halo + style[0].width), 0.2);
}

TEST_F(HiddenPart, CanBeAttenuated) {
    style[0].hidden_opacity = 0.3F;
    style[0].hidden_width = 1.0F;
    const std::vector<Stroke> strokes = far_strokes(HiddenParts::attenuated);
    ASSERT_EQ(strokes.size(), 2U);
    for (const Stroke& stroke : strokes) {
        const bool hidden = points_of(stroke)[static_cast<std::size_t>(stroke.count / 2)].opacity < 1.0F;
        EXPECT_NEAR(length_of(stroke), hidden ? arc : whole - arc, 0.2);
        for (const StrokePoint& p : points_of(stroke)) {
            EXPECT_EQ(p.opacity, hidden ? 0.3F : 1.0F);
            EXPECT_EQ(p.radius, hidden ? 0.5F : 0.5F * style[0].width);
            EXPECT_TRUE(hidden ? covered(p, 0.1) : !covered(p, -0.1));
        }
    }
}

TEST_F(HiddenPart, CanBeShownLikeVisibleParts) {
    const std::vector<Stroke> strokes = far_strokes(HiddenParts::shown);
    double sum = 0.0;
    for (const Stroke& stroke : strokes) {
        sum += length_of(stroke);
        for (const StrokePoint& p : points_of(stroke)) {
            EXPECT_EQ(p.opacity, 1.0F);
            EXPECT_EQ(p.radius, 0.5F * style[0].width);
        }
    }
    EXPECT_NEAR(sum, whole, 0.2);
}

TEST_F(HiddenPart, CanBeDashed) {
    style[0].hidden_width = 2.0F;
    style[0].dash = 4.0F;
    style[0].gap = 3.0F; // 8 pixels, 6 pixels
    const std::vector<Stroke> strokes = far_strokes(HiddenParts::dashed);
    const auto dashes = static_cast<std::int64_t>(std::round(arc / 14.0));
    ASSERT_EQ(static_cast<std::int64_t>(strokes.size()), dashes + 1);
    for (const Stroke& stroke : strokes) {
        const bool dash = length_of(stroke) < 20.0;
        EXPECT_NEAR(length_of(stroke), dash ? 8.0 / 14.0 * arc / static_cast<double>(dashes) : whole - arc, 0.2);
        for (const StrokePoint& p : points_of(stroke)) {
            EXPECT_TRUE(dash ? covered(p, 0.1) : !covered(p, -0.1));
            EXPECT_EQ(p.radius, 0.5F * (dash ? 2.0F : style[0].width));
        }
    }
}

// A part behind n layers has the opacity to the power of n.
TEST_F(LineStrokes, OpacitiesOfHiddenLayersMultiply) {
    style[0].hidden = HiddenParts::attenuated;
    style[0].hidden_opacity = 0.5F;
    const std::array items{item_of(&ball_lines, moved({0.0, 0.0, 4.0}, 0.5)),
                           item_of(&ball_lines, moved({0.0, 0.0, 2.0}, 0.4)),
                           item_of(&ball_lines, moved({0.0, 0.0, 0.0}, 0.3))};
    draw(items);
    for (const std::int32_t i : {0, 1, 2}) {
        const std::vector<Stroke> strokes = strokes_of(i);
        ASSERT_EQ(strokes.size(), 1U);
        EXPECT_TRUE(strokes[0].closed);
        for (const StrokePoint& p : points_of(strokes[0])) EXPECT_EQ(p.opacity, std::pow(0.5F, static_cast<float>(i)));
    }
}

// A circle of radius 0.5 is behind a larger one of radius 0.6, which leaves an arc. The arc would be a dot if it is
// shorter than half the line's width, so it is not drawn.
TEST_F(LineStrokes, TooShortVisiblePartsAreNotDrawn) {
    style[0].width = 8.0F;
    style[0].hidden = HiddenParts::none;
    const auto strokes = [&](double pixels) {
        const double cosine = std::cos(0.5 * pixels / (0.5 * 200.0));
        double d = 0.1; // distance of the middles: 0.6^2 = 0.5^2 + d^2 + d cosine
        for (int i = 0; i < 20; ++i) d -= (0.25 + d * d + d * cosine - 0.36) / (2.0 * d + cosine);
        const std::array items{item_of(&ball_lines, moved({d, 0.0, -2.0}, 0.5)), item_of(&ball_lines, moved({}, 0.6))};
        draw(items);
        return strokes_of(0);
    };
    EXPECT_TRUE(strokes(3.0).empty());
    ASSERT_EQ(strokes(6.0).size(), 1U);
    EXPECT_NEAR(length_of(strokes_of(0)[0]), 6.0, 0.3);
}

// The camera goes round a ball and a ring.
TEST_F(LineStrokes, LinesKeepTheirNumbersFromFrameToFrame) {
    std::vector<frame::Item> items{item_of(&ball_lines), item_of(&ring_lines)};
    items[0].transform[3] = {0.0, 0.0, 3.0, 1.0};
    const auto numbers = [&](std::int32_t item) {
        std::vector<std::uint32_t> found;
        for (const Stroke& stroke : strokes_of(item)) found.push_back(stroke.line);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    };
    const auto seen_from = [&](double angle) {
        frame::Camera camera = front_camera(size, size, 3.0);
        camera.view =
            frame::look_at({8.0 * std::sin(angle), -8.0 * std::cos(angle), 9.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0});
        draw(items, camera);
    };
    seen_from(0.0);
    const std::vector<std::uint32_t> ball_number = numbers(0);
    const std::vector<std::uint32_t> ring_numbers = numbers(1);
    ASSERT_EQ(ball_number.size(), 1U);
    ASSERT_EQ(ring_numbers.size(), 2U);
    EXPECT_GT(ball_number[0], 0U);
    EXPECT_FALSE(std::count(ring_numbers.begin(), ring_numbers.end(), ball_number[0]));
    for (int i = 1; i < 40; ++i) {
        seen_from(0.02 * i);
        EXPECT_EQ(numbers(0), ball_number);
        EXPECT_EQ(numbers(1), ring_numbers);
    }
    // Another line set is another line. Lines that were gone come back with new numbers.
    items.pop_back();
    seen_from(0.0);
    EXPECT_EQ(numbers(0), ball_number);
    items.push_back(item_of(&ring_lines));
    seen_from(0.0);
    EXPECT_EQ(numbers(0), ball_number);
    for (const std::uint32_t number : numbers(1)) EXPECT_GT(number, ring_numbers.back());
}

// The camera goes round a ring, with a jump. The result equals that of a new renderer, and two drawings from one place
// have the same bits.
TEST_F(LineStrokes, MatchAFreshRendererFromFrameToFrame) {
    style[0].hidden = HiddenParts::attenuated;
    const std::array items{item_of(&ring_lines)};
    const auto whole = [&](const drawing::Drawing& drawing) {
        double sum = 0.0;
        for (const Stroke& stroke : drawing.strokes)
            sum += static_cast<double>(drawing.points[stroke.first + stroke.count - 1].length);
        return sum;
    };
    for (const double angle : {0.0, 0.01, 0.02, 0.03, 1.5, 1.51, 1.51, 1.52}) {
        frame::Camera camera = front_camera(size, size, 1.6);
        camera.view =
            frame::look_at({8.0 * std::sin(angle), -8.0 * std::cos(angle), 5.0}, glm::dvec3(0.0), {0.0, 0.0, 1.0});
        const double length = whole(draw(items, camera));
        const drawing::LineCounts counts = frame.drawing().line_counts;
        DrawnFrame other(runtime);
        other.draw(items, camera);
        EXPECT_NEAR(length, whole(other.drawing()), 0.02) << angle;
        EXPECT_EQ(counts.curves, other.drawing().line_counts.curves);
        EXPECT_EQ(counts.cusps, other.drawing().line_counts.cusps);
        EXPECT_EQ(counts.broken + counts.settled + counts.contradictions, 0);
        const std::vector<StrokePoint> points(frame.drawing().points.begin(), frame.drawing().points.end());
        draw(items, camera);
        ASSERT_EQ(frame.drawing().points.size(), static_cast<std::int64_t>(points.size()));
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_EQ(frame.drawing().points[static_cast<std::int64_t>(i)].x, points[i].x);
            EXPECT_EQ(frame.drawing().points[static_cast<std::int64_t>(i)].y, points[i].y);
        }
    }
}

// The inner contour of a torus that is seen from the side ends at cusps, in a point.
class TaperedAtCusps : public LineStrokes {
protected:
    void look() {
        frame::Camera camera = front_camera(size, size, 1.6);
        camera.view = frame::look_at({0.0, -8.5, 5.0}, glm::dvec3(0.0), {0.0, 0.0, 1.0});
        draw(std::array{item_of(&ring_lines)}, camera);
        ASSERT_EQ(frame.drawing().line_counts.cusps, 4);
    }
};

TEST_F(TaperedAtCusps, ShortStrokesAreThinner) {
    constexpr float taper = 300.0F;
    style[0].taper = taper;
    style[0].width = 4.0F;
    look();
    int thin = 0;
    for (const Stroke& stroke : frame.drawing().strokes) {
        const auto points = points_of(stroke);
        const bool has_free_end = points.front().radius == 0.0F || points.back().radius == 0.0F;
        const float whole = points.back().length;
        float widest = 0.0F;
        for (const StrokePoint& p : points) widest = std::max(widest, p.radius);
        const float asked = has_free_end ? 2.0F * std::min(1.0F, whole / (2.0F * taper)) : 2.0F;
        EXPECT_LE(widest, 1.0001F * asked);
        EXPECT_GT(widest, 0.95F * asked);
        thin += has_free_end && whole < 2.0F * taper ? 1 : 0;
    }
    EXPECT_GT(thin, 0);
}

TEST_F(TaperedAtCusps, OtherEndsKeepTheirWidth) {
    style[0].taper = 20.0F;
    style[0].width = 4.0F;
    style[0].cap = Cap::pointed;
    look();
    int free_ends = 0;
    for (const Stroke& stroke : frame.drawing().strokes) {
        const auto points = points_of(stroke);
        const float whole = points.back().length;
        const bool begins = points.front().radius == 0.0F;
        const bool ends = points.back().radius == 0.0F;
        free_ends += (begins ? 1 : 0) + (ends ? 1 : 0);
        EXPECT_EQ(stroke.cap_begin == Cap::pointed, begins);
        EXPECT_EQ(stroke.cap_end == Cap::pointed, ends);
        for (const StrokePoint& p : points) {
            const float from_end = std::min(begins ? p.length : 1e9F, ends ? whole - p.length : 1e9F);
            const float taper = std::min(20.0F, 0.5F * whole);
            const float left = std::max(0.0F, 1.0F - from_end / taper);
            EXPECT_NEAR(p.radius, 2.0F * std::sqrt(1.0F - left * left), 0.05F);
        }
    }
    EXPECT_EQ(free_ends, 2); // at the other two cusps the line is hidden
}

TEST_F(TaperedAtCusps, ZeroTaperKeepsTheWidth) {
    style[0].taper = 0.0F;
    style[0].width = 4.0F;
    look();
    EXPECT_GT(frame.drawing().strokes.size(), 1);
    for (const StrokePoint& p : frame.drawing().points) EXPECT_EQ(p.radius, 2.0F);
}

// The camera is inside the torus or beside it, and items may be mirrored. Dashes beyond the window are not made.
TEST_F(LineStrokes, AreFiniteForAnyCamera) {
    style[0].hidden = HiddenParts::dashed;
    stretched = 0.25; // a piece beside the eye is not drawn evenly
    glm::dmat4 mirrored(1.0);
    mirrored[0][0] = -0.7;
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.37 * i;
        const glm::dvec3 from =
            (0.05 + 0.05 * i) * glm::dvec3(std::cos(angle), std::sin(angle), 0.4 * std::cos(3.0 * angle));
        frame::Camera camera;
        camera.view = frame::look_at(from, {0.0, 0.1, 0.05}, {0.0, 0.0, 1.0});
        camera.projection = frame::perspective(1.2, size, size, 0.01, 20.0, camera.depth);
        camera.viewport = {0.0, 0.0, size, size};
        draw(std::array{item_of(&ring_lines, i % 2 == 0 ? mirrored : glm::dmat4(1.0))}, camera);
        EXPECT_LT(frame.drawing().strokes.size(), 2000);
    }
}

// A mirrored item has the same strokes, mirrored.
TEST_F(LineStrokes, MirroredItemsHaveMirroredStrokes) {
    frame::Camera camera = front_camera(size, size, 1.6);
    camera.view = frame::look_at({0.0, -8.5, 5.0}, glm::dvec3(0.0), {0.0, 0.0, 1.0});
    glm::dmat4 mirror(1.0);
    mirror[0][0] = -1.0;
    double length[2] = {0.0, 0.0};
    std::int64_t strokes[2] = {0, 0};
    for (const int i : {0, 1}) {
        draw(std::array{item_of(&ring_lines, i == 0 ? glm::dmat4(1.0) : mirror)}, camera);
        strokes[i] = frame.drawing().strokes.size();
        for (const Stroke& stroke : frame.drawing().strokes) length[i] += length_of(stroke);
        EXPECT_EQ(frame.drawing().line_counts.settled, 0);
    }
    EXPECT_EQ(strokes[0], strokes[1]);
    EXPECT_NEAR(length[0], length[1], 0.2);
}

} // namespace
} // namespace hrbfnpr::testing::line_strokes_test
