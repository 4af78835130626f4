// SPDX-License-Identifier: MIT
// Tests how marks along strokes become lines.
#include "frame/hand_made.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace hrbfnpr::testing::strokes_test {
namespace {

using drawing::Stroke;
using drawing::StrokePoint;
using frame::LayerStyle;

constexpr int size = 500; // 200 pixels per unit

LayerStyle as_strokes(marks::Kind kind, float radius = 1.5F) {
    LayerStyle style;
    style.kind = kind;
    style.contours = false;
    style.shape = frame::Shape::strokes;
    style.radius = radius;
    return style;
}

// Hatching is drawn as strokes, other layers are blank and have no contours.
const std::array<LayerStyle, 2> layers{as_strokes(marks::Kind::hatch), [] {
                                           LayerStyle blank;
                                           blank.share = 0.0F;
                                           blank.contours = false;
                                           return blank;
                                       }()};

frame::Style style_of(frame::HiddenLines hidden_lines) {
    frame::Style style;
    style.hidden_lines = hidden_lines;
    style.tone = frame::Tone::none;
    style.tone_curve = frame::ToneCurve::linear;
    style.tone_fade = 0.0F;
    style.layers = layers;
    return style;
}

// Adds marks from (from, y, z) along x, `step` apart.
void add_line(marks::PointSet& set, double from, double step, int count, double y = 0.0, double z = 0.0) {
    std::vector<glm::dvec3> places;
    for (int i = 0; i < count; ++i) places.emplace_back(from + step * i, y, z);
    add_stroke(set, marks::Kind::hatch, places, {0, 0, 1});
}

class Strokes : public ::testing::Test {
protected:
    const drawing::Drawing& draw(frame::HiddenLines hidden_lines = frame::HiddenLines::show, bool wall = false) {
        set = clustered(runtime, std::move(set));
        std::vector<frame::Item> items{layered_item(set, style_of(hidden_lines))};
        // A blank wall in front, [-0.3, 0.3] in x and y.
        glm::dmat4 smaller(0.3);
        smaller[3] = {0.0, 0.0, 2.0, 1.0};
        if (wall) items.push_back(layered_item(hidden_by, style_of(hidden_lines), smaller));
        frame.draw(items, front_camera(size, size));
        return frame.drawing();
    }
    [[nodiscard]] static std::span<const StrokePoint> points_of(const drawing::Drawing& drawing, const Stroke& stroke) {
        return drawing.points.span().subspan(static_cast<std::size_t>(stroke.first),
                                             static_cast<std::size_t>(stroke.count));
    }

    base::Runtime runtime;
    marks::PointSet set{runtime.memory};
    marks::PointSet hidden_by = clustered(runtime, plane(runtime.memory, 60));
    DrawnFrame frame{runtime};
};

TEST_F(Strokes, AStraightStrokeIsOneLineThroughAllItsMarks) {
    add_line(set, -1.0, 0.1, 21);
    set.spacing = 0.1;
    const drawing::Drawing& drawing = draw();
    ASSERT_EQ(drawing.strokes.size(), 1);
    const Stroke& stroke = drawing.strokes[0];
    EXPECT_EQ(stroke.first, 0);
    EXPECT_EQ(stroke.count, 21);
    EXPECT_EQ(drawing.points.size(), 21);
    EXPECT_EQ(drawing.dot_count, 0);
    EXPECT_TRUE(frame.discs().empty());
    EXPECT_EQ(drawing.counts.shown, 21);
    EXPECT_NEAR(stroke.depth, 10.0F, 1e-5F);
    ASSERT_LT(static_cast<std::int64_t>(stroke.layer), drawing.layers.size());
    EXPECT_TRUE(drawing.layers[stroke.layer].as_strokes);
    EXPECT_EQ(drawing.layers[stroke.layer].mark_class, drawing::MarkClass::front);
    for (int i = 0; i < 21; ++i) {
        const StrokePoint& p = drawing.points[i];
        EXPECT_EQ(p.id, static_cast<std::uint32_t>(i + 1));
        EXPECT_NEAR(p.x, 50.0F + 20.0F * static_cast<float>(i), 1e-3F);
        EXPECT_NEAR(p.y, 250.0F, 1e-3F);
        EXPECT_NEAR(p.length, 20.0F * static_cast<float>(i), 1e-2F);
        EXPECT_EQ(p.radius, 1.5F);
        EXPECT_EQ(p.opacity, 1.0F);
        EXPECT_NEAR(p.depth, 10.0F, 1e-5F);
        EXPECT_NEAR(p.pixels_per_unit, 200.0F, 1e-2F);
    }
}

// The order of the marks in the layer does not matter.
TEST_F(Strokes, MarksFollowTheOrderOfTheStroke) {
    marks::Layer& layer = layer_of(set, marks::Kind::hatch);
    for (std::uint32_t i = 0; i < 40; ++i) {
        const std::uint32_t place = 7 * i % 20; // along each of two strokes
        add_mark(layer, {-1.0 + 0.1 * place, i < 20 ? -0.5 : 0.5, 0.0}, {0, 0, 1}, {1, 0, 0}, i < 20 ? 4 : 2, place);
        set.bounds.extend({-1.0 + 0.1 * place, i < 20 ? -0.5 : 0.5, 0.0});
    }
    marks::index_strokes(layer);
    set.spacing = 0.1;
    const drawing::Drawing& drawing = draw();
    ASSERT_EQ(drawing.strokes.size(), 2);
    for (const Stroke& stroke : drawing.strokes) {
        ASSERT_EQ(stroke.count, 20);
        float before = -1.0F;
        for (const StrokePoint& p : points_of(drawing, stroke)) {
            EXPECT_NEAR(p.x, 50.0F + p.length, 1e-2F);
            EXPECT_GT(p.length, before);
            before = p.length;
        }
    }
}

TEST_F(Strokes, AStrokeHiddenInItsMiddleBecomesTwo) {
    add_line(set, -1.0, 0.025, 81);
    set.spacing = 0.025;
    const drawing::Drawing& drawing = draw(frame::HiddenLines::hide, true);
    ASSERT_EQ(drawing.strokes.size(), 2);
    EXPECT_EQ(drawing.dot_count, 0);
    EXPECT_EQ(drawing.counts.shown, drawing.points.size());
    EXPECT_EQ(drawing.counts.dropped_hidden, 81 - drawing.points.size());
    std::vector<std::uint32_t> ids;
    for (const Stroke& stroke : drawing.strokes) {
        EXPECT_GT(stroke.count, 20);
        const auto points = points_of(drawing, stroke);
        EXPECT_EQ(points[0].length, 0.0F);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_GT(std::abs(points[i].x - 250.0F), 60.0F);
            ids.push_back(points[i].id);
            if (i == 0) continue;
            EXPECT_EQ(points[i].id, points[i - 1].id + 1);
            EXPECT_GT(points[i].length, points[i - 1].length);
        }
    }
    EXPECT_NE(std::find(ids.begin(), ids.end(), 1U), ids.end());
    EXPECT_NE(std::find(ids.begin(), ids.end(), 81U), ids.end());
    EXPECT_EQ(std::find(ids.begin(), ids.end(), 41U), ids.end());
}

TEST_F(Strokes, SingleMarksStayDots) {
    add_line(set, 0.9, 0.1, 1);        // alone
    add_line(set, -0.8, 0.8, 3, 0.1);  // hidden in the middle
    add_line(set, -1.0, 0.1, 21, 1.0); // a line
    set.spacing = 0.1;
    const drawing::Drawing& drawing = draw(frame::HiddenLines::hide, true);
    ASSERT_EQ(drawing.strokes.size(), 1);
    EXPECT_EQ(drawing.strokes[0].count, 21);
    EXPECT_EQ(drawing.dot_count, 3);
    ASSERT_EQ(frame.discs().size(), 3U);
    std::vector<std::uint32_t> ids;
    for (const Disc& disc : frame.discs()) ids.push_back(disc.id);
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(ids, (std::vector<std::uint32_t>{1, 2, 4}));
    EXPECT_EQ(drawing.counts.shown, 24);
}

TEST_F(Strokes, AreOrderedFarToNearByTheirMiddles) {
    for (int s = 0; s < 50; ++s) {
        const auto u = base::uniform4(3, static_cast<std::uint64_t>(s), base::Purpose::candidate);
        std::vector<glm::dvec3> places;
        for (int i = 0; i < 5; ++i)
            places.emplace_back(0.2 * i - 0.4, 2.0 * u[0] - 1.0, 2.0 * u[1] - 1.0 + 0.1 * (u[2] - 0.5) * i);
        add_stroke(set, marks::Kind::hatch, places, {0, 0, 1});
    }
    set.spacing = 0.2;
    const drawing::Drawing& drawing = draw();
    ASSERT_EQ(drawing.strokes.size(), 50);
    std::int64_t first = 0;
    float before = 1e9F;
    for (const Stroke& stroke : drawing.strokes) {
        EXPECT_EQ(stroke.first, first); // one after the other
        first += stroke.count;
        EXPECT_LE(stroke.depth, before);
        before = stroke.depth;
        EXPECT_EQ(stroke.depth, points_of(drawing, stroke)[2].depth);
    }
    EXPECT_EQ(first, drawing.points.size());
}

TEST_F(Strokes, CanBeDrawnAsDots) {
    add_line(set, -1.0, 0.1, 21);
    set.spacing = 0.1;
    set = clustered(runtime, std::move(set));
    frame::Style style = style_of(frame::HiddenLines::show);
    LayerStyle dots = layers[0];
    dots.shape = frame::Shape::dots;
    style.layers = std::span(&dots, 1);
    const std::array items{layered_item(set, style)};
    frame.draw(items, front_camera(size, size));
    EXPECT_TRUE(frame.drawing().strokes.empty());
    EXPECT_EQ(frame.drawing().dot_count, 21);
    // The same holds again after lines were drawn.
    (void)draw();
    frame.draw(items, front_camera(size, size));
    EXPECT_TRUE(frame.drawing().strokes.empty());
    EXPECT_EQ(frame.discs().size(), 21U);
}

// Segments are in the tiles that they touch, and none joins two strokes.
TEST_F(Strokes, SegmentsAreInTheTilesThatTheyTouch) {
    add_line(set, -1.0, 0.1, 21, 0.5);
    add_line(set, -1.0, 0.1, 21, -0.5);
    set.spacing = 0.1;
    const drawing::Drawing& drawing = draw();
    ASSERT_EQ(drawing.strokes.size(), 2);
    std::vector<int> met(static_cast<std::size_t>(drawing.points.size()), 0);
    for (std::int64_t tile = 0; tile < drawing.segment_tiles.tiles(); ++tile) {
        const std::int64_t row = tile / drawing.segment_tiles.columns();
        drawing.segment_tiles.for_tile(tile, [&](std::uint32_t i) {
            ++met[i];
            const auto y = static_cast<std::int64_t>(drawing.points[i].y);
            EXPECT_LE(std::abs(y - (64 * row + 32)), 32 + 16) << i;
        });
    }
    for (std::size_t i = 0; i < met.size(); ++i) EXPECT_EQ(met[i] > 0, i != 20 && i != 41) << i;
}

} // namespace
} // namespace hrbfnpr::testing::strokes_test
