// SPDX-License-Identifier: MIT
// Tests lines that run beside other lines, on balls, whose contours are circles and ellipses. Pens are four pixels
// wide.
#include "frame/hand_made.h"
#include "support/analytic.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace hrbfnpr::testing::line_beside_test {
namespace {

using drawing::Stroke;
using drawing::StrokePoint;
using frame::HiddenParts;
using frame::LineStyle;

constexpr int size = 500; // 200 pixels per unit

const std::array<frame::LayerStyle, 1> blank{[] {
    frame::LayerStyle style;
    style.share = 0.0F;
    return style;
}()};

glm::dmat4 scaled(const glm::dvec3& to, const glm::dvec3& scale) {
    glm::dmat4 m(1.0);
    for (glm::length_t k = 0; k < 3; ++k) m[k] = scale[k] * m[k];
    m[3] = glm::dvec4(to, 1.0);
    return m;
}
glm::dmat4 moved(const glm::dvec3& to, double scale) { return scaled(to, glm::dvec3(scale)); }

class LinesBeside : public ::testing::Test {
protected:
    [[nodiscard]] frame::Item item_of(const curves::LineSet* lines, const glm::dmat4& transform,
                                      std::span<const LineStyle> with) {
        frame::Item item = layered_item(set, frame::Style(), transform);
        item.style.tone = frame::Tone::none;
        item.style.hidden_lines = frame::HiddenLines::show;
        item.style.layers = blank;
        item.style.lines = with;
        item.style.halo_width = halo;
        item.lines = lines;
        return item;
    }
    [[nodiscard]] frame::Item ball_at(const glm::dmat4& transform) { return item_of(&ball_lines, transform, style); }
    void draw(std::span<const frame::Item> items) { frame.draw(items, front_camera(size, size)); }
    // Returns the half width of an item's lines where they cross the ray from a place at an angle, or 0.
    [[nodiscard]] double radius_at(std::int32_t item, double degrees,
                                   const glm::dvec2& from = glm::dvec2(250.0)) const {
        const glm::dvec2 ray(std::cos(degrees * pi / 180.0), std::sin(degrees * pi / 180.0));
        double found = 0.0;
        for (const Stroke& stroke : frame.drawing().strokes) {
            if (frame.drawing().layers[stroke.layer].item != item) continue;
            for (std::int64_t i = stroke.first; i + 1 < stroke.first + stroke.count; ++i) {
                const StrokePoint& a = frame.drawing().points[i];
                const StrokePoint& b = frame.drawing().points[i + 1];
                const glm::dvec2 p = glm::dvec2(a.x, a.y) - from;
                const glm::dvec2 q = glm::dvec2(b.x, b.y) - from;
                const double to_p = ray.x * p.y - ray.y * p.x;
                const double to_q = ray.x * q.y - ray.y * q.x;
                if (to_p * to_q > 0.0 || to_p == to_q || glm::dot(p, ray) < 0.0) continue;
                found = std::max(found, glm::mix(static_cast<double>(a.radius), static_cast<double>(b.radius),
                                                 to_p / (to_p - to_q)));
            }
        }
        return found;
    }
    [[nodiscard]] double length_of(std::int32_t item) const {
        double sum = 0.0;
        for (const Stroke& stroke : frame.drawing().strokes)
            if (frame.drawing().layers[stroke.layer].item == item)
                sum += static_cast<double>(frame.drawing().points[stroke.first + stroke.count - 1].length);
        return sum;
    }
    // Two contours of balls around one axis, `apart` pixels apart. The nearer one is the smaller.
    void draw_coaxial(double apart) {
        draw(std::array{ball_at(moved({0.0, 0.0, 3.0}, 1.0 - apart / 200.0)), ball_at(moved({0.0, 0.0, 0.0}, 1.0))});
    }

    base::Runtime runtime = test::with_threads(2);
    test::SquareSphere ball;
    curves::LineSetSettings cells{[] {
        curves::LineSetSettings settings;
        settings.side = 0.1;
        return settings;
    }()};
    curves::LineSet ball_lines{runtime, ball, std::make_unique<implicit::DifferencedShape>(ball), cells};
    marks::PointSet set = clustered(runtime, sphere(runtime.memory, 500));
    std::array<LineStyle, 1> style{[] {
        LineStyle lines;
        lines.width = 4.0F;
        return lines;
    }()};
    float halo = 0.01F; // pixels
    DrawnFrame frame{runtime};
};

TEST_F(LinesBeside, OneOfTwoLinesHalfAPenApartStays) {
    draw_coaxial(2.0);
    EXPECT_EQ(frame.drawing().strokes.size(), 1);
    for (double angle = 0.5; angle < 360.0; angle += 7.0)
        EXPECT_NEAR(radius_at(0, angle) + radius_at(1, angle), 2.0, 1e-3) << angle;
}

TEST_F(LinesBeside, LinesWithWhiteBetweenThemStay) {
    draw_coaxial(6.5);
    EXPECT_EQ(frame.drawing().strokes.size(), 2);
    for (double angle = 0.5; angle < 360.0; angle += 7.0) {
        EXPECT_NEAR(radius_at(0, angle), 2.0, 1e-6);
        EXPECT_NEAR(radius_at(1, angle), 2.0, 1e-6);
    }
}

TEST_F(LinesBeside, LinesWithoutHalosStay) {
    halo = 0.0F;
    draw_coaxial(2.0);
    EXPECT_EQ(frame.drawing().strokes.size(), 2);
    EXPECT_EQ(radius_at(0, 30.0), 2.0);
    EXPECT_EQ(radius_at(1, 30.0), 2.0);
}

// The weightier line keeps its width, and the other one grows with the room.
TEST_F(LinesBeside, WidthsChangeSmoothlyWithTheDistance) {
    draw_coaxial(1.9);
    const std::int32_t kept = radius_at(0, 30.0) > 0.0 ? 0 : 1;
    double last = 0.0;
    for (double apart = 2.0; apart < 6.6; apart += 0.1) {
        draw_coaxial(apart);
        EXPECT_NEAR(radius_at(kept, 30.0), 2.0, 1e-3) << apart;
        const double radius = radius_at(1 - kept, 30.0);
        EXPECT_NEAR(radius, std::clamp((apart - 3.0) / 1.5, 0.0, 2.0), 0.1) << apart;
        EXPECT_LT(std::abs(radius - last), 0.15) << apart;
        last = radius;
    }
    EXPECT_NEAR(last, 2.0, 1e-6);
}

// Both long sides of an ellipse belong to one contour.
TEST_F(LinesBeside, AThinPlateSeenEdgeOnIsOneLine) {
    draw(std::array{ball_at(scaled({}, {1.0, 0.003, 0.5}))}); // 1.2 pixels thick
    for (double x = 80.0; x < 421.0; x += 10.0) {
        const glm::dvec2 middle(x, 250.0);
        EXPECT_NEAR(radius_at(0, 90.0, middle) + radius_at(0, -90.0, middle), 2.0, 0.2) << x;
    }
    EXPECT_LT(length_of(0), 500.0); // The whole contour is 800 pixels long.
}

// Two discs with a radius of 100 pixels touch in the middle of the picture.
TEST_F(LinesBeside, LinesThatTouchBecomeOneLineThere) {
    draw(std::array{ball_at(moved({-0.5, 0.0, 0.0}, 0.499)), ball_at(moved({0.5, 0.0, 0.0}, 0.499))});
    const glm::dvec2 left(150.0, 250.0);
    const glm::dvec2 right(350.0, 250.0);
    const auto sum = [&](double degrees) { return radius_at(0, degrees, left) + radius_at(1, 180.0 - degrees, right); };
    EXPECT_LT(sum(0.1), 2.5);
    EXPECT_GT(sum(0.1), 1.99);
    double last = sum(0.0);
    for (double degrees = 0.5; degrees < 180.0; degrees += 0.5) {
        EXPECT_LT(std::abs(sum(degrees) - last), 0.25) << degrees;
        if (degrees > 25.0) {
            EXPECT_NEAR(sum(degrees), 4.0, 0.01) << degrees;
        }
        last = sum(degrees);
    }
}

// One wide line stays beside a longer thin one.
TEST_F(LinesBeside, TheWiderLineStays) {
    const std::array<LineStyle, 1> wide{[] {
        LineStyle lines;
        lines.width = 8.0F;
        return lines;
    }()};
    for (const bool nearer : {true, false}) {
        draw(std::array{ball_at(moved({0.0, 0.0, nearer ? 3.0 : 0.0}, nearer ? 0.99 : 1.0)),
                        item_of(&ball_lines, moved({0.0, 0.0, nearer ? 0.0 : 3.0}, nearer ? 1.0 : 0.99), wide)});
        EXPECT_NEAR(radius_at(0, 30.0), 0.0, 1e-6);
        EXPECT_NEAR(radius_at(1, 30.0), 4.0, 1e-3);
    }
}

// Lines of other inks, several styles for the same lines, and lines that show data.
TEST_F(LinesBeside, LinesThatSaySomethingElseStay) {
    std::array other = style;
    other[0].ink[0] = 1.0F;
    draw(std::array{ball_at(moved({0.0, 0.0, 3.0}, 0.99)), item_of(&ball_lines, moved({}, 1.0), other)});
    EXPECT_NEAR(radius_at(0, 30.0) + radius_at(1, 30.0), 4.0, 1e-3);
    const std::array twice{style[0], style[0]};
    draw(std::array{item_of(&ball_lines, moved({}, 1.0), twice)});
    EXPECT_EQ(frame.drawing().strokes.size(), 2);
    EXPECT_NEAR(radius_at(0, 30.0), 2.0, 1e-6);
    curves::LineRequest request;
    request.kind = curves::LineKind::section;
    const std::array<double, 1> level{0.1};
    request.levels = level;
    cells.lines = {&request, 1};
    const curves::LineSet sections(runtime, ball, std::make_unique<implicit::DifferencedShape>(ball), cells);
    std::array both{style[0], style[0]};
    both[1].kind = curves::LineKind::section;
    draw(std::array{item_of(&sections, moved({}, 1.0), both)}); // a pixel inside of the contour
    EXPECT_EQ(frame.drawing().strokes.size(), 2);
    EXPECT_NEAR(length_of(0), 4.0 * pi * 200.0, 10.0);
}

// The larger ball hides the contour of a smaller one. A visible line covers hidden dashes.
TEST_F(LinesBeside, HiddenLinesUnderVisibleOnesAreNotDrawn) {
    style[0].hidden = HiddenParts::dashed;
    for (const double apart : {1.0, 20.0}) {
        draw(std::array{ball_at(moved({0.0, 0.0, -3.0}, 1.0 - apart / 200.0)), ball_at(moved({}, 1.0))});
        EXPECT_NEAR(length_of(1), 2.0 * pi * 200.0, 2.0);
        if (apart > 2.0) {
            EXPECT_GT(length_of(0), 600.0);
        } else {
            EXPECT_EQ(length_of(0), 0.0);
        }
    }
}

} // namespace
} // namespace hrbfnpr::testing::line_beside_test
