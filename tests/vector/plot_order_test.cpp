// SPDX-License-Identifier: MIT
// Tests how a group's lines and dots are changed for a pen.
#include "recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace hrbfnpr::testing::plot_order_test {
namespace {

using drawing::Cap;
using output::PagePoint;

using Segment = std::array<double, 4>;

std::multiset<Segment> segments_of(const std::vector<KeptPath>& paths) {
    std::multiset<Segment> segments;
    for (const KeptPath& path : paths)
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const PagePoint &a = path.points[i - 1], &b = path.points[i];
            const Segment one{a.x, a.y, b.x, b.y}, other{b.x, b.y, a.x, a.y};
            segments.insert(std::min(one, other));
        }
    return segments;
}

Line circle(double x, double y, double radius, int points = 40, double from = 0.0, double to = 1.0) {
    Line line;
    for (int i = 0; i <= points; ++i) {
        const double angle =
            2.0 * std::numbers::pi * (from + (to - from) * (i % points == 0 ? i / points : 1.0 * i / points));
        line.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle), 0.1});
    }
    if (to - from == 1.0) line.back() = line.front();
    return line;
}

Line straight(double x1, double y1, double x2, double y2, int parts = 10) {
    Line line;
    for (int i = 0; i <= parts; ++i) line.push_back({x1 + (x2 - x1) * i / parts, y1 + (y2 - y1) * i / parts, 0.1});
    return line;
}

TEST(PlotOrder, DrawsEverySegmentOnce) {
    const GroupInput input = random_lines(1, 2000, 6.0);
    const Sorted result = sorted(input);
    EXPECT_GT(result.counts.joined, 5); // makes sure that there are links to check
    EXPECT_EQ(result.out.paths.size() + static_cast<std::size_t>(result.counts.joined), input.paths.size());
    std::multiset<Segment> drawn = segments_of(result.out.paths);
    for (const Segment& segment : segments_of(input.paths)) {
        const auto found = drawn.find(segment);
        ASSERT_NE(found, drawn.end());
        drawn.erase(found);
    }
    EXPECT_EQ(drawn.size(), static_cast<std::size_t>(result.counts.joined)); // only the links remain
    for (const Segment& link : drawn) EXPECT_LE(std::hypot(link[0] - link[2], link[1] - link[3]), output::plotter_pen);
}

TEST(PlotOrder, TravelsFarLessAndReportsIt) {
    const GroupInput input = random_lines(2, 2000, 6.0);
    const Sorted result = sorted(input);
    EXPECT_LT(result.counts.travelled, 0.025 * travel_of(input.paths));
    EXPECT_NEAR(result.counts.travelled, travel_of(result.out.paths), 1e-6);
    double drawn = 0.0;
    for (const KeptPath& path : result.out.paths) drawn += length_of(path.points);
    EXPECT_NEAR(result.counts.drawn, drawn, 0.01 * drawn); // within the tolerance of the lines
    const auto lifts = static_cast<double>(result.out.paths.size());
    EXPECT_NEAR(result.counts.seconds, result.counts.drawn / 30.0 + result.counts.travelled / 80.0 + 0.3 * lifts, 1e-6);
}

TEST(PlotOrder, BeginsClosedLinesAnywhere) {
    GroupInput input;
    input.add(circle(50.0, 50.0, 10.0, 400), true);
    const Sorted result = sorted(input);
    ASSERT_EQ(result.out.paths.size(), 1U);
    const Line& line = result.out.paths[0].points;
    EXPECT_TRUE(result.out.paths[0].closed);
    EXPECT_EQ(line.front().x, line.back().x);
    EXPECT_EQ(line.front().y, line.back().y);
    EXPECT_EQ(segments_of(result.out.paths), segments_of(input.paths));
    EXPECT_NEAR(result.counts.travelled, std::hypot(50.0, 50.0) - 10.0, 1e-3);
}

TEST(PlotOrder, TurnsCapsWithTheirLine) {
    GroupInput input;
    Line line = straight(50.0, 90.0, 10.0, 90.0); // its end is nearer to the corner of the page
    line.front().radius = 0.4;
    input.add(line);
    input.paths[0].begin = Cap::pointed;
    input.paths[0].end = Cap::flat;
    output::PageSettings settings = plotter_settings();
    settings.format = output::PageFormat::svg;
    const Sorted result = sorted(input, settings);
    const KeptPath& path = result.out.paths.at(0);
    EXPECT_EQ(path.points.front().x, 10.0);
    EXPECT_EQ(path.points.back().radius, 0.4);
    EXPECT_EQ(path.begin, Cap::flat);
    EXPECT_EQ(path.end, Cap::pointed);
    EXPECT_EQ(result.out.pen_width, 0.0);
}

std::int64_t joins_of(const Line& a, const Line& b) {
    GroupInput input;
    input.add(a);
    input.add(b);
    const Sorted result = sorted(input);
    EXPECT_EQ(result.out.paths.size() + static_cast<std::size_t>(result.counts.joined), 2U);
    EXPECT_EQ(result.out.pen_width, output::plotter_pen);
    return result.counts.joined;
}

TEST(PlotOrder, JoinsLinesThatContinueEachOther) {
    const Line line = straight(10.0, 50.0, 20.0, 50.0);
    EXPECT_EQ(joins_of(line, straight(20.0, 50.0, 30.0, 50.0)), 1);
    EXPECT_EQ(joins_of(line, straight(20.25, 50.0, 30.0, 50.0)), 1);
    EXPECT_EQ(joins_of(line, straight(30.0, 50.0, 20.25, 50.0)), 1);  // reversed
    EXPECT_EQ(joins_of(line, straight(19.9, 50.0, 30.0, 50.0)), 1);   // slight overlap
    EXPECT_EQ(joins_of(line, straight(20.0, 50.0, 30.0, 55.0)), 1);   // a slight turn
    EXPECT_EQ(joins_of(line, straight(20.35, 50.0, 30.0, 50.0)), 0);  // too far
    EXPECT_EQ(joins_of(line, straight(20.0, 50.0, 20.0, 60.0)), 0);   // a corner
    EXPECT_EQ(joins_of(line, straight(20.0, 50.2, 10.0, 50.2)), 0);   // back again: the next row of hatching
    EXPECT_EQ(joins_of(line, straight(20.0, 50.25, 30.0, 50.25)), 0); // a step to the side
    EXPECT_EQ(joins_of(line, straight(20.0, 50.05, 30.0, 50.05)), 1); // within the line's width
}

TEST(PlotOrder, JoinsTheBestPairWhereSeveralMeet) {
    GroupInput input; // a cross of four lines that meet
    input.add(straight(40.0, 50.0, 50.0, 50.0));
    input.add(straight(50.0, 40.0, 50.0, 50.0));
    input.add(straight(60.0, 50.0, 50.0, 50.0));
    input.add(straight(50.0, 50.0, 50.0, 60.0));
    const Sorted result = sorted(input);
    EXPECT_EQ(result.counts.joined, 2);
    ASSERT_EQ(result.out.paths.size(), 2U);
    for (const KeptPath& path : result.out.paths)
        EXPECT_DOUBLE_EQ(between(path.points.front(), path.points.back()), 20.0);
}

TEST(PlotOrder, PrefersToContinueStraight) {
    GroupInput input;
    input.add(straight(40.0, 50.0, 50.0, 50.0));
    input.add(straight(50.0, 50.0, 57.0, 57.0));  // by 45 degrees
    input.add(straight(50.05, 50.0, 60.0, 50.0)); // slightly farther away
    const Sorted result = sorted(input);
    EXPECT_EQ(result.counts.joined, 1);
    double longest = 0.0;
    for (const KeptPath& path : result.out.paths)
        longest = std::max(longest, between(path.points.front(), path.points.back()));
    EXPECT_DOUBLE_EQ(longest, 20.0);
}

TEST(PlotOrder, KeepsRowsOfHatchingApart) {
    GroupInput input;
    for (int row = 0; row < 50; ++row) input.add(straight(20.0, 40.0 + 0.25 * row, 60.0, 40.0 + 0.25 * row));
    const Sorted result = sorted(input);
    EXPECT_EQ(result.counts.joined, 0);
    EXPECT_EQ(result.out.paths.size(), 50U);
    // Rows are drawn back and forth, so the pen travels from row to row.
    const double first = std::min(std::hypot(20.0, 60.0), std::hypot(20.0, 60.0 - 0.25 * 49.0));
    EXPECT_NEAR(result.counts.travelled, first + 49.0 * 0.25, 1e-6);
}

TEST(PlotOrder, JoinsArcsIntoARing) {
    GroupInput input;
    input.add(circle(50.0, 50.0, 10.0, 20, 0.0, 0.3));
    Line back = circle(50.0, 50.0, 10.0, 20, 0.3, 0.7);
    std::reverse(back.begin(), back.end());
    input.add(back);
    input.add(circle(50.0, 50.0, 10.0, 20, 0.7, 1.0 - 1e-3)); // a gap of 0.06 mm
    const Sorted result = sorted(input);
    EXPECT_EQ(result.counts.joined, 3);
    ASSERT_EQ(result.out.paths.size(), 1U);
    EXPECT_TRUE(result.out.paths[0].closed);
    EXPECT_EQ(result.out.paths[0].points.front().x, result.out.paths[0].points.back().x);
    EXPECT_NEAR(length_of(result.out.paths[0].points), 20.0 * std::numbers::pi, 0.3);
}

TEST(PlotOrder, KeepsOpacitiesApartExceptForAPlotter) {
    GroupInput input; // a line that fades, in parts that are shorter than half of its width
    for (int i = 0; i < 20; ++i)
        input.add(straight(20.0 + 0.08 * i, 50.0, 20.08 + 0.08 * i, 50.0, 1), false, 1.0 - 0.04 * i);
    output::PageSettings settings = plotter_settings();
    const Sorted plotted = sorted(input, settings);
    EXPECT_EQ(plotted.counts.joined, 19);
    ASSERT_EQ(plotted.out.paths.size(), 1U);
    EXPECT_NEAR(plotted.out.paths[0].opacity, 0.62, 1e-9);
    settings.format = output::PageFormat::svg;
    const Sorted written = sorted(input, settings);
    EXPECT_EQ(written.counts.joined, 0);
    EXPECT_EQ(written.out.paths.size(), 20U);
    EXPECT_EQ(written.counts.dropped_paths, 0);
}

TEST(PlotOrder, DropsLinesThatAreTooShort) {
    GroupInput input;
    input.add(straight(20.0, 50.0, 20.14, 50.0));
    input.add(straight(20.0, 60.0, 20.16, 60.0));
    input.add(straight(30.0, 50.0, 30.1, 50.0)); // joined with the next line
    input.add(straight(30.1, 50.0, 35.0, 50.0));
    Sorted result = sorted(input);
    EXPECT_EQ(result.counts.dropped_paths, 1);
    EXPECT_EQ(result.counts.joined, 1);
    EXPECT_EQ(result.out.paths.size(), 2U);
    output::PageSettings settings = plotter_settings();
    settings.plot.shortest = 0.17;
    result = sorted(input, settings);
    EXPECT_EQ(result.counts.dropped_paths, 2);
    input.group.line_type = static_cast<output::LineType>(7); // dotted lines are left as they are
    result = sorted(input, settings);
    EXPECT_EQ(result.counts.dropped_paths, 0);
    EXPECT_EQ(result.counts.joined, 0);
    EXPECT_EQ(result.out.paths.size(), 4U);
}

TEST(PlotOrder, DropsDotsNearOtherDots) {
    GroupInput input;
    for (int i = 0; i < 10; ++i) input.dots.push_back({50.0 + 0.1 * i, 50.0, 0.5, 1.0, false});
    Sorted result = sorted(input); // closer than half of 0.3 mm: every second dot stays
    EXPECT_EQ(result.counts.dropped_dots, 5);
    std::vector<double> places;
    for (const output::PageDot& dot : result.out.dots) places.push_back(dot.x);
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_DOUBLE_EQ(places[i], 50.0 + 0.2 * static_cast<double>(i));
    output::PageSettings settings = plotter_settings();
    settings.plot.dot_distance = 0.95;
    result = sorted(input, settings);
    EXPECT_EQ(result.out.dots.size(), 1U);
    EXPECT_EQ(result.out.dots[0].x, 50.0);
}

TEST(PlotOrder, CutsLinesAtTheFrame) {
    base::Memory memory;
    Recorder out;
    output::PageCounts counts;
    const base::Progress progress;
    const auto order = output::plot_order(memory, out, plotter_settings(), counts, nullptr, progress);
    output::PageView view;
    view.frame = {-20.0, 20.0, 60.0, 80.0}; // reaches beyond the page, too
    order->begin_view(view);
    GroupInput input;
    input.add(straight(-50.0, 50.0, 150.0, 50.0));
    input.add(circle(60.0, 60.0, 10.0, 400), true); // half of it is inside
    input.add(circle(30.0, 30.0, 5.0, 40), true);   // inside
    input.add(circle(60.0, 80.0, 30.0, 400), true); // cut into two parts
    input.add(straight(70.0, 10.0, 70.0, 90.0));    // outside
    input.add({{10.0, 50.0, 0.1},
               {std::numeric_limits<double>::quiet_NaN(), 40.0, 0.1},
               {20.0, 70.0, 0.1},
               {30.0, 70.0, 0.1}});
    input.dots = {{30.0, 30.0, 1.0, 1.0, false}, {61.0, 30.0, 5.0, 1.0, false}};
    input.hand_to(*order);
    order->end_view();
    EXPECT_EQ(out.kept.dots.size(), 1U);
    double length = 0.0;
    int closed = 0;
    for (const KeptPath& path : out.kept.paths) {
        closed += path.closed ? 1 : 0;
        length += length_of(path.points);
        for (const PagePoint& p : path.points) {
            EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
            EXPECT_TRUE(p.x >= -1e-12 && p.x <= 60.0 + 1e-12 && p.y >= 20.0 - 1e-12 && p.y <= 80.0 + 1e-12);
        }
    }
    EXPECT_EQ(closed, 1);
    EXPECT_EQ(out.kept.paths.size(), 5U);
    const double pi = std::numbers::pi;
    EXPECT_NEAR(length, 60.0 + 10.0 * pi + 10.0 * pi + 15.0 * pi + 10.0, 0.1);
}

TEST(PlotOrder, WritesTextsBeforePathsAndNestsGroups) {
    base::Memory memory;
    Recorder out;
    output::PageCounts counts;
    const base::Progress progress;
    const auto order = output::plot_order(memory, out, plotter_settings(), counts, nullptr, progress);
    order->begin_view({});
    order->begin_group({});
    order->path(path_of(straight(10.0, 10.0, 20.0, 10.0)));
    order->text({10.0, 10.0, 3.0, "a"});
    order->end_group();
    order->end_view();
    order->begin_group({});
    order->path(path_of(straight(10.0, 10.0, 20.0, 10.0)));
    order->end_group();
    order->finish();
    EXPECT_EQ(out.kept.calls, "view{{'a'}}{p}."); // an empty frame, then the page
}

} // namespace
} // namespace hrbfnpr::testing::plot_order_test
