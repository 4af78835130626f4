// SPDX-License-Identifier: MIT
// Tests the laws of line widths, and the wobble of lines: on spheres, where all is known.
#include "frame/hand_made.h"
#include "support/analytic.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace hrbfnpr::testing::line_widths_test {
namespace {

using drawing::Stroke;
using drawing::StrokePoint;
using frame::HiddenParts;
using frame::LineStyle;

const std::array<frame::LayerStyle, 1> blank{[] {
    frame::LayerStyle style;
    style.share = 0.0F;
    return style;
}()};

curves::LineSetSettings with_sections(std::span<const curves::LineRequest> lines) {
    curves::LineSetSettings settings;
    settings.side = 0.1;
    settings.lines = lines;
    return settings;
}

glm::dmat4 moved(const glm::dvec3& to, double scale = 1.0) {
    glm::dmat4 m(scale);
    m[3] = glm::dvec4(to, 1.0);
    return m;
}

class LineWidths : public ::testing::Test {
protected:
    [[nodiscard]] frame::Item item_of(const curves::LineSet* lines, const glm::dmat4& transform = glm::dmat4(1.0)) {
        frame::Item item = layered_item(set, frame::Style(), transform);
        item.style.tone = frame::Tone::none;
        item.style.light = light;
        item.style.layers = blank;
        item.style.lines = style;
        item.style.halo_width = 0.0F;
        item.lines = lines;
        return item;
    }
    // Draws 200 pixels per unit in a picture of 500.
    std::vector<StrokePoint> draw(const std::vector<frame::Item>& items, int size = 500) {
        frame.draw(items, front_camera(size, size));
        return {frame.drawing().points.begin(), frame.drawing().points.end()};
    }
    // The least and the largest half width of an item's lines.
    [[nodiscard]] std::array<float, 2> radii_of(std::int32_t item) const {
        std::array<float, 2> range{1e9F, 0.0F};
        for (const Stroke& stroke : frame.drawing().strokes) {
            if (frame.drawing().layers[stroke.layer].item != item) continue;
            for (std::int64_t i = stroke.first; i < stroke.first + stroke.count; ++i) {
                range[0] = std::min(range[0], frame.drawing().points[i].radius);
                range[1] = std::max(range[1], frame.drawing().points[i].radius);
            }
        }
        return range;
    }
    void expect_radius(std::int32_t item, double radius, double off = 1e-4) const {
        const std::array<float, 2> range = radii_of(item);
        EXPECT_NEAR(range[0], radius, off);
        EXPECT_NEAR(range[1], radius, off);
    }

    base::Runtime runtime = test::with_threads(2);
    test::SquareSphere ball;
    curves::LineSet ball_lines{runtime, ball, std::make_unique<implicit::DifferencedShape>(ball), with_sections({})};
    marks::PointSet set = clustered(runtime, sphere(runtime.memory, 500));
    std::array<LineStyle, 1> style{[] {
        LineStyle lines;
        lines.width = 4.0F;
        return lines;
    }()};
    glm::dvec3 light{-0.4, 0.6, 0.7};
    DrawnFrame frame{runtime};
};

TEST_F(LineWidths, AreConstantWithoutLaws) {
    draw({item_of(&ball_lines)});
    expect_radius(0, 2.0, 0.0);
}

// The surfaces of the balls lie between the depths -2.2 and 2.2, and their contours are in the middle of each ball.
TEST_F(LineWidths, FollowTheDepth) {
    style[0].far_factor = 0.25F;
    const auto radius = [](double share) { return 2.0 * (1.0 - 0.75 * share); };
    draw({item_of(&ball_lines, moved({-0.7, 0.0, 2.0}, 0.2)), item_of(&ball_lines, moved({0.0, 0.0, 1.0}, 0.2)),
          item_of(&ball_lines, moved({0.7, 0.0, -2.0}, 0.2))});
    expect_radius(0, radius(0.2 / 4.4), 2e-3);
    expect_radius(1, radius(1.2 / 4.4), 2e-3);
    expect_radius(2, radius(4.2 / 4.4), 2e-3);
    draw({item_of(&ball_lines, moved({-0.7, 0.0, 2.0}, 0.2)), item_of(&ball_lines, moved({0.0, 0.0, 1.0}, 0.2)),
          item_of(&ball_lines, moved({30.0, 0.0, -2.0}, 0.2))}); // outside of the window
    expect_radius(1, radius(1.2 / 1.4), 2e-3);
}

// The balls reach 0.9 to each side, so the range of depths is at least 0.9.
TEST_F(LineWidths, HardlyFollowTheDepthOfFlatScenes) {
    style[0].far_factor = 0.25F;
    draw({item_of(&ball_lines, moved({-0.7, 0.0, 0.1}, 0.2)), item_of(&ball_lines, moved({0.7, 0.0, -0.1}, 0.2))});
    expect_radius(0, 2.0 * (1.0 - 0.75 * 0.2 / 0.9), 5e-3);
    expect_radius(1, 2.0 * (1.0 - 0.75 * 0.4 / 0.9), 5e-3);
}

// A farther ball comes into the window in steps of two pixels.
TEST_F(LineWidths, ChangeSmoothlyWithDepthsThatComeIntoView) {
    style[0].far_factor = 0.25F;
    float last = 0.0F;
    float first = 0.0F;
    for (int step = 0; step < 80; ++step) {
        draw({item_of(&ball_lines, moved({-0.5, 0.0, 1.0}, 0.3)),
              item_of(&ball_lines, moved({1.6 - 0.01 * step, 0.0, -2.0}, 0.3))});
        const float radius = radii_of(0)[0];
        if (step == 0) first = radius;
        if (step > 0) {
            EXPECT_NEAR(radius, last, 0.2F) << step;
        }
        last = radius;
    }
    EXPECT_GT(last, first + 0.5F);
}

TEST_F(LineWidths, FollowTheLight) {
    style[0].lit_factor = 0.2F;
    light = {3.0, 4.0, 0.0};
    for (const frame::LightSpace space : {frame::LightSpace::camera, frame::LightSpace::world}) {
        frame::Item item = item_of(&ball_lines);
        item.style.light_space = space; // the camera looks along -z, so both spaces agree
        for (const StrokePoint& p : draw({item})) {
            const double lit =
                (0.6 * (static_cast<double>(p.x) - 250.0) - 0.8 * (static_cast<double>(p.y) - 250.0)) / 200.0;
            EXPECT_NEAR(p.radius, 2.0 * (1.0 - 0.8 * (0.5 + 0.5 * lit)), 2e-3);
        }
    }
    const std::array<float, 2> range = radii_of(0);
    EXPECT_NEAR(range[0], 0.4, 0.02);
    EXPECT_NEAR(range[1], 2.0, 0.02);
}

// The radial curvature of a sphere is 1 / its radius, for any size and transform.
TEST_F(LineWidths, FollowTheRadialCurvature) {
    style[0].curvature_factor = 0.5F;
    style[0].curvature_radius = 1.0F;
    const double share = 1.0 - 1.0 / ball.diagonal();
    for (const double scale : {0.3, 1.0}) {
        draw({item_of(&ball_lines, moved({0.1, 0.0, 0.0}, scale))});
        expect_radius(0, 2.0 * (1.0 - 0.5 * share), 1e-3);
    }
    style[0].curvature_radius = static_cast<float>(0.9 / ball.diagonal());
    draw({item_of(&ball_lines)});
    expect_radius(0, 2.0);
}

// On a parallel of a torus the curvature across the line is that of the tube.
TEST_F(LineWidths, FollowTheCurvatureAcrossALine) {
    const test::Torus torus(1.0, 0.25);
    curves::LineRequest request;
    request.kind = curves::LineKind::section;
    const double level[1] = {0.15};
    request.levels = level;
    const curves::LineSet lines(runtime, torus, std::make_unique<implicit::DifferencedShape>(torus),
                                with_sections({&request, 1}));
    style[0].kind = curves::LineKind::section;
    style[0].curvature_factor = 2.0F;
    style[0].curvature_radius = 0.5F;
    style[0].taper = 0.0F;
    draw({item_of(&lines)});
    const double curvature = torus.diagonal() / 0.25;
    expect_radius(0, 2.0 * (1.0 + (1.0 - 1.0 / (0.5 * curvature))), 0.01);
}

// In front of a larger ball a ball's contour is an inner one; beside it both are outlines.
TEST_F(LineWidths, AreLargerOnTheOutline) {
    style[0].outline_factor = 2.0F;
    draw({item_of(&ball_lines, moved({0.0, 0.0, 3.0}, 0.3)), item_of(&ball_lines)});
    expect_radius(0, 2.0);
    expect_radius(1, 4.0);
    draw({item_of(&ball_lines, moved({0.5, 0.0, 3.0}, 0.3)), item_of(&ball_lines, moved({-0.5, 0.0, 0.0}, 0.3))});
    expect_radius(0, 4.0);
    expect_radius(1, 4.0);
}

// The ball is half in front of the larger one. The width changes over six widths beyond the crossing.
TEST_F(LineWidths, ChangeSmoothlyFromTheOutline) {
    style[0].outline_factor = 2.0F;
    draw({item_of(&ball_lines, moved({0.6, 0.0, 3.0}, 0.4)), item_of(&ball_lines, moved({-0.1, 0.0, 0.0}, 0.6))});
    const std::array<float, 2> range = radii_of(0);
    EXPECT_NEAR(range[0], 2.0, 1e-4);
    EXPECT_NEAR(range[1], 4.0, 1e-4);
    int between = 0;
    const glm::dvec2 near(370.0, 250.0), far(230.0, 250.0);
    for (const StrokePoint& p : frame.drawing().points) {
        const glm::dvec2 place(p.x, p.y);
        if (std::abs(glm::distance(place, near) - 80.0) > 0.1) continue;
        const bool outer = glm::distance(place, far) > 120.0;
        if (outer) {
            EXPECT_NEAR(p.radius, 4.0, 1e-4);
        }
        const double depth = 120.0 - glm::distance(place, far); // pixels within the larger circle
        if (depth > 26.0) {
            EXPECT_NEAR(p.radius, 2.0, 1e-4);
        }
        between += p.radius > 2.1F && p.radius < 3.9F ? 1 : 0;
    }
    EXPECT_GE(between, 6);
    expect_radius(1, 4.0);
}

// The camera is inside a torus and beside it, with all laws. Lines that pass beside the eye are extremely long.
TEST_F(LineWidths, AreFiniteForAnyCamera) {
    const test::Torus torus(1.0, 0.4);
    const curves::LineSet lines(runtime, torus, std::make_unique<implicit::DifferencedShape>(torus), with_sections({}));
    style[0].outline_factor = 2.0F;
    style[0].far_factor = style[0].lit_factor = style[0].curvature_factor = 0.5F;
    style[0].wobble = 1.0F;
    style[0].wobble_width = 0.5F;
    style[0].wobble_length = 1.0F;
    style[0].hidden = HiddenParts::dashed;
    for (int i = 0; i < 30; ++i) {
        const double angle = 0.37 * i;
        frame::Camera camera;
        camera.view = frame::look_at((0.05 + 0.06 * i) *
                                         glm::dvec3(std::cos(angle), std::sin(angle), 0.4 * std::cos(3.0 * angle)),
                                     {0.0, 0.1, 0.05}, {0.0, 0.0, 1.0});
        camera.projection = frame::perspective(1.2, 500, 500, 0.01, 20.0, camera.depth);
        camera.viewport = {0.0, 0.0, 500.0, 500.0};
        frame.draw(std::array{item_of(&lines)}, camera);
        EXPECT_LT(frame.drawing().points.size(), 100'000);
        for (const StrokePoint& p : frame.drawing().points) {
            EXPECT_TRUE(std::isfinite(p.x + p.y + p.radius + p.length + p.opacity));
            EXPECT_GE(p.radius, 0.0F);
        }
    }
}

class WobblingLines : public LineWidths {
protected:
    // The deviation in line widths, by the angle round the circle in degrees.
    std::vector<double> strays(int size) {
        style[0].width = 0.008F * static_cast<float>(size);
        const std::vector<StrokePoint> points = draw({item_of(&ball_lines)}, size);
        const double middle = 0.5 * size;
        std::vector<double> found(360, 0.0);
        std::vector<double> nearest(360, 1e9);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            for (int k = 0; k <= 8; ++k) {
                const double u = k / 8.0;
                const double x =
                    (1.0 - u) * static_cast<double>(points[i].x) + u * static_cast<double>(points[i + 1].x) - middle;
                const double y =
                    (1.0 - u) * static_cast<double>(points[i].y) + u * static_cast<double>(points[i + 1].y) - middle;
                const double angle = std::atan2(y, x) * 180.0 / pi + 180.0;
                const auto degree = static_cast<std::size_t>(angle) % 360;
                const double off = std::abs(angle - static_cast<double>(degree) - 0.5);
                if (off >= nearest[degree]) continue;
                nearest[degree] = off;
                found[degree] = (std::hypot(x, y) - 0.4 * size) / static_cast<double>(style[0].width);
            }
        return found;
    }
};

TEST_F(WobblingLines, StayWithinTheirWobble) {
    style[0].wobble = 0.5F;
    const std::vector<double> found = strays(500);
    const auto [least, most] = std::minmax_element(found.begin(), found.end());
    EXPECT_GT(*least, -0.51);
    EXPECT_LT(*most, 0.51);
    EXPECT_LT(*least, -0.1);
    EXPECT_GT(*most, 0.1);
    expect_radius(0, 2.0);
    for (std::size_t i = 0; i < 360; ++i) EXPECT_NEAR(found[i], found[(i + 1) % 360], 0.1); // smooth, and closed
}

// A circle of 25 pixels strays by at most the share 25 / 160 of what a line strays that is longer than a swing.
TEST_F(WobblingLines, ShortLinesStrayLess) {
    style[0].wobble = 1.0F;
    double most = 0.0;
    for (const StrokePoint& p : draw({item_of(&ball_lines, moved({}, 0.02))}))
        most = std::max(most,
                        std::abs(std::hypot(static_cast<double>(p.x) - 250.0, static_cast<double>(p.y) - 250.0) - 4.0));
    EXPECT_GT(most, 0.05);
    EXPECT_LT(most, 4.0 * 25.2 / 160.0 + 0.02);
}

TEST_F(WobblingLines, WobbleAlikeAtEverySize) {
    style[0].wobble = 1.0F;
    const std::vector<double> small = strays(400);
    const std::vector<double> large = strays(1600);
    for (std::size_t i = 0; i < 360; ++i) EXPECT_NEAR(small[i], large[i], 0.04) << i;
    style[0].wobble_seed = 1;
    const std::vector<double> other = strays(400);
    double off = 0.0;
    for (std::size_t i = 0; i < 360; ++i) off = std::max(off, std::abs(small[i] - other[i]));
    EXPECT_GT(off, 0.3);
}

TEST_F(WobblingLines, VaryInWidth) {
    style[0].wobble_width = 0.5F;
    for (const StrokePoint& p : draw({item_of(&ball_lines)}))
        EXPECT_NEAR(std::hypot(p.x - 250.0F, p.y - 250.0F), 200.0F, 0.02F);
    const std::array<float, 2> range = radii_of(0);
    EXPECT_GE(range[0], 1.0F);
    EXPECT_LE(range[1], 3.0F);
    EXPECT_GT(range[1] - range[0], 0.4F);
}

// The shown and the dashed parts of one line are on one wobbling curve.
TEST_F(WobblingLines, HiddenPartsContinueTheWobble) {
    style[0].wobble = 1.0F;
    const std::vector<frame::Item> items{item_of(&ball_lines, moved({0.5, 0.0, 3.0}, 0.4)), item_of(&ball_lines)};
    const std::vector<StrokePoint> alone = draw({item_of(&ball_lines, moved({900.0, 0.0, 0.0}, 0.4)), items[1]});
    style[0].hidden = HiddenParts::shown;
    draw(items);
    int compared = 0;
    for (const Stroke& stroke : frame.drawing().strokes) {
        if (frame.drawing().layers[stroke.layer].item != 1) continue;
        for (std::int64_t i = stroke.first; i < stroke.first + stroke.count; ++i, ++compared) {
            const StrokePoint& p = frame.drawing().points[i];
            double nearest = 1e9;
            for (std::size_t k = 0; k + 1 < alone.size(); ++k) {
                const glm::dvec2 a(alone[k].x, alone[k].y), b(alone[k + 1].x, alone[k + 1].y), q(p.x, p.y);
                const double u = std::clamp(glm::dot(q - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
                nearest = std::min(nearest, glm::distance(q, glm::mix(a, b, u)));
            }
            EXPECT_LT(nearest, 0.3);
        }
    }
    EXPECT_GT(compared, 40);
}

} // namespace
} // namespace hrbfnpr::testing::line_widths_test
