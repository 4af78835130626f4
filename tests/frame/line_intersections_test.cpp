// SPDX-License-Identifier: MIT
// Tests lines in which items cross, with their visibility, against spheres and rings that are known exactly.
#include "frame/line_of_sight.h"
#include "support/analytic.h"
#include "support/runtime.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace hrbfnpr::testing::line_intersections_test {
namespace {

using drawing::Stroke;
using drawing::StrokePoint;
using frame::HiddenParts;
using frame::LineKind;
using frame::LineStyle;

constexpr int size = 600;

std::unique_ptr<curves::LineSet> lines_of(const base::Runtime& runtime, const implicit::Implicit& surface,
                                          double side) {
    curves::LineSetSettings settings;
    settings.side = side;
    return std::make_unique<curves::LineSet>(runtime, surface, std::make_unique<implicit::DifferencedShape>(surface),
                                             settings);
}

glm::dmat4 moved(const glm::dvec3& by) { return glm::translate(glm::dmat4(1.0), by); }

class LineIntersections : public ::testing::Test {
protected:
    void SetUp() override {
        style.kind = LineKind::intersection;
        style.width = 1.0F;
        style.taper = 0.0F;
        style.shortest = 0.0F;
        camera = frame::fit_bounds({glm::dvec3(-1.5), glm::dvec3(2.0)}, {-0.8, 1.0, -0.6}, {0, 0, 1}, 0.5, size, size,
                                   0.05, {});
    }
    void add(const implicit::Implicit& surface, const glm::dmat4& to_world, double side = 0.1) {
        sets.push_back(lines_of(runtime, surface, side));
        poses.push_back(to_world);
    }
    void draw(DrawnFrame& by) {
        std::vector<frame::Item> items;
        for (std::size_t i = 0; i < sets.size(); ++i) {
            frame::Item item = layered_item(set, frame::Style(), poses[i]);
            item.style.hidden_lines = frame::HiddenLines::show;
            item.style.tone = frame::Tone::none;
            item.style.layers = blank;
            item.style.lines = std::span(&style, 1);
            item.style.halo_width = 0.0F;
            item.lines = sets[i].get();
            items.push_back(item);
        }
        by.draw(items, camera);
    }
    [[nodiscard]] glm::dvec2 window_of(const glm::dvec3& place) const {
        const glm::dvec4 clip = camera.projection * camera.view * glm::dvec4(place, 1.0);
        return {0.5 * size * (1.0 + clip.x / clip.w), 0.5 * size * (1.0 - clip.y / clip.w)};
    }
    // Returns the number of strokes, hidden or visible ones, that pass a place in the window.
    [[nodiscard]] static int strokes_at(const DrawnFrame& by, const glm::dvec2& place, bool hidden,
                                        double within = 0.3) {
        int count = 0;
        for (const Stroke& stroke : by.drawing().strokes) {
            if ((stroke.hidden_layers > 0) != hidden) continue;
            double least = HUGE_VAL;
            const StrokePoint* const points = by.drawing().points.data() + stroke.first;
            for (std::int64_t i = 0; i + 1 < stroke.count; ++i) {
                const glm::dvec2 a(points[i].x, points[i].y);
                const glm::dvec2 way = glm::dvec2(points[i + 1].x, points[i + 1].y) - a;
                const double share = std::clamp(glm::dot(place - a, way) / glm::dot(way, way), 0.0, 1.0);
                least = std::min(least, glm::distance(place, a + share * way));
            }
            count += least <= within ? 1 : 0;
        }
        return count;
    }
    [[nodiscard]] glm::dvec3 eye() const { return glm::dvec3(glm::inverse(camera.view)[3]); }

    base::Runtime runtime = test::with_threads(2);
    std::array<frame::LayerStyle, 1> blank{[] {
        frame::LayerStyle layer;
        layer.share = 0.0F;
        return layer;
    }()};
    marks::PointSet set = clustered(runtime, sphere(runtime.memory, 200));
    LineStyle style;
    std::vector<std::unique_ptr<curves::LineSet>> sets;
    std::vector<glm::dmat4> poses;
    frame::Camera camera;
    DrawnFrame frame{runtime};
};

// A circle of two balls behind a ring: each place is compared with a ray through the three solids.
TEST_F(LineIntersections, VisiblePartsAreThoseThatRaysSee) {
    const test::Sphere one(1.0);
    const test::Sphere other(0.8);
    const test::Torus torus(0.5, 0.12);
    const glm::dvec3 ring_at(1.9, -1.6, 1.2); // It touches no ball.
    add(one, glm::dmat4(1.0));
    add(other, moved({0.9, 0.0, 0.3}), 0.07);
    add(torus, moved(ring_at), 0.05);
    style.hidden = HiddenParts::shown;
    draw(frame);
    ASSERT_EQ(frame.drawing().line_counts.contradictions + frame.drawing().line_counts.broken, 0);
    const glm::dvec3 axis(0.9, 0.0, 0.3);
    const double far = glm::length(axis);
    const double at = 0.5 * (far * far + 1.0 - 0.64) / far;
    const glm::dvec3 x = axis / far;
    const glm::dvec3 y(0.0, 1.0, 0.0);
    const glm::dvec3 z = glm::cross(x, y);
    int seen = 0, hidden = 0;
    for (int i = 0; i < 720; ++i) {
        const double t = 2.0 * pi * i / 720.0;
        const glm::dvec3 p = at * x + std::sqrt(1.0 - at * at) * (std::cos(t) * y + std::sin(t) * z);
        const glm::dvec3 toward = glm::normalize(eye() - p);
        const double own = std::min(glm::dot(p, toward), glm::dot((p - axis) / 0.8, toward));
        const Solid solid = [&](const glm::dvec3& q) {
            return std::hypot(std::hypot(q.x - ring_at.x, q.y - ring_at.y) - 0.5, q.z - ring_at.z) - 0.12;
        };
        const double before = clearance(solid, p, toward);
        if (std::abs(own) < 0.03 || std::abs(before) < 0.01) continue; // too near to a change
        const bool is_hidden = own < 0.0 || before < 0.0;
        EXPECT_GE(strokes_at(frame, window_of(p), is_hidden), 1) << i;
        EXPECT_EQ(strokes_at(frame, window_of(p), !is_hidden, 0.1), 0) << i;
        ++(is_hidden ? hidden : seen);
    }
    EXPECT_GT(seen, 100);
    EXPECT_GT(hidden, 100);
    // Nothing is drawn twice.
    double whole = 0.0;
    for (int i = 0; i < 720; ++i) {
        const auto place = [&](int k) {
            const double t = 2.0 * pi * k / 720.0;
            return window_of(at * x + std::sqrt(1.0 - at * at) * (std::cos(t) * y + std::sin(t) * z));
        };
        whole += glm::distance(place(i), place(i + 1));
    }
    double drawn = 0.0;
    for (const Stroke& stroke : frame.drawing().strokes)
        drawn += static_cast<double>(frame.drawing().points[stroke.first + stroke.count - 1].length -
                                     frame.drawing().points[stroke.first].length);
    EXPECT_NEAR(drawn, whole, 0.01 * whole);
}

// A sheet that cuts a ball: behind the ball's front the line is hidden, although it lies on the sheet.
TEST_F(LineIntersections, ABallHidesTheBackOfItsCut) {
    const test::Sphere ball(1.0);
    const test::Plane sheet({0.0, 0.0, 1.0}, 0.2, {{-1.4, -1.4, 0.0}, {1.4, 1.4, 0.4}});
    add(ball, glm::dmat4(1.0));
    add(sheet, glm::dmat4(1.0));
    draw(frame);
    EXPECT_EQ(frame.drawing().line_counts.contradictions, 0);
    for (int i = 0; i < 360; ++i) {
        const double r = std::sqrt(0.96);
        const glm::dvec3 p(r * std::cos(2.0 * pi * i / 360.0), r * std::sin(2.0 * pi * i / 360.0), 0.2);
        const double facing = glm::dot(p, glm::normalize(eye() - p));
        if (std::abs(facing) < 0.03) continue;
        EXPECT_EQ(strokes_at(frame, window_of(p), false), facing > 0.0 ? 1 : 0) << i;
    }
}

TEST_F(LineIntersections, ItemsThatAreApartHaveNoLayer) {
    const test::Sphere ball(1.0);
    add(ball, glm::dmat4(1.0));
    add(ball, moved({2.2, 0.0, 0.0}));
    draw(frame);
    const auto layers = [&] {
        const auto& all = frame.drawing().layers;
        return std::count_if(all.begin(), all.end(), [](const drawing::Layer& layer) {
            return layer.line_kind == static_cast<std::uint32_t>(LineKind::intersection);
        });
    };
    EXPECT_EQ(layers(), 0);
    EXPECT_EQ(frame.drawing().strokes.size(), 0);
    poses[1] = moved({1.0, 0.0, 0.0});
    draw(frame);
    EXPECT_EQ(layers(), 1);
}

// Items that move are drawn as by a frame that has drawn nothing before; those that do not keep the numbers of lines.
TEST_F(LineIntersections, LinesFollowItemsThatMove) {
    const test::Sphere ball(1.0);
    const test::Torus torus(1.0, 0.3);
    add(ball, glm::dmat4(1.0), 0.12);
    add(torus, moved({0.8, 0.0, 0.0}), 0.08);
    for (int step = 0; step < 4; ++step) {
        const glm::dmat4 both = glm::rotate(glm::dmat4(1.0), 0.3 * step, glm::dvec3(0.0, 0.0, 1.0));
        poses[0] = both;
        poses[1] = both * moved({0.8 - 0.15 * (step / 2), 0.1, 0.05});
        draw(frame);
        DrawnFrame fresh(runtime);
        draw(fresh);
        const drawing::Drawing& drawing = frame.drawing();
        ASSERT_GT(drawing.strokes.size(), 0);
        ASSERT_EQ(drawing.points.size(), fresh.drawing().points.size()) << step;
        for (std::int64_t i = 0; i < drawing.points.size(); ++i) {
            EXPECT_NEAR(drawing.points[i].x, fresh.drawing().points[i].x, 1e-3) << step;
            EXPECT_NEAR(drawing.points[i].y, fresh.drawing().points[i].y, 1e-3) << step;
        }
    }
}

TEST_F(LineIntersections, LowerSelectsByTheMeanAngle) {
    const test::Sphere ball(1.0);
    add(ball, glm::dmat4(1.0));
    add(ball, moved({1.0, 0.0, 0.0})); // The balls cross at 60 degrees.
    style.lower = 55.0;
    draw(frame);
    EXPECT_GT(frame.drawing().strokes.size(), 0);
    style.lower = 65.0;
    draw(frame);
    EXPECT_EQ(frame.drawing().strokes.size(), 0);
}

} // namespace
} // namespace hrbfnpr::testing::line_intersections_test
