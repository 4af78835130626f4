// SPDX-License-Identifier: MIT
// Tests outlines of lines: they cover the same places as the line, counted at random places.
#include "output/vector/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace hrbfnpr::testing::ribbon_test {
namespace {

using drawing::Cap;
using geometry::Cubic;
using glm::dvec2;
using output::PagePath;
using output::PagePoint;

// A shape that is filled by the nonzero rule.
struct Shape {
    [[nodiscard]] bool covers(const dvec2& p) const {
        int winding = 0;
        for (const auto& loop : loops)
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const dvec2& a = loop[i];
                const dvec2& b = loop[(i + 1) % loop.size()];
                const double side = (b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y);
                if (a.y <= p.y && b.y > p.y && side > 0.0) ++winding;
                if (a.y > p.y && b.y <= p.y && side < 0.0) --winding;
            }
        return winding != 0;
    }

    std::vector<std::vector<dvec2>> loops;
};

// Flattens curves into polygons.
class Polygons final : public output::ShapeSink {
public:
    void begin_fill(double /*opacity*/) override {}
    void begin_line(double /*width*/, Cap /*cap*/, double /*opacity*/) override {}
    void end_shape() override {}
    void move_to(const dvec2& p) override { shape.loops.push_back({p}); }
    void line_to(const dvec2& p) override { shape.loops.back().push_back(p); }
    void curve_to(const Cubic& c) override {
        const dvec2 from = shape.loops.back().back();
        for (int k = 1; k <= 16; ++k) {
            const double t = k / 16.0, s = 1.0 - t;
            shape.loops.back().push_back(s * s * s * from + 3.0 * s * s * t * c.control_1 +
                                         3.0 * s * t * t * c.control_2 + t * t * t * c.end);
        }
    }
    void arc_to(const output::CurvePiece&) override { ADD_FAILURE() << "outlines have no arcs"; }
    void close() override { ++closed; }

    Shape shape;
    int closed = 0;
};

// Returns the distance of a place from the discs along a line; negative: inside.
double outside(const dvec2& p, const std::vector<PagePoint>& line) {
    double least = 1e300;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const dvec2 a(line[i - 1].x, line[i - 1].y), b(line[i].x, line[i].y);
        const double square = glm::dot(b - a, b - a);
        const double t = square > 0.0 ? std::clamp(glm::dot(p - a, b - a) / square, 0.0, 1.0) : 0.0;
        const double radius = line[i - 1].radius + t * (line[i].radius - line[i - 1].radius);
        least = std::min(least, glm::distance(p, a + t * (b - a)) - radius);
    }
    return least;
}

// Returns the share of random places around the line that are on the wrong side by more than `margin`.
double wrong(const std::vector<PagePoint>& line, const Shape& shape, double margin) {
    std::mt19937 random(1); // NOLINT: the same places each time
    std::uniform_real_distribution<double> x(-20.0, 60.0), y(-40.0, 40.0);
    int count = 0, bad = 0;
    for (int i = 0; i < 20000; ++i) {
        const dvec2 p(x(random), y(random));
        const double off = outside(p, line);
        if (off > 3.0) continue;
        ++count;
        if (std::abs(off) > margin && shape.covers(p) != (off < 0.0)) ++bad;
    }
    return static_cast<double>(bad) / std::max(count, 1);
}

Shape outline_of(const std::vector<PagePoint>& line, bool closed = false, Cap begin = Cap::round,
                 Cap end = Cap::round) {
    base::Memory memory;
    output::ShapeSettings settings;
    settings.tolerance = 0.02;
    output::Shapes shapes(memory, settings);
    Polygons polygons;
    PagePath path;
    path.points = line;
    path.closed = closed;
    path.begin = begin;
    path.end = end;
    shapes.outline(path, polygons);
    EXPECT_EQ(static_cast<std::size_t>(polygons.closed), polygons.shape.loops.size());
    return polygons.shape;
}

TEST(Ribbon, CoversASwellingLine) {
    std::vector<PagePoint> line;
    for (int i = 0; i <= 80; ++i) line.push_back({0.5 * i, 8.0 * std::sin(0.1 * i), 1.0 + std::sin(0.17 * i)});
    EXPECT_EQ(wrong(line, outline_of(line), 0.1), 0.0); // the outline follows widths across the line, not discs
}

TEST(Ribbon, CoversSharpTurnsAndCorners) {
    const std::vector<PagePoint> corner{{0, 0, 2}, {30, 0, 2}, {5, 12, 1}, {40, -20, 3}};
    EXPECT_EQ(wrong(corner, outline_of(corner), 0.06), 0.0);
    std::vector<PagePoint> tight; // turns narrower than the line's width
    for (int i = 0; i <= 60; ++i) tight.push_back({0.6 * i, 1.5 * std::sin(1.1 * i), 2.5});
    EXPECT_EQ(wrong(tight, outline_of(tight), 0.06), 0.0);
}

TEST(Ribbon, LeavesTheMiddleOfARingEmpty) {
    std::vector<PagePoint> ring;
    for (int i = 0; i <= 100; ++i)
        ring.push_back({20.0 + 15.0 * std::cos(0.0628318530717959 * (i % 100)),
                        15.0 * std::sin(0.0628318530717959 * (i % 100)), 1.5});
    const Shape shape = outline_of(ring, true);
    EXPECT_EQ(shape.loops.size(), 2U);
    EXPECT_FALSE(shape.covers({20.0, 0.0}));
    EXPECT_EQ(wrong(ring, shape, 0.06), 0.0);
    // With a corner, the ring is cut there.
    std::vector<PagePoint> drop = ring;
    drop[25] = {20.0, 30.0, 1.5};
    EXPECT_EQ(wrong(drop, outline_of(drop, true), 0.06), 0.0);
}

TEST(Ribbon, EndsWithTheRequestedCaps) {
    const std::vector<PagePoint> line{{0, 0, 2}, {20, 0, 2}};
    EXPECT_TRUE(outline_of(line).covers({21.9, 0.0}));
    EXPECT_FALSE(outline_of(line).covers({21.9, 1.9}));
    EXPECT_FALSE(outline_of(line, false, Cap::round, Cap::flat).covers({20.1, 0.0}));
    const Shape pointed = outline_of(line, false, Cap::flat, Cap::pointed);
    EXPECT_TRUE(pointed.covers({20.0 + 4.0 * static_cast<double>(drawing::point_length) - 0.2, 0.0}));
    EXPECT_FALSE(pointed.covers({-0.1, 0.0}));
    const std::vector<PagePoint> dot(3, PagePoint{5, 5, 2});
    EXPECT_TRUE(outline_of(dot).covers({6.9, 5.0}));
    EXPECT_FALSE(outline_of(dot).covers({6.9, 6.9}));
    EXPECT_TRUE(outline_of(dot, false, Cap::flat, Cap::flat).loops.empty());
}

} // namespace
} // namespace hrbfnpr::testing::ribbon_test
