// SPDX-License-Identifier: MIT
// Tests HPGL and G-code by reading them as a plotter does.
#include "output/vector/page.h"

#include "recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <type_traits>

namespace hrbfnpr::testing::plotter_test {
namespace {

using output::PagePoint;
using ::testing::HasSubstr;
using ::testing::Not;

// The lines that a plotter draws, in millimetres with y up.
struct Plotted {
    std::vector<Line> lines; // one point: the pen only touches the paper
    std::vector<int> pens;   // for each line
    double drawn = 0.0, travelled = 0.0;
    int lifts = 0;
    double x = 0.0, y = 0.0;
    bool down = false;
    int pen = 0;
    std::string rest; // all commands but pen moves
    int arcs = 0, splines = 0;
    std::int64_t between = 0;        // the number of points on arcs and splines between their ends
    double longest = 0.0, since = 0; // the largest length drawn between two lifts, and the length since the last one

    void raise() { down = false; }
    void lower() {
        if (down) return;
        down = true;
        since = 0.0;
        ++lifts;
        lines.push_back({{x, y, 0.0}});
        pens.push_back(pen);
    }
    void move(double to_x, double to_y) { move(to_x, to_y, std::hypot(to_x - x, to_y - y)); }
    void move(double to_x, double to_y, double length) {
        (down ? drawn : travelled) += length;
        if (down) longest = std::max(longest, since += length);
        x = to_x;
        y = to_y;
        if (down) lines.back().push_back({x, y, 0.0});
    }
    void pass(double at_x, double at_y) {
        ++between;
        lines.back().push_back({at_x, at_y, 0.0});
    }
    // Draws an arc around the centre (x + i, y + j).
    void arc(double to_x, double to_y, double i, double j, bool clockwise) {
        EXPECT_TRUE(down);
        ++arcs;
        const double centre_x = x + i, centre_y = y + j, radius = std::hypot(i, j);
        // Controllers refuse arcs whose ends have different distances from the centre.
        EXPECT_NEAR(std::hypot(to_x - centre_x, to_y - centre_y), radius, 0.003);
        const double from = std::atan2(-j, -i);
        double sweep = std::atan2(to_y - centre_y, to_x - centre_x) - from;
        if (clockwise && sweep >= 0.0) sweep -= 2.0 * std::numbers::pi;
        if (!clockwise && sweep <= 0.0) sweep += 2.0 * std::numbers::pi;
        EXPECT_LE(std::abs(sweep), 3.15);
        for (int k = 1; k < 32; ++k)
            pass(centre_x + radius * std::cos(from + sweep * k / 32),
                 centre_y + radius * std::sin(from + sweep * k / 32));
        move(to_x, to_y, radius * std::abs(sweep));
    }
    // Draws a cubic with the handles (x + i, y + j) and (to_x + p, to_y + q).
    void spline(double to_x, double to_y, double i, double j, double p, double q) {
        EXPECT_TRUE(down);
        ++splines;
        const double from_x = x, from_y = y;
        double length = 0.0, last_x = x, last_y = y;
        for (int k = 1; k <= 16; ++k) {
            const double t = k / 16.0, s = 1.0 - t;
            const auto at = [&](double a, double b, double c, double d) {
                return s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d;
            };
            const double at_x = at(from_x, from_x + i, to_x + p, to_x), at_y = at(from_y, from_y + j, to_y + q, to_y);
            length += std::hypot(at_x - last_x, at_y - last_y);
            if (k < 16) pass(last_x = at_x, last_y = at_y);
        }
        move(to_x, to_y, length);
    }
};

Plotted read_hpgl(const std::string& text) {
    Plotted plotted;
    std::size_t at = 0;
    while (at < text.size()) {
        if (text[at] == '\n') {
            ++at;
            continue;
        }
        const std::string command = text.substr(at, 2);
        const std::size_t end = text.find(command == "LB" ? '\x03' : ';', at);
        if (end == std::string::npos) {
            ADD_FAILURE() << "no end of " << command;
            break;
        }
        std::string numbers = text.substr(at + 2, end - at - 2);
        at = end + 1;
        if (command == "PU") plotted.raise();
        if (command == "PD") plotted.lower();
        if (command == "SP") plotted.pen = std::stoi(numbers);
        if (command != "PU" && command != "PD") {
            plotted.rest += command + numbers + ";";
            EXPECT_FALSE(plotted.down) << command;
            continue;
        }
        std::replace(numbers.begin(), numbers.end(), ',', ' ');
        std::istringstream stream(numbers);
        for (int x = 0, y = 0; stream >> x >> y;) plotted.move(x / 40.0, y / 40.0);
    }
    return plotted;
}

Plotted read_gcode(const std::string& text) {
    Plotted plotted;
    std::istringstream stream(text);
    double feed = 0.0;
    for (std::string line; std::getline(stream, line);) {
        double x = 0.0, y = 0.0, i = 0.0, j = 0.0, p = 0.0, q = 0.0;
        char command[3] = "";
        if (const std::size_t f = line.find(" F"); f != std::string::npos && line[0] == 'G')
            feed = std::stod(line.substr(f + 2));
        const int words =
            std::sscanf(line.c_str(), "%2s X%lf Y%lf I%lf J%lf P%lf Q%lf", command, &x, &y, &i, &j, &p, &q);
        if (words == 5) {
            EXPECT_TRUE(std::string(command) == "G2" || std::string(command) == "G3") << line;
            EXPECT_EQ(feed, 1800.0);
            plotted.arc(x, y, i, j, command[1] == '2');
        } else if (words == 7) {
            EXPECT_EQ(std::string(command), "G5") << line;
            plotted.spline(x, y, i, j, p, q);
        } else if (words == 3) {
            EXPECT_EQ(std::string(command), plotted.down ? "G1" : "G0") << line;
            EXPECT_EQ(plotted.down ? feed : 1800.0, 1800.0);
            plotted.move(x, y);
        } else if (line == "G1 Z0" || line == "down") {
            EXPECT_FALSE(plotted.down);
            plotted.lower();
        } else if (line == "G0 Z5" || line == "up") {
            plotted.raise();
        } else {
            int pen = 0;
            if (std::sscanf(line.c_str(), "(pen %d:", &pen) == 1 || std::sscanf(line.c_str(), "M0 (pen %d:", &pen) == 1)
                plotted.pen = pen;
            EXPECT_FALSE(plotted.down) << line;
            plotted.rest += line + "\n";
        }
    }
    return plotted;
}

class StringWriter final : public io::Writer {
public:
    void write(const void* data, std::uint64_t size) override {
        text.append(static_cast<const char*>(data), static_cast<std::size_t>(size));
    }
    std::string text;
};

struct Written {
    std::string text;
    output::PageCounts counts;
    Plotted plotted;
};

// The pages are 200 by 100 mm.
using Hpgl = std::integral_constant<output::PageFormat, output::PageFormat::hpgl>;
using Gcode = std::integral_constant<output::PageFormat, output::PageFormat::gcode>;

template <class Format>
Written written(const std::vector<GroupInput>& groups, const output::PageSettings& format = {},
                const std::vector<output::PageText>& texts = {}) {
    base::Memory memory;
    StringWriter out;
    Written result;
    output::PageInfo info;
    info.width = 200.0;
    info.height = 100.0;
    info.title = "A (title)\nof two lines, gr\xC3\xBCn";
    info.program = "0";
    const base::Progress progress;
    {
        output::PageSettings its = format;
        its.format = Format::value;
        const auto file = output::make_writer(memory, out, info, its, result.counts);
        output::PageSettings settings = plotter_settings();
        settings.shapes = format.shapes;
        settings.plot = format.plot;
        settings.format = Format::value;
        const auto order = output::plot_order(memory, *file, settings, result.counts, nullptr, progress);
        order->begin_view({"", {0.0, 0.0, 200.0, 100.0}, {}, false});
        for (const GroupInput& group : groups) group.hand_to(*order);
        order->end_view();
        if (!texts.empty()) {
            order->begin_group({});
            for (const output::PageText& text : texts) order->text(text);
            order->end_group();
        }
        order->finish();
    }
    result.text = out.text;
    EXPECT_EQ(result.counts.bytes, static_cast<std::int64_t>(out.text.size()));
    if constexpr (Format::value == output::PageFormat::hpgl)
        result.plotted = read_hpgl(out.text);
    else
        result.plotted = read_gcode(out.text);
    return result;
}

double distance(const PagePoint& p, const std::vector<Line>& lines) {
    double least = 1e9;
    for (const Line& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i) {
            const PagePoint &a = line[i == 0 ? 0 : i - 1], &b = line[i];
            const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
            const double t = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
            least = std::min(least, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
        }
    return least;
}

// Returns the largest distance of places along some lines from other lines.
double farthest(const std::vector<Line>& from, const std::vector<Line>& to) {
    double most = 0.0;
    for (const Line& line : from)
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            for (const double t : {0.0, 0.3, 0.7, 1.0}) {
                const PagePoint &a = line[i], &b = line[i + 1];
                most = std::max(most, distance({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0.0}, to));
            }
    return most;
}

// Returns the lines with y up.
std::vector<Line> lines_of(const GroupInput& input) {
    std::vector<Line> lines;
    for (const KeptPath& path : input.paths) {
        lines.push_back(path.points);
        for (PagePoint& p : lines.back()) p.y = 100.0 - p.y;
    }
    return lines;
}

void expect_estimate(const Written& result, const output::PenSpeeds& speeds = {}) {
    const Plotted& p = result.plotted;
    EXPECT_NEAR(result.counts.drawn, p.drawn, 1e-6);
    EXPECT_NEAR(result.counts.travelled, p.travelled, 1e-6);
    EXPECT_NEAR(result.counts.seconds,
                p.drawn / speeds.draw + p.travelled / speeds.travel + 2.0 * speeds.seconds * p.lifts, 1e-6);
}

template <class Format>
class Plotter : public ::testing::Test {};
using Formats = ::testing::Types<Hpgl, Gcode>;
TYPED_TEST_SUITE(Plotter, Formats);

TYPED_TEST(Plotter, DrawsAllLinesWithinTheTolerance) {
    const GroupInput input = random_lines(1, 150, 9.0, 40);
    for (const double tolerance : {0.05, 0.3}) {
        output::PageSettings format;
        format.shapes.tolerance = tolerance;
        const Written result = written<TypeParam>({input}, format);
        const double reach = tolerance + 0.02; // includes half a unit in each direction
        EXPECT_LE(farthest(lines_of(input), result.plotted.lines), reach);
        // Joined ends are closer to each other than the pen's width.
        EXPECT_LE(farthest(result.plotted.lines, lines_of(input)), reach + 0.5 * output::plotter_pen);
        EXPECT_EQ(result.counts.paths, 150 - result.counts.joined);
        expect_estimate(result);
        std::int64_t segments = 0;
        for (const Line& line : result.plotted.lines) segments += static_cast<std::int64_t>(line.size()) - 1;
        segments -= result.plotted.between;
        EXPECT_EQ(result.counts.segments, segments);
        EXPECT_EQ(result.plotted.arcs > 0, TypeParam::value == output::PageFormat::gcode);
        EXPECT_LT(segments, tolerance > 0.1 ? 800 : 2000); // the page has 5850 segments
    }
}

TYPED_TEST(Plotter, EstimatesTheTime) {
    output::PageSettings format;
    format.plot.speeds = {30.0, 200.0, 0.5};
    const Written result = written<TypeParam>({random_lines(3, 300, 8.0)}, format);
    EXPECT_GT(result.plotted.lifts, 200);
    expect_estimate(result, format.plot.speeds);
}

TYPED_TEST(Plotter, DoesNotLiftWhereALineContinues) {
    GroupInput square; // corners are not joined, but drawn in one go
    square.add({{50.0, 50.0, 0.1}, {60.0, 50.0, 0.1}});
    square.add({{60.0, 60.0, 0.1}, {60.0, 50.0, 0.1}});
    square.add({{50.0, 60.0, 0.1}, {50.0, 50.0, 0.1}});
    square.add({{50.0, 60.0, 0.1}, {60.0, 60.0, 0.1}});
    const Written result = written<TypeParam>({square});
    EXPECT_EQ(result.counts.joined, 0);
    EXPECT_EQ(result.plotted.lifts, 1);
    EXPECT_NEAR(result.plotted.drawn, 40.0, 1e-9);
    EXPECT_EQ(result.plotted.lines.size(), 1U);
    expect_estimate(result);
}

TYPED_TEST(Plotter, DrawsDotsInThreeWays) {
    GroupInput input;
    input.dots = {{50.0, 50.0, 2.0, 1.0, false}, {50.0, 20.0, 0.1, 1.0, false}}; // the second is no wider than the pen
    output::PageSettings format;
    const Written circles = written<TypeParam>({input}, format);
    EXPECT_EQ(circles.counts.dots, 2);
    ASSERT_EQ(circles.plotted.lines.size(), 2U);
    for (const PagePoint& p : circles.plotted.lines[0]) EXPECT_NEAR(std::hypot(p.x - 50.0, p.y - 50.0), 1.85, 0.02);
    EXPECT_NEAR(circles.plotted.drawn, 2.0 * 3.14159265 * 1.85, 0.3);
    EXPECT_EQ(circles.plotted.lines[1].size(), 1U);
    EXPECT_NEAR(circles.plotted.lines[1][0].y, 80.0, 0.02);
    // The circle begins on the side where the pen comes from.
    const double begin = 50.0 - 1.85 * std::sqrt(0.5);
    EXPECT_NEAR(circles.plotted.travelled, std::hypot(begin, begin) + std::hypot(50.0 - begin, 80.0 - begin), 0.1);
    expect_estimate(circles);

    format.shapes.dots = output::DotShapes::lines;
    const Written touches = written<TypeParam>({input}, format);
    EXPECT_EQ(touches.plotted.lines.size(), 2U);
    EXPECT_EQ(touches.plotted.drawn, 0.0);
    EXPECT_EQ(touches.plotted.lifts, 2);
    expect_estimate(touches);

    format.shapes.dots = output::DotShapes::spirals;
    const Written spirals = written<TypeParam>({input}, format);
    ASSERT_EQ(spirals.plotted.lines.size(), 2U);
    // No place in the disc is farther from the line than half the pen's width.
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const double angle = 6.283185307 * random(), radius = 2.0 * std::sqrt(random());
        const PagePoint p{50.0 + radius * std::cos(angle), 50.0 + radius * std::sin(angle), 0.0};
        EXPECT_LE(distance(p, {spirals.plotted.lines[0]}), 0.15 + format.shapes.tolerance + 0.02);
    }
    expect_estimate(spirals);
}

TYPED_TEST(Plotter, FillsDotsThatAreWiderThanThePen) {
    GroupInput input;
    input.dots = {{50.0, 50.0, 1.0, 1.0, false}, {50.0, 20.0, 0.1, 1.0, false}};
    output::PageSettings format;
    format.shapes.fills = true;
    const Written result = written<TypeParam>({input}, format);
    ASSERT_EQ(result.plotted.lines.size(), 2U);
    EXPECT_GT(result.plotted.drawn, 3.1 / 0.3); // the disc's area over the pen's width
    for (int i = 0; i < 500; ++i) {
        const double angle = 2.4 * i, radius = std::sqrt(i / 500.0);
        const PagePoint p{50.0 + radius * std::cos(angle), 50.0 + radius * std::sin(angle), 0.0};
        EXPECT_LE(distance(p, {result.plotted.lines[0]}), 0.15 + format.shapes.tolerance + 0.02);
    }
    EXPECT_EQ(result.plotted.lines[1].size(), 1U);
}

TYPED_TEST(Plotter, ChangesPensBetweenGroups) {
    GroupInput one, two, three;
    one.add({{10.0, 90.0, 0.1}, {20.0, 90.0, 0.1}});
    two.add({{20.0, 90.0, 0.1}, {30.0, 90.0, 0.1}}); // continues the first line, but with another pen
    three.add({{30.0, 90.0, 0.1}, {40.0, 90.0, 0.1}});
    two.group.pen = three.group.pen = 7;
    std::snprintf(two.group.name, sizeof two.group.name, "hatch (2) gr%s", "\xC3\xBCn");
    const Written result = written<TypeParam>({one, two, three});
    EXPECT_EQ(result.plotted.pens, (std::vector<int>{1, 7, 7}));
    EXPECT_EQ(result.counts.groups, 3);
    expect_estimate(result);
}

TEST(Hpgl, WritesTheExpectedCommands) {
    GroupInput input, other;
    input.add({{10.0, 90.0, 0.1}, {20.0, 90.0, 0.1}, {20.0, 70.0, 0.1}});
    input.dots = {{20.0, 50.0, 0.1, 1.0, false}};
    other.add({{1.0, 99.0, 0.1}, {2.0, 99.0, 0.1}});
    other.group.pen = 2;
    const Written result = written<Hpgl>({input, other}, {}, {{10.0, 20.0, 5.0, "\xC3\x84; a\n(b)"}});
    EXPECT_EQ(result.text,
              "IN;\nSP1;\nPU400,400;\nPD800,400,800,1200;\nPU800,2000;\nPD;\nPU;\nSP2;\nPU80,40;\nPD40,40;\nPU;\n"
              "SP1;\nPU400,3200;\nSI0.35,0.5;LB?; a?(b)\x03\nPU;SP0;\n");
}

// A label moves the pen.
TEST(Hpgl, ReturnsAfterALabel) {
    base::Memory memory;
    StringWriter out;
    output::PageCounts counts;
    output::PageInfo info;
    info.height = 100.0;
    const auto file = output::make_writer(memory, out, info, plotter_settings(), counts);
    file->begin_group({});
    file->text({10.0, 90.0, 4.0, "a"});
    const Line line{{10.0, 90.0, 0.1}, {20.0, 90.0, 0.1}};
    file->path(path_of(line));
    file->end_group();
    file->finish();
    EXPECT_EQ(out.text, "IN;\nSP1;\nPU400,400;\nSI0.28,0.4;LBa\x03\nPU400,400;\nPD800,400;\nPU;\nPU;SP0;\n");
}

TEST(Gcode, WritesTheExpectedCommands) {
    GroupInput input, other;
    input.add({{10.0, 90.0, 0.1}, {20.0, 90.0, 0.1}, {20.0, 70.5, 0.1}});
    std::snprintf(input.group.name, sizeof input.group.name, "hatch (2) gr%s", "\xC3\xBCn");
    other.add({{1.0, 99.0, 0.1}, {0.5, 99.0, 0.1}});
    other.group.pen = 2;
    output::PageSettings format;
    format.plot.pen_down = "down";
    format.plot.pen_up = "up\n";
    const Written result = written<Gcode>({input, other}, format, {{10.0, 20.0, 5.0, "a\n(b)"}});
    EXPECT_EQ(result.text,
              "(A ?title??of two lines, gr?n)\n(hrbfnpr 0)\n"
              "(200 x 100 mm, y up from the lower left corner; texts are left out)\n"
              "G21\nG90\nG1 F1800\nup\n(pen 1: hatch ?2? gr?n, 0.3 mm)\nG0 X10 Y10\ndown\n"
              "G1 X20 Y10 F1800\nG1 X20 Y29.5\nup\nM0 (pen 2: , 0.3 mm)\nG0 X1 Y1\ndown\nG1 X0.5 Y1 F1800\nup\n"
              "M0 (pen 1: , 0.3 mm)\n(text left out: a??b?)\nM2\n");
}

TYPED_TEST(Plotter, LiftsThePenAfterTheLongestLength) {
    GroupInput input;
    for (int k = 0; k < 10; ++k) {
        Line line;
        for (int i = 0; i <= 40; ++i) line.push_back({60.0 + 2.5 * i, 10.0 + 8.0 * k + 3.0 * std::sin(0.1 * i), 0.1});
        input.add(line);
    }
    Line ring;
    for (int i = 0; i <= 100; ++i)
        ring.push_back({100.0 + 30.0 * std::cos(0.02 * std::numbers::pi * i),
                        50.0 + 30.0 * std::sin(0.02 * std::numbers::pi * i), 0.1});
    ring.back() = ring[0];
    input.add(ring, true);
    // The ends of these lines meet, so the pen draws them in one go otherwise.
    for (const double x : {20.0, 30.0, 40.0, 50.0}) input.add({{x, 5.0, 0.1}, {x, 15.0, 0.1}});
    for (const double x : {20.0, 30.0, 40.0})
        input.add({{x, x == 30.0 ? 5.0 : 15.0, 0.1}, {x + 10.0, x == 30.0 ? 5.0 : 15.0, 0.1}});
    input.dots = {{180.0, 90.0, 3.0, 1.0, false}};
    output::PageSettings format;
    format.shapes.fills = true;
    const Written without = written<TypeParam>({input}, format);
    format.plot.longest = 25.0;
    const Written with = written<TypeParam>({input}, format);
    EXPECT_GT(without.plotted.longest, 60.0);
    EXPECT_LE(with.plotted.longest, 25.0 * 1.01);
    EXPECT_EQ(without.counts.cut_paths, 0);
    EXPECT_EQ(with.counts.cut_paths, 12); // the ring, the lines, and the spiral
    EXPECT_NEAR(with.plotted.drawn, without.plotted.drawn, 0.01 * without.plotted.drawn);
    EXPECT_LE(farthest(lines_of(input), with.plotted.lines), format.shapes.tolerance + 0.02);
    expect_estimate(with);
    // All parts of a line are of one length.
    GroupInput straight;
    straight.add({{10.0, 50.0, 0.1}, {70.0, 50.0, 0.1}});
    const Written cut = written<TypeParam>({straight}, format);
    ASSERT_EQ(cut.plotted.lines.size(), 3U);
    for (const Line& line : cut.plotted.lines) EXPECT_NEAR(length_of(line), 20.0, 0.03);
}

TEST(Gcode, WritesArcsOrSplinesOrLines) {
    GroupInput input;
    Line arc;
    for (int i = 0; i <= 60; ++i)
        arc.push_back({50.0 + 20.0 * std::cos(0.05 * i), 50.0 + 20.0 * std::sin(0.05 * i), 0.1});
    input.add(arc);
    output::PageSettings format;
    const Written arcs = written<Gcode>({input}, format);
    EXPECT_EQ(arcs.plotted.arcs, 1);
    EXPECT_EQ(arcs.counts.segments, 1);
    // Angles grow from x to y, which points down on the page, so the pen goes clockwise unless the line was turned.
    EXPECT_THAT(arcs.text, HasSubstr("G3 X70 Y50 I19.8 J2.822 F1800"));
    format.shapes.curves = output::Curves::splines;
    const Written splines = written<Gcode>({input}, format);
    EXPECT_GT(splines.plotted.splines, 0);
    EXPECT_EQ(splines.plotted.arcs, 0);
    format.shapes.curves = output::Curves::lines;
    const Written lines = written<Gcode>({input}, format);
    EXPECT_EQ(lines.plotted.arcs + lines.plotted.splines, 0);
    for (const Written* one : {&arcs, &splines, &lines}) {
        EXPECT_LE(farthest(lines_of(input), one->plotted.lines), 0.06);
        EXPECT_LE(farthest(one->plotted.lines, lines_of(input)), 0.06);
        expect_estimate(*one);
    }
    EXPECT_GT(lines.counts.segments, 5 * arcs.counts.segments);
}

TEST(Gcode, WritesCirclesAsTwoArcs) {
    GroupInput input;
    input.dots = {{50.0, 50.0, 2.0, 1.0, false}};
    const Written result = written<Gcode>({input});
    EXPECT_EQ(result.plotted.arcs, 2);
    EXPECT_NEAR(result.plotted.drawn, 2.0 * std::numbers::pi * 1.85, 0.01);
}

TEST(Gcode, HasDefaultPenCommands) {
    GroupInput input;
    input.add({{10.0, 90.0, 0.1}, {20.0, 90.0, 0.1}});
    const std::string text = written<Gcode>({input}).text;
    EXPECT_THAT(text, HasSubstr("G90\nG1 F1800\nG0 Z5\n"));
    EXPECT_THAT(text, HasSubstr("G0 X10 Y10\nG1 Z0\nG1 X20 Y10 F1800\nG0 Z5\nM2\n"));
    EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(Hpgl, CutsLongInstructions) {
    GroupInput input;
    Line zigzag;
    for (int i = 0; i < 300; ++i) zigzag.push_back({10.0 + 0.5 * i, i % 2 == 0 ? 40.0 : 60.0, 0.1});
    input.add(zigzag);
    const Written result = written<Hpgl>({input});
    EXPECT_EQ(result.plotted.lifts, 1);
    std::istringstream stream(result.text);
    for (std::string line; std::getline(stream, line);) EXPECT_LE(line.size(), 1000U);
    EXPECT_LE(farthest(lines_of(input), result.plotted.lines), 0.02);
}

} // namespace
} // namespace hrbfnpr::testing::plotter_test
