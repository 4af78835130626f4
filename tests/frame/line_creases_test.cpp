// SPDX-License-Identifier: MIT
// Tests creases of items as strokes.
#include "frame/hand_made.h"
#include "support/runtime.h"
#include "support/sharp_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace hrbfnpr::testing::line_creases_test {
namespace {

using drawing::Stroke;
using drawing::StrokePoint;
using frame::HiddenParts;
using frame::LineKind;
using frame::LineStyle;

constexpr int size = 500;

LineStyle style_of(LineKind kind, float width) {
    LineStyle style;
    style.kind = kind;
    style.width = width;
    return style;
}

class LineCreases : public ::testing::Test {
protected:
    void look_at(const test::SharpShape& shape, const glm::dvec3& direction) {
        look_through(shape, frame::fit_bounds(shape.bounds(), direction, {0, 0, 1}, 0.5, size, size, 0.05, {}));
    }
    void look_through(const test::SharpShape& shape, const frame::Camera& camera) {
        curves::LineSetSettings settings;
        settings.side = 0.1;
        lines_ = std::make_unique<curves::LineSet>(runtime, shape, std::make_unique<implicit::DifferencedShape>(shape),
                                                   settings);
        camera_ = camera;
    }
    [[nodiscard]] glm::dvec2 window_of(const glm::dvec3& place) const {
        const glm::dvec4 clip = camera_.projection * camera_.view * glm::dvec4(place, 1.0);
        return {0.5 * size * (1.0 + clip.x / clip.w), 0.5 * size * (1.0 - clip.y / clip.w)};
    }
    // Expects that all strokes are on the outline of the cube's face x = 1 (in its own coordinates), and that all of it
    // is drawn.
    void expect_face_alone(const glm::dmat3& to_world) {
        std::array<glm::dvec2, 4> corner;
        for (std::size_t k = 0; k < 4; ++k)
            corner[k] = window_of(to_world * glm::dvec3(1.0, k == 1 || k == 2 ? 1.0 : -1.0, k < 2 ? -1.0 : 1.0));
        std::array<std::array<int, 50>, 4> drawn{};
        for (const Stroke& stroke : frame.drawing().strokes) {
            const std::span<const StrokePoint> points = points_of(stroke);
            for (std::size_t i = 0; i < points.size(); ++i)
                for (std::size_t k = 0; k < 4; ++k) put(points, i, corner[k], corner[(k + 1) % 4], drawn[k]);
            for (const StrokePoint& p : points) {
                double off = 1e9;
                for (std::size_t k = 0; k < 4; ++k)
                    off = std::min(off, distance(glm::dvec2(p.x, p.y), corner[k], corner[(k + 1) % 4]));
                EXPECT_LE(off, 0.1) << p.x << ' ' << p.y;
            }
        }
        for (const auto& edge : drawn)
            for (const int count : edge) EXPECT_GE(count, 1);
        EXPECT_EQ(frame.drawing().line_counts.settled + frame.drawing().line_counts.contradictions, 0);
    }
    static double distance(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
        const double share = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
        return glm::distance(p, a + share * (b - a));
    }
    // Counts which fiftieths of the line from a to b are passed by the piece that ends at point i.
    static void put(std::span<const StrokePoint> points, std::size_t i, const glm::dvec2& a, const glm::dvec2& b,
                    std::array<int, 50>& drawn, double off = 0.1) {
        if (i == 0) return;
        const glm::dvec2 p(points[i - 1].x, points[i - 1].y);
        const glm::dvec2 q(points[i].x, points[i].y);
        if (distance(p, a, b) > off || distance(q, a, b) > off) return;
        const double square = glm::dot(b - a, b - a);
        const double from = glm::dot(p - a, b - a) / square;
        const double to = glm::dot(q - a, b - a) / square;
        for (std::size_t k = 0; k < drawn.size(); ++k) {
            const double at = (static_cast<double>(k) + 0.5) / static_cast<double>(drawn.size());
            drawn[k] += at >= std::min(from, to) && at <= std::max(from, to) ? 1 : 0;
        }
    }
    const drawing::Drawing& draw() {
        frame::Item item = layered_item(set, frame::Style(), glm::dmat4(1.0));
        item.style.hidden_lines = frame::HiddenLines::show;
        item.style.tone = frame::Tone::none;
        item.style.layers = blank;
        item.style.lines = styles;
        item.style.halo_width = 0.0F;
        item.lines = lines_.get();
        frame.draw(std::span(&item, 1), camera_);
        return frame.drawing();
    }
    [[nodiscard]] std::vector<Stroke> strokes_of(LineKind kind) const {
        std::vector<Stroke> found;
        for (const Stroke& stroke : frame.drawing().strokes)
            if (frame.drawing().layers[stroke.layer].line_kind == static_cast<std::uint32_t>(kind))
                found.push_back(stroke);
        return found;
    }
    [[nodiscard]] std::span<const StrokePoint> points_of(const Stroke& stroke) const {
        return frame.drawing().points.span().subspan(static_cast<std::size_t>(stroke.first),
                                                     static_cast<std::size_t>(stroke.count));
    }
    [[nodiscard]] bool has_layer(LineKind kind) const {
        const auto& layers = frame.drawing().layers;
        return std::any_of(layers.begin(), layers.end(), [&](const drawing::Layer& layer) {
            return layer.line_kind == static_cast<std::uint32_t>(kind);
        });
    }

    base::Runtime runtime = test::with_threads(2);
    std::array<frame::LayerStyle, 1> blank{[] {
        frame::LayerStyle style;
        style.share = 0.0F;
        return style;
    }()};
    marks::PointSet set = clustered(runtime, sphere(runtime.memory, 200));
    std::vector<LineStyle> styles{style_of(LineKind::contour, 3.0F), style_of(LineKind::crease, 1.0F)};
    DrawnFrame frame{runtime};

private:
    std::unique_ptr<curves::LineSet> lines_;
    frame::Camera camera_;
};

// Six edges bound the cube in the image, three are inside. No line narrows where it meets others.
TEST_F(LineCreases, BoundingEdgesOfACubeAreContours) {
    const auto cube = test::sharp_cube(glm::dmat3(1.0));
    look_at(*cube, {-0.8, 1.0, -0.6});
    styles[0].outline_factor = 2.0F;
    draw();
    EXPECT_EQ(strokes_of(LineKind::contour).size(), 6U);
    EXPECT_EQ(strokes_of(LineKind::crease).size(), 3U);
    for (const Stroke& stroke : strokes_of(LineKind::contour))
        for (const StrokePoint& p : points_of(stroke)) EXPECT_NEAR(p.radius, 3.0F, 1e-4F);
    for (const Stroke& stroke : strokes_of(LineKind::crease))
        for (const StrokePoint& p : points_of(stroke)) {
            EXPECT_NEAR(p.radius, 0.5F, 1e-4F);
            EXPECT_EQ(p.opacity, 1.0F);
        }
    EXPECT_EQ(frame.drawing().line_counts.broken + frame.drawing().line_counts.contradictions, 0);
    // Each end of a line is at the end of another line.
    std::vector<glm::vec2> ends;
    for (const Stroke& stroke : frame.drawing().strokes)
        for (const StrokePoint& p : {points_of(stroke).front(), points_of(stroke).back()}) ends.emplace_back(p.x, p.y);
    for (const glm::vec2& end : ends)
        EXPECT_GE(std::count_if(ends.begin(), ends.end(),
                                [&](const glm::vec2& other) { return glm::distance(end, other) < 0.01F; }),
                  2);
}

// The camera looks along an axis, so four faces of the cube are seen edge-on.
TEST_F(LineCreases, EdgesOfFacesSeenEdgeOnAreDrawn) {
    for (const glm::dmat3& turn : {glm::dmat3(1.0), test::odd_turn()}) {
        const auto cube = test::sharp_cube(turn);
        const glm::dmat3 to_world = glm::transpose(turn);
        const glm::dvec3 up = to_world * glm::dvec3(0.0, 0.0, 1.0);
        frame::Camera camera;
        camera.viewport = {0.0, 0.0, size, size};
        camera.view = frame::look_at(to_world * glm::dvec3(8.0, 0.0, 0.0), glm::dvec3(0.0), up);
        camera.projection = frame::orthographic(3.0, size, size, 1.0, 20.0, {});
        look_through(*cube, camera);
        draw();
        expect_face_alone(to_world);
        EXPECT_EQ(frame.drawing().strokes.size(), 4);
        // In perspective the eye is in the plane of the upper face.
        camera.view = frame::look_at(to_world * glm::dvec3(8.0, 0.3, 1.0), to_world * glm::dvec3(0.0, 0.3, 1.0), up);
        camera.projection = frame::perspective(0.6, size, size, 1.0, 20.0, {});
        look_through(*cube, camera);
        draw();
        expect_face_alone(to_world);
    }
}

TEST_F(LineCreases, AllEdgesAreCreasesWithoutContours) {
    const auto cube = test::sharp_cube(glm::dmat3(1.0));
    look_at(*cube, {-0.8, 1.0, -0.6});
    styles.erase(styles.begin());
    draw();
    EXPECT_EQ(strokes_of(LineKind::crease).size(), 9U);
    styles[0].hidden = HiddenParts::shown;
    draw();
    EXPECT_EQ(strokes_of(LineKind::crease).size(), 12U);
}

TEST_F(LineCreases, CanBeLimitedToConvexOrConcave) {
    const auto shaft = test::stepped_shaft();
    look_at(*shaft, {-0.5, 0.9, -0.7});
    const auto length_of = [&] {
        float sum = 0.0F;
        for (const Stroke& stroke : strokes_of(LineKind::crease)) sum += points_of(stroke).back().length;
        return sum;
    };
    draw();
    const float all = length_of();
    styles[1].creases = curves::CreaseSide::convex;
    draw();
    const float convex = length_of();
    styles[1].creases = curves::CreaseSide::concave;
    draw();
    const float concave = length_of();
    EXPECT_GT(concave, 50.0F);
    EXPECT_GT(convex, 100.0F);
    EXPECT_NEAR(convex + concave, all, 1e-3F * all);
}

// The crease fades from 30 degrees, where it is opaque, to 15.
TEST_F(LineCreases, FadeWithTheirAngle) {
    const auto wedge = test::fading_wedge();
    look_at(*wedge, {0.1, 0.2, -1.0});
    styles = {style_of(LineKind::crease, 1.0F)};
    draw();
    float least = 1.0F;
    float most = 0.0F;
    for (const Stroke& stroke : strokes_of(LineKind::crease))
        for (const StrokePoint& p : points_of(stroke)) {
            least = std::min(least, p.opacity);
            most = std::max(most, p.opacity);
        }
    EXPECT_LT(least, 0.01F);
    EXPECT_EQ(most, 1.0F);
}

// Where a crease is part of the contour, only sharp enough parts have strokes. Invisible parts have none, since a
// plotter draws every stroke.
TEST_F(LineCreases, WeakPartsOfTheContourHaveNoStrokes) {
    const auto wedge = test::fading_wedge();
    look_at(*wedge, {-1.0, 0.0, -0.24});
    styles = {style_of(LineKind::crease, 1.0F)};
    const auto length_of = [&](double least) {
        styles[0].lower = styles[0].upper = least;
        draw();
        float sum = 0.0F;
        for (const Stroke& stroke : strokes_of(LineKind::crease)) {
            for (const StrokePoint& p : points_of(stroke)) EXPECT_EQ(p.opacity, 1.0F);
            sum += points_of(stroke).back().length;
        }
        return sum;
    };
    const float all = length_of(15.0);
    const float some = length_of(89.0);
    EXPECT_GT(some, 0.1F * all);
    EXPECT_LT(some, 0.9F * all);
    EXPECT_EQ(length_of(170.0), 0.0F);
    EXPECT_TRUE(strokes_of(LineKind::crease).empty());
}

// The crease is part of the contour where it is sharper than 27 degrees. From there it continues to 15 degrees.
TEST_F(LineCreases, ContinueWhereTheyStopBeingContours) {
    const auto wedge = test::fading_wedge();
    look_at(*wedge, {-1.0, 0.0, -0.24});
    draw();
    float fading = 0.0F;
    for (const Stroke& stroke : strokes_of(LineKind::crease)) {
        const std::span<const StrokePoint> points = points_of(stroke);
        for (std::size_t i = 1; i < points.size(); ++i)
            if (points[i].opacity > 0.02F && points[i].opacity < 0.9F)
                fading += points[i].length - points[i - 1].length;
    }
    EXPECT_GT(fading, 15.0F);
}

// The contour ends there. If the continuing crease is drawn, the contour keeps its whole width. If the crease is too
// weak and the sheet's own contour turns back, hidden behind it, the contour has a taper, like at a cusp. From the
// other side the sheet's contour continues.
TEST_F(LineCreases, ContoursNarrowWhereAWeakCreaseGoesOn) {
    const auto wedge = test::fading_wedge();
    struct Case {
        double slope, y; // line of sight: slopes of 0.16 and 0.26 are creases of 18 and 29 degrees
        float radius;
    };
    for (const auto [slope, y, expected] : {Case{0.26, 0.3, 1.5F}, {0.16, 0.3, 0.0F}, {0.16, -0.3, 1.5F}}) {
        look_at(*wedge, {-1.0, y, -slope});
        styles[0].taper = 10.0F;
        draw();
        const glm::dvec2 end = window_of({0.0, -1.0 - std::log(2.0 * slope) / 3.0, 0.0});
        float radius = -1.0F; // radius of the end there
        float whole = 0.0F;
        for (const Stroke& stroke : strokes_of(LineKind::contour)) {
            const std::span<const StrokePoint> points = points_of(stroke);
            for (const StrokePoint& p : {points.front(), points.back()}) {
                if (glm::distance(glm::dvec2(p.x, p.y), end) > 1.0) continue;
                radius = std::max(radius, p.radius);
                for (const StrokePoint& q : points) whole = std::max(whole, q.radius);
            }
        }
        EXPECT_EQ(whole, 1.5F) << slope;
        EXPECT_EQ(radius, expected) << slope << ' ' << y;
    }
}

// The top is seen nearly edge-on, and is wavy by a fifth of a pixel, which hides parts of its far edge. The contours of
// the waves are short and narrow at both ends, and draw nothing of the outline.
TEST_F(LineCreases, EdgesOfANearlyFlatFaceAreWhole) {
    const auto top = [](const glm::dvec3& p) {
        const double at = 60.0 * p.x + 30.0 * p.y;
        const double high = 1e-3 * std::sin(at);
        const double slope = 1e-3 * std::cos(at);
        return test::Field{p.z - high,
                           {-60.0 * slope, -30.0 * slope, 1.0},
                           {3600.0 * high, 1800.0 * high, 0.0, 900.0 * high, 0.0, 0.0}};
    };
    std::vector<test::Sharp> all = test::sides(glm::dvec3(0.8));
    all[4] = test::FieldFunction(top);
    const test::SharpShape shape(test::cube(1.0), test::max_of(std::move(all)));
    styles[0].taper = 15.0F;
    for (const double slope : {0.012, 0.014, 0.016}) {
        look_at(shape, {0.0, 1.0, -slope});
        draw();
        std::array<int, 50> drawn{};
        for (const Stroke& stroke : strokes_of(LineKind::contour)) {
            std::vector<StrokePoint> wide;
            for (const StrokePoint& p : points_of(stroke)) {
                if (stroke.hidden_layers > 0 || p.radius < 1.2F) {
                    wide.clear();
                    continue;
                }
                wide.push_back(p);
                put(wide, wide.size() - 1, window_of({-0.79, 0.8, 0.0}), window_of({0.79, 0.8, 0.0}), drawn, 0.5);
            }
        }
        for (const int count : drawn) EXPECT_GE(count, 1) << slope;
    }
}

TEST_F(LineCreases, SmoothItemsHaveNoCreaseLayer) {
    const test::SquareSphere ball;
    curves::LineSetSettings settings;
    settings.side = 0.1;
    const curves::LineSet smooth(runtime, ball, std::make_unique<implicit::DifferencedShape>(ball), settings);
    const auto cube = test::sharp_cube(glm::dmat3(1.0));
    look_at(*cube, {-0.8, 1.0, -0.6});
    draw();
    EXPECT_TRUE(has_layer(LineKind::crease));
    frame::Item item = layered_item(set, frame::Style(), glm::dmat4(1.0));
    item.style.layers = blank;
    item.style.lines = styles;
    item.lines = &smooth;
    frame.draw(std::span(&item, 1), front_camera(size, size));
    EXPECT_FALSE(has_layer(LineKind::crease));
}

// The second drawing starts from the contours of the first, sheet by sheet.
TEST_F(LineCreases, AreStableFromFrameToFrame) {
    const auto cone = test::capped_cone();
    for (int i = 0; i < 6; ++i) {
        const double angle = 0.01 * i;
        const glm::dvec3 direction(-0.8 * std::cos(angle), std::sin(angle) + 0.3, -0.4);
        if (i == 0) look_at(*cone, direction);
        draw();
        const std::size_t contours = strokes_of(LineKind::contour).size();
        EXPECT_EQ(contours, 4U) << "two sides, parts of two rims";
        EXPECT_EQ(frame.drawing().line_counts.broken + frame.drawing().line_counts.contradictions, 0);
    }
}

} // namespace
} // namespace hrbfnpr::testing::line_creases_test
