// SPDX-License-Identifier: MIT
// Tests where and how lines of hatching end.
#include "frame/hatching.h"
#include "support/sharp_shapes.h"

namespace hrbfnpr::testing::hatch_ends_test {
namespace {

TEST_F(Hatch, ALineEndsWhereItsToneEnds) {
    for (const double y : {-0.1, 0.0, 0.1}) add_line(set, {y, -1.0, 1.0, 0}, 0.05);
    set_nesting(set, 0.1, 0);
    cluster();
    for (const double at : {-0.31, -0.123, 0.0, 0.2345, 0.4}) {
        darkness = [=](const glm::dvec3& p) { return 0.15 + 0.6 * (at - p.x); };
        draw(front_camera(size, size, 1.25)); // 200 pixels per unit
        ASSERT_EQ(frame.drawing().strokes.size(), 3);
        for (std::int64_t s = 0; s < 3; ++s) {
            const StrokePoint& end = points_of(s).back();
            EXPECT_NEAR(end.x, 250.0 + 200.0 * at, 0.1) << at;
            EXPECT_EQ(end.radius, 0.0F);
        }
    }
}

// The tone bends between two pixels, and the result does not depend on the number of marks.
TEST_F(Hatch, EndsAreFoundToATenthOfAPixel) {
    double worst = 0.0;
    for (const double apart : {0.0005, 0.001, 0.002}) { // 0.1 to 0.4 pixels
        set = marks::PointSet(runtime.memory);
        add_line(set, {0.0, -1.0, 1.0, 0}, apart);
        set_nesting(set, 0.1, 0);
        cluster();
        for (int i = 0; i < 20; ++i) {
            const double at = -0.4 + 0.04123 * i;
            darkness = [=](const glm::dvec3& p) {
                const double d = at - p.x;
                return 0.15 + 2.0 * d + 0.016 * (1.0 - std::cos(100.0 * d));
            };
            draw(front_camera(size, size, 1.25)); // 200 pixels per unit
            ASSERT_EQ(frame.drawing().strokes.size(), 1);
            worst = std::max(worst, std::abs(static_cast<double>(points_of(0).back().x) - 250.0 - 200.0 * at));
        }
    }
    EXPECT_LE(worst, 0.1);
    RecordProperty("worst", std::to_string(worst));
}

// The lines go around the equator of a ball, seen from the side, and end just before the contour.
TEST_F(Hatch, EndsAtTheContourAreFoundToATenthOfAPixel) {
    for (const int marks : {200, 1000, 5000}) {
        set = marks::PointSet(runtime.memory);
        add_circle(set, 1.0, 0.0, {1, 0, 0}, marks);
        set_nesting(set, 0.1, 0);
        cluster();
        frame::Camera camera = front_camera(size, size, 1.25);
        camera.view = frame::look_at({0.0, -10.0, 0.0}, glm::dvec3(0.0), {0, 0, 1});
        draw(camera);
        ASSERT_EQ(frame.drawing().strokes.size(), 1);
        const double reach = 200.0 * std::sqrt(1.0 - 0.03 * 0.03);
        EXPECT_NEAR(std::abs(points_of(0).front().x - 250.0F), reach, 0.1) << marks;
        EXPECT_NEAR(std::abs(points_of(0).back().x - 250.0F), reach, 0.1) << marks;
    }
}

// A line of a level that fades in begins where the law says, and has the law's width.
TEST_F(Hatch, ALevelThatFadesInBeginsWhereTheLawPredicts) {
    constexpr double separation = 0.02;
    constexpr auto coarse = static_cast<float>(2.0 * separation * 200.0); // pixels
    add_line(set, {0.0, -1.0, 1.0, 1}, 0.002);
    set_nesting(set, separation, 1);
    cluster();
    layer.hatch_spacing = 0.5F;
    layer.hatch_white = 0.0F;
    layer.hatch_tone_begin = 0.0F;
    const auto widths_at = [&](double x) {
        const auto dark = static_cast<float>(darkness({x, 0.0, 0.0}));
        return law::hatch_widths(layer, law::hatch_coverage(layer, dark), coarse, 1);
    };
    for (const double rise : {0.2, 0.5, 1.0}) {
        darkness = [=](const glm::dvec3& p) { return 0.1 + rise * 0.25 * (1.0 - p.x) * (1.0 - p.x); };
        double low = -1.0; // drawn
        double high = 1.0;
        ASSERT_GT(law::level_margin(widths_at(low), 1), 0.0F);
        while (high - low > 1e-6) {
            const double middle = 0.5 * (low + high);
            (law::level_margin(widths_at(middle), 1) >= 0.0F ? low : high) = middle;
        }
        draw(front_camera(size, size, 1.25));
        ASSERT_EQ(frame.drawing().strokes.size(), 1);
        EXPECT_NEAR(points_of(0).back().x, 250.0 + 200.0 * low, 0.1) << rise;
        for (double x = -0.9; x < low - 0.05; x += 0.1)
            EXPECT_NEAR(radius_at(points_of(0), 250.0 + 200.0 * x),
                        0.5 * static_cast<double>(law::hatch_width(widths_at(x), 1)), 0.008)
                << rise << " " << x;
    }
}

TEST_F(Hatch, LinesNarrowTowardTheirEnds) {
    add_line(set, {0.0, -1.0, 1.0, 0}, 0.02);
    set_nesting(set, 0.02, 0);
    cluster();
    darkness = [](const glm::dvec3& p) { return p.x < 0.5 ? 0.8 : 0.0; };
    layer.hatch_coverage_begin = layer.hatch_coverage_end = 0.6F;
    draw(front_camera(size, size, 1.25));
    ASSERT_EQ(frame.drawing().strokes.size(), 1);
    const auto points = points_of(0);
    const double end = points.back().x;
    EXPECT_EQ(points.front().radius, 0.0F);
    EXPECT_NEAR(points.front().x, 50.0, 0.01);
    const double middle = radius_at(points, 200.0);
    EXPECT_NEAR(middle, 0.5 * 0.6 * 4.0, 1e-3); // half the share of a period of 4 pixels
    for (const double away : {2.5, 7.5, 15.0})
        EXPECT_NEAR(radius_at(points, end - away), middle * std::sqrt(away / 20.0), 0.03 * middle) << away;
    // At the end of its stroke a line narrows over 7 pixels times the share of white, which is 0.4.
    for (const double away : {1.25, 2.0, 2.5})
        EXPECT_NEAR(radius_at(points, 50.0 + away), middle * std::sqrt(away / 2.8), 0.05 * middle) << away;
    EXPECT_NEAR(radius_at(points, 56.0), middle, 1e-3);
}

// The face z = 0 is dark up to its edge at x = 0.5. Lines narrow to their ends, except at the edge.
TEST_F(Hatch, LinesNarrowExceptAtCreases) {
    const test::SharpShape shape(geometry::Bounds{glm::dvec3(-1.0), glm::dvec3(1.0)},
                                 test::max_of({test::plane({0, 0, 1}, 0.0), test::plane({1, 0, 0}, 0.5)}));
    curves::LineSetSettings settings;
    settings.side = 0.1;
    const curves::LineSet lines(runtime, shape, std::make_unique<implicit::DifferencedShape>(shape), settings);
    add_line(set, {0.1, -0.5, 0.5, 0}, 0.02);
    add_line(set, {-0.1, -0.5, 0.3, 0}, 0.02);
    set_nesting(set, 0.02, 0);
    cluster();
    layer.hatch_coverage_begin = layer.hatch_coverage_end = 0.3F; // tapers of 7 x 0.7 pixels
    style.layers = std::span(&layer, 1);
    std::array items{layered_item(set, style)};
    items[0].lines = &lines;
    frame.draw(items, front_camera(size, size, 1.25)); // 200 pixels per unit
    ASSERT_EQ(frame.drawing().strokes.size(), 2);
    for (std::int64_t s = 0; s < 2; ++s) {
        const auto points = points_of(s);
        const bool at_crease = points.front().y < 250.0F;
        const double end = at_crease ? 350.0 : 310.0;
        EXPECT_NEAR(points.back().x, end, 0.01);
        EXPECT_EQ(points.back().radius, 0.0F);
        const double middle = radius_at(points, 200.0);
        EXPECT_NEAR(radius_at(points, end - 3.0), middle * (at_crease ? 1.0 : std::sqrt(3.0 / 4.9)), 0.05 * middle);
        EXPECT_NEAR(radius_at(points, 153.0), middle * std::sqrt(3.0 / 4.9),
                    0.05 * middle); // near where both lines begin
    }
}

// A line of 8 pixels that crosses a narrow face from crease to crease is drawn. One of 4 pixels from a crease is not.
TEST_F(Hatch, ShortLinesAreDrawnAcrossNarrowFaces) {
    const test::SharpShape shape(
        geometry::Bounds{glm::dvec3(-1.0), glm::dvec3(1.0)},
        test::max_of({test::plane({0, 0, 1}, 0.0), test::plane({1, 0, 0}, 0.02), test::plane({-1, 0, 0}, 0.02)}));
    curves::LineSetSettings settings;
    settings.side = 0.02;
    const curves::LineSet lines(runtime, shape, std::make_unique<implicit::DifferencedShape>(shape), settings);
    add_line(set, {0.1, -0.02, 0.02, 0}, 0.004);
    add_line(set, {-0.1, -0.02, 0.0, 0}, 0.004);
    set_nesting(set, 0.02, 0);
    cluster();
    layer.hatch_shortest = 10.0F;
    style.layers = std::span(&layer, 1);
    std::array items{layered_item(set, style)};
    items[0].lines = &lines;
    frame.draw(items, front_camera(size, size, 1.25)); // 200 pixels per unit
    ASSERT_EQ(frame.drawing().strokes.size(), 1);
    EXPECT_LT(points_of(0).front().y, 250.0F);
}

TEST_F(Hatch, ShortPiecesAreLeftOutAndGrowFromNothing) {
    add_line(set, {0.0, -1.0, 1.0, 0}, 0.005);
    set_nesting(set, 0.02, 0);
    cluster();
    double before = 0.0;
    bool seen = false;
    for (double length = 4.0; length < 30.0; length += 0.25) { // pixels, 200 per unit
        darkness = [=](const glm::dvec3& p) { return 0.15 + 2.0 * (0.5 * length / 200.0 - std::abs(p.x)); };
        draw(front_camera(size, size, 1.25));
        float widest = 0.0F;
        for (const StrokePoint& p : frame.drawing().points) widest = std::max(widest, p.radius);
        if (length < 9.8) {
            EXPECT_TRUE(frame.drawing().strokes.empty()) << length;
        } else if (length > 13.5) { // the tone fades in over more than a pixel on either side
            EXPECT_EQ(frame.drawing().strokes.size(), 1) << length;
        }
        EXPECT_NEAR(widest, before, 0.05) << length;
        before = widest;
        seen = seen || widest > 0.12F;
    }
    EXPECT_TRUE(seen);
}

TEST_F(Hatch, NarrowGapsAreClosed) {
    add_line(set, {0.0, -1.0, 1.0, 0}, 0.0025);
    set_nesting(set, 0.02, 0);
    cluster();
    std::int64_t before = 1;
    for (double gap = 0.0; gap < 12.0; gap += 0.5) { // pixels
        darkness = [=](const glm::dvec3& p) { return 0.15 + 4.0 * (std::abs(p.x) - 0.5 * gap / 200.0); };
        draw(front_camera(size, size, 1.25));
        const std::int64_t now = frame.drawing().strokes.size();
        EXPECT_EQ(now, gap < 0.7 ? 1 : gap > 2.0 ? 2 : now) << gap; // lines are 0.4 to 2.8 pixels wide
        EXPECT_GE(now, before);
        before = now;
    }
    EXPECT_EQ(before, 2);
}

class HatchCircle : public Hatch, public ::testing::WithParamInterface<bool> {};
INSTANTIATE_TEST_SUITE_P(WithAndWithoutItsFirstMarkTwice, HatchCircle, ::testing::Bool());

TEST_P(HatchCircle, HasNoEnds) {
    add_circle(set, 0.8, 0.0, {0, 0, 1}, 40, GetParam());
    set_nesting(set, 0.03, 0);
    cluster();
    draw(front_camera(size, size, 1.25));
    ASSERT_EQ(frame.drawing().strokes.size(), 1);
    EXPECT_TRUE(frame.drawing().strokes[0].closed);
    const auto points = points_of(0);
    EXPECT_EQ(points.front().x, points.back().x);
    EXPECT_EQ(points.front().y, points.back().y);
    for (const StrokePoint& p : points) {
        EXPECT_NEAR(p.radius, points.front().radius, 0.01F); // the line has no tip
        EXPECT_NEAR(std::hypot(p.x - 250.0F, p.y - 250.0F), 160.0F, 0.05F) << "a curve, not its chords";
    }
    // The right half is dark, with the first mark in the middle: one line passes it.
    darkness = [](const glm::dvec3& p) { return p.x > 0.0 ? 0.7 : 0.0; };
    draw(front_camera(size, size, 1.25));
    ASSERT_EQ(frame.drawing().strokes.size(), 1);
    EXPECT_FALSE(frame.drawing().strokes[0].closed);
    EXPECT_NEAR(points_of(0).back().length, 160.0 * pi, 15.0);
    // Marks are 25 pixels apart.
    for (const StrokePoint& p : points_of(0)) EXPECT_GT(p.x, 250.0F - 25.0F);
}

TEST_P(HatchCircle, HasTwoEndsIfPartlyHidden) {
    add_circle(set, 0.8, 0.0, {0, 0, 1}, 40, GetParam());
    set_nesting(set, 0.03, 0);
    cluster();
    const marks::PointSet wall = clustered(runtime, plane(runtime.memory, 100));
    glm::dmat4 left(1.0);
    left[3] = {-1.0, 0.0, 2.0, 1.0}; // the first mark is not behind the wall
    const drawing::Drawing& drawing = draw_behind(wall, left);
    ASSERT_EQ(drawing.strokes.size(), 1);
    EXPECT_FALSE(drawing.strokes[0].closed);
    EXPECT_EQ(points_of(0).front().radius, 0.0F);
    EXPECT_EQ(points_of(0).back().radius, 0.0F);
    EXPECT_NEAR(points_of(0).back().length, 160.0 * pi, 18.0); // splats extend beyond the wall
    for (const StrokePoint& p : points_of(0)) EXPECT_GT(p.x, 240.0F);
}

TEST_F(Hatch, WideLinesCrossNarrowHiddenParts) {
    add_line(set, {0.0, -1.0, 1.0, 0}, 0.02);
    set.spacing = 0.02;
    cluster();
    const marks::PointSet wall = clustered(runtime, plane(runtime.memory, 60));
    glm::dmat4 narrow(1.0);
    narrow[0][0] = 0.02; // 8 pixels
    narrow[3] = {0.0, 0.0, 2.0, 1.0};
    layer.radius = 2.0F;
    EXPECT_EQ(draw_behind(wall, narrow).strokes.size(), 2);
    layer.radius = 7.0F;
    EXPECT_EQ(draw_behind(wall, narrow).strokes.size(), 1);
    for (const StrokePoint& p : points_of(0)) EXPECT_EQ(p.opacity, 1.0F);
}

// Where a contour ends, a line is hidden over the length of a halo. Lines continue across hidden parts of at most this
// length; across parts up to half as long again they become thinner.
TEST_F(Hatch, LinesCrossHiddenPartsAsShortAsAHalo) {
    add_line(set, {0.0, -1.0, 1.0, 0}, 0.005);
    set.spacing = 0.02;
    layer.radius = 0.5F;
    cluster();
    const marks::PointSet wall = clustered(runtime, plane(runtime.memory, 60));
    glm::dmat4 narrow(1.0);
    narrow[0][0] = 0.02; // 8 pixels
    narrow[3] = {0.0, 0.0, 2.0, 1.0};
    ASSERT_EQ(draw_behind(wall, narrow).strokes.size(), 2);
    const double from = static_cast<double>(points_of(0).back().x);
    const double gap = static_cast<double>(points_of(1).front().x) - from;
    ASSERT_GT(gap, 6.0);
    EXPECT_EQ(draw_behind(wall, narrow, gap / 1.6).strokes.size(), 2);
    for (const auto& [halos, share] : {std::pair{0.9, 1.0}, {1.1, 0.8}, {1.25, 0.5}, {1.4, 0.2}}) {
        ASSERT_EQ(draw_behind(wall, narrow, gap / halos).strokes.size(), 1) << halos;
        const auto points = points_of(0);
        EXPECT_NEAR(radius_at(points, from + 0.5 * gap), share * radius_at(points, from - 20.0), 0.02) << halos;
        for (const StrokePoint& p : points) EXPECT_EQ(p.opacity, 1.0F);
    }
}

// A part between two hidden ones must be at least three times as long as other parts, and is narrower up to twice that
// length.
TEST_F(Hatch, ShortPartsBetweenHiddenPartsAreLeftOut) {
    add_line(set, {0.0, -1.0, 1.0, 0}, 0.005);
    set.spacing = 0.02;
    layer.radius = 0.5F;
    layer.hatch_shortest = 6.0F;
    cluster();
    marks::PointSet slotted(runtime.memory); // the slot has half the wall's width
    slotted.spacing = 2.0 / 60;
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 60; ++j)
            if (i < 15 || i >= 45)
                add_stipple(slotted, {(i + 0.5) / 30.0 - 1.0, (j + 0.5) / 30.0 - 1.0, 0.0}, {0.0, 0.0, 1.0});
    const marks::PointSet wall = clustered(runtime, std::move(slotted));
    const auto radius_in_slot = [&](double wide) { // pixels
        glm::dmat4 narrow(1.0);
        narrow[0][0] = 0.005 * wide;
        narrow[3] = {0.0, 0.0, 2.0, 1.0};
        double radius = 0.0;
        draw_behind(wall, narrow);
        EXPECT_GE(frame.drawing().strokes.size(), 2);
        if (frame.drawing().strokes.size() == 3)
            for (const StrokePoint& p : points_of(1)) radius = std::max(radius, static_cast<double>(p.radius));
        return radius;
    };
    const double whole = radius_in_slot(40.0);
    EXPECT_GT(whole, 0.2);
    EXPECT_EQ(radius_in_slot(16.0), 0.0);
    const double some = radius_in_slot(25.0);
    EXPECT_GT(some, 0.1 * whole);
    EXPECT_LT(some, 0.9 * whole);
}

// Adds a helix around the upright cylinder that fills the picture's width. It rises by `rise` per unit of length around
// the cylinder.
void add_helix(marks::PointSet& set, double rise) {
    constexpr int marks = 1200;
    marks::Layer& layer = layer_of(set, marks::Kind::own);
    const std::uint32_t number = 2 * static_cast<std::uint32_t>(layer.strokes());
    for (int i = 0; i <= marks; ++i) {
        const double a = 0.6 * pi * (2.0 * i / marks - 1.0);
        const glm::dvec3 n(std::sin(a), 0.0, std::cos(a));
        const glm::dvec3 along = glm::normalize(glm::dvec3(std::cos(a), rise, -std::sin(a)));
        add_mark(layer, 0.8 * n + glm::dvec3(0.0, 0.8 * rise * a, 0.0), n, along, number,
                 static_cast<std::uint32_t>(i));
        set.bounds.extend(0.8 * n + glm::dvec3(0.0, 0.8 * rise * a, 0.0));
    }
    marks::index_strokes(layer);
}

// Lines that cross the contour at 30 degrees or more, seen over half a taper, do not narrow. Closer to the contour all
// lines are tangent to it.
TEST_F(Hatch, LinesDoNotNarrowAtAContourThatTheyCross) {
    style.tone = frame::Tone::none;
    for (const auto& [rise, crosses] : {std::pair{0.0, true}, {0.15, true}, {0.7, false}, {0.9, false}}) {
        set = marks::PointSet(runtime.memory);
        add_helix(set, rise);
        set.spacing = 0.02;
        cluster();
        draw(front_camera(size, size, 1.25));
        ASSERT_EQ(frame.drawing().strokes.size(), 1) << rise;
        const auto points = points_of(0);
        const float length = points.back().length;
        const auto at = [&](float way) { // along the line
            const auto next = std::find_if(points.begin() + 1, points.end() - 1,
                                           [&](const StrokePoint& p) { return p.length >= way; });
            const StrokePoint& a = next[-1];
            return std::lerp(a.radius, next->radius, (way - a.length) / (next->length - a.length));
        };
        const float middle = at(0.5F * length);
        for (const float away : {1.0F, 3.0F}) {
            const float narrowed = std::sqrt(away / 7.0F);
            EXPECT_NEAR(at(away), middle * (crosses ? 1.0F : narrowed), 0.06F * middle) << rise << ' ' << away;
            EXPECT_NEAR(at(length - away), middle * (crosses ? 1.0F : narrowed), 0.06F * middle) << rise << ' ' << away;
        }
    }
}

// The arc is most of a circle.
TEST_F(Hatch, AnArcHasTwoEnds) {
    add_circle(set, 0.8, 0.0, {0, 0, 1}, 40, false);
    marks::Layer& arc = layer_of(set, marks::Kind::own);
    arc.stroke_first[1] = 38; // the ends are three marks apart
    cluster();
    draw(front_camera(size, size, 1.25));
    ASSERT_EQ(frame.drawing().strokes.size(), 1);
    EXPECT_FALSE(frame.drawing().strokes[0].closed);
    EXPECT_EQ(points_of(0).front().radius, 0.0F);
    EXPECT_EQ(points_of(0).back().radius, 0.0F);
}

TEST_F(Hatch, ASphereHidesTheLinesBehindIt) {
    set = nested_plane(runtime.memory);
    cluster();
    const marks::PointSet ball = clustered(runtime, sphere(runtime.memory, 20000, 0.4, {0, 0, 1}));
    frame::LayerStyle blank;
    blank.share = 0.0F;
    blank.contours = false;
    frame::Style blank_style = style;
    blank_style.layers = std::span(&blank, 1);
    blank_style.tone = frame::Tone::none;
    style.layers = std::span(&layer, 1);
    darkness = [](const glm::dvec3&) { return 0.5; };
    for (const frame::HiddenLines hidden : {frame::HiddenLines::hide, frame::HiddenLines::attenuate}) {
        style.hidden_lines = blank_style.hidden_lines = hidden;
        blank_style.halo_width = style.halo_width = 0.0F;
        blank_style.attenuation_front = blank_style.attenuation_back = 0.1; // something is visible through the ball
        const std::array items{layered_item(set, style), layered_item(ball, blank_style)};
        frame.draw(items, front_camera(size, size, 1.25));
        const drawing::Drawing& drawing = frame.drawing();
        EXPECT_GT(drawing.strokes.size(), 50);
        EXPECT_EQ(drawing.dot_count, 0);
        EXPECT_TRUE(frame.discs().empty());
        int within = 0;
        int near_rim = 0;
        for (const StrokePoint& p : drawing.points) {
            const float away = std::hypot(p.x - 250.0F, p.y - 250.0F);
            within += away < 75.0F;
            near_rim += away > 75.0F && away < 86.0F;
            if (hidden == frame::HiddenLines::hide) {
                EXPECT_EQ(p.opacity, 1.0F);
            } else if (away < 70.0F) {
                EXPECT_GT(p.opacity, 0.0F);
                EXPECT_LT(p.opacity, 0.9F);
            }
        }
        EXPECT_EQ(within > 0, hidden == frame::HiddenLines::attenuate);
        EXPECT_GT(near_rim, 20);
        EXPECT_EQ(drawing.counts.dropped_hidden > 0, hidden == frame::HiddenLines::hide);
        if (hidden == frame::HiddenLines::attenuate) continue;
        for (std::int64_t s = 0; s < drawing.strokes.size(); ++s) {
            EXPECT_EQ(points_of(s).front().radius, 0.0F);
            EXPECT_EQ(points_of(s).back().radius, 0.0F);
            EXPECT_GT(points_of(s).back().length, 5.0F);
        }
    }
}

// The points of a line depend on where it begins, and the width may change from one mark to the next.
TEST_F(Hatch, WidthsDoNotDependOnWhereALineBegins) {
    for (const double y : {-0.1, 0.0, 0.1}) add_line(set, {y, -1.0, 1.0, 0}, 0.01); // 2 pixels
    set_nesting(set, 0.1, 0);
    cluster();
    const auto width_in_the_middle = [&] {
        const auto points = points_of(0);
        const auto next = std::find_if(points.begin(), points.end(),
                                       [](const StrokePoint& p) { return p.x >= 0.5F * static_cast<float>(size); });
        const StrokePoint& a = *(next - 1);
        const StrokePoint& b = *next;
        return 2.0F * std::lerp(a.radius, b.radius, (0.5F * static_cast<float>(size) - a.x) / (b.x - a.x));
    };
    float least = 1e9F;
    float most = 0.0F;
    for (int i = 0; i < 12; ++i) {
        const double begin = -0.5 + 0.002 * i; // 0.4 pixels
        darkness = [=](const glm::dvec3& p) { return p.x < begin ? 0.0 : std::abs(p.x) < 0.005 ? 0.9 : 0.2; };
        draw(front_camera(size, size, 1.25));
        ASSERT_EQ(frame.drawing().strokes.size(), 3);
        least = std::min(least, width_in_the_middle());
        most = std::max(most, width_in_the_middle());
    }
    EXPECT_GT(most, 0.1F);
    EXPECT_LT(most - least, 0.3F * most);
}

TEST_F(Hatch, TheBackOfASurfaceIsNotDrawn) {
    add_latitudes(set);
    cluster();
    frame::Camera camera = front_camera(size, size, 1.25);
    camera.view = frame::look_at({4.0, -7.0, 5.0}, glm::dvec3(0.0), {0, 0, 1});
    style.tone = frame::Tone::none;
    draw(camera);
    ASSERT_GT(frame.drawing().strokes.size(), 20);
    for (const StrokePoint& p : frame.drawing().points)
        EXPECT_LT(p.depth, glm::length(glm::dvec3(4.0, -7.0, 5.0)) + 0.02);
}

} // namespace
} // namespace hrbfnpr::testing::hatch_ends_test
