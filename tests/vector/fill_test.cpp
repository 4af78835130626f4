// SPDX-License-Identifier: MIT
// Tests lines wider than their pen: the strokes cover the lines, and no more.
#include "recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hrbfnpr::testing::fill_test {
namespace {

using drawing::Cap;
using output::PagePoint;

constexpr double pen = 0.3;

constexpr double step = 0.04;
constexpr int columns = 1500, rows = 1000;

// Returns the grid places that are covered by lines whose widths change evenly between their points.
std::vector<bool> painted(const std::vector<KeptPath>& paths) {
    std::vector<bool> grid(columns * rows);
    const auto number = [](double place, int most) {
        return std::clamp(static_cast<int>(std::floor(place / step)), 0, most);
    };
    for (const KeptPath& path : paths)
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const PagePoint &a = path.points[i - 1], &b = path.points[i];
            const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy,
                         most = std::max(a.radius, b.radius);
            const int right = number(std::max(a.x, b.x) + most, columns - 1);
            const int bottom = number(std::max(a.y, b.y) + most, rows - 1);
            for (int row = number(std::min(a.y, b.y) - most, rows - 1); row <= bottom; ++row)
                for (int column = number(std::min(a.x, b.x) - most, columns - 1); column <= right; ++column) {
                    const double x = step * (column + 0.5) - a.x, y = step * (row + 0.5) - a.y;
                    const double t = square > 0.0 ? std::clamp((x * dx + y * dy) / square, 0.0, 1.0) : 0.0;
                    if (std::hypot(x - t * dx, y - t * dy) <= a.radius + t * (b.radius - a.radius))
                        grid[static_cast<std::size_t>(row * columns + column)] = true;
                }
        }
    return grid;
}

struct Filled {
    Sorted sorted;
    double missing = 0.0, excess = 0.0; // shares of the line's area
    double area = 0.0, length = 0.0;    // sums over all strokes
};

Filled filled(const GroupInput& input) {
    output::PageSettings settings = plotter_settings();
    settings.shapes.fills = true;
    Filled result;
    result.sorted = sorted(input, settings);
    const std::vector<bool> wanted = painted(input.paths), drawn = painted(result.sorted.out.paths);
    double inside = 0.0, missing = 0.0, excess = 0.0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        inside += wanted[i] ? 1.0 : 0.0;
        missing += wanted[i] && !drawn[i] ? 1.0 : 0.0;
        excess += drawn[i] && !wanted[i] ? 1.0 : 0.0;
    }
    result.missing = missing / inside;
    result.excess = excess / inside;
    result.area = step * step * inside;
    for (const KeptPath& path : result.sorted.out.paths) result.length += length_of(path.points);
    return result;
}

template <class Radius>
Line wave(double width, double height, Radius radius) {
    Line line;
    for (int i = 0; i <= 80; ++i) {
        const double t = i / 80.0;
        line.push_back({10.0 + width * t, 20.0 + height * std::sin(2.0 * std::numbers::pi * t), radius(t)});
    }
    return line;
}

TEST(FillLines, CoversALineThatSwells) {
    GroupInput input;
    input.add(wave(30.0, 5.0, [](double t) { return 1.2 * std::sin(std::numbers::pi * t); }));
    const Filled result = filled(input);
    EXPECT_LT(result.missing, 0.02);
    EXPECT_LT(result.excess, 0.03); // at the ends, which are thinner than the pen
    // There are at most 4 passes on each side, and each is only where the line is wide.
    EXPECT_LT(result.length, 1.25 * result.area / (0.8 * pen));
    EXPECT_LE(result.sorted.out.paths.size(), 6U); // the centre line, and a ring for each pass beside it
    EXPECT_EQ(result.sorted.counts.filled_paths, 1);
    double drawn = 0.0;
    for (const KeptPath& path : result.sorted.out.paths) {
        drawn += length_of(path.points);
        for (const PagePoint& p : path.points) EXPECT_DOUBLE_EQ(p.radius, 0.5 * pen);
    }
    EXPECT_NEAR(result.sorted.counts.drawn, drawn, 0.02 * drawn);
}

TEST(FillLines, FillsBackAndForthInOnePath) {
    for (const Cap cap : {Cap::round, Cap::flat}) {
        GroupInput input;
        input.add(wave(30.0, 0.0, [](double) { return 0.8; }));
        input.paths[0].begin = input.paths[0].end = cap;
        const Filled result = filled(input);
        ASSERT_EQ(result.sorted.out.paths.size(), 1U);
        EXPECT_LT(result.missing,
                  cap == Cap::round ? 0.005 : 0.05); // corners are missed, and the test paints the ends round
        EXPECT_LT(result.excess, 0.005);
        EXPECT_LT(result.length, 7.0 * 31.6 + 5.0);
        EXPECT_GT(result.length, 6.0 * 28.0);
    }
}

TEST(FillLines, UsesAsFewPassesAsPossible) {
    const auto passes = [](double radius) {
        GroupInput input;
        input.add({{10.0, 20.0, radius}, {40.0, 20.0, radius}});
        input.paths[0].begin = input.paths[0].end = Cap::flat;
        return std::lround(filled(input).length / 29.7);
    };
    EXPECT_EQ(passes(0.5 * pen), 1);
    EXPECT_EQ(passes(0.58 * pen), 1); // too little for another pass
    EXPECT_EQ(passes(0.65 * pen), 2);
    EXPECT_EQ(passes(0.90 * pen), 2);
    EXPECT_EQ(passes(1.10 * pen), 3);
    EXPECT_EQ(passes(1.65 * pen), 4);
    EXPECT_EQ(passes(2.10 * pen), 5);
}

TEST(FillLines, CoversRingsCornersAndBlobs) {
    GroupInput ring;
    Line line;
    for (int i = 0; i <= 60; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i % 60) / 60.0;
        line.push_back({30.0 + 8.0 * std::cos(angle), 20.0 + 8.0 * std::sin(angle), 0.7 + 0.4 * std::cos(angle)});
    }
    ring.add(line, true);
    GroupInput corner; // sharper than its width
    corner.add({{10.0, 10.0, 0.9}, {30.0, 10.0, 0.9}, {12.0, 14.0, 0.5}, {12.5, 13.0, 0.9}});
    GroupInput blob;
    blob.add({{30.0, 20.0, 1.5}, {30.05, 20.0, 1.5}});
    for (const GroupInput* input : {&ring, &corner, &blob}) {
        const Filled result = filled(*input);
        EXPECT_LT(result.missing, input == &blob ? 0.04 : 0.02);
        EXPECT_LT(result.excess, 0.02);
        EXPECT_EQ(result.sorted.counts.filled_paths, 1);
        EXPECT_EQ(result.sorted.counts.dropped_paths, 0);
        EXPECT_LE(result.sorted.out.paths.size(), 4U);
    }
}

TEST(FillLines, EndsInAPointIfTheCapIsPointed) {
    GroupInput input;
    input.add({{10.0, 20.0, 1.0}, {30.0, 20.0, 1.0}});
    input.paths[0].begin = input.paths[0].end = Cap::pointed;
    const Filled result = filled(input);
    double farthest = 0.0;
    for (const KeptPath& path : result.sorted.out.paths)
        for (const PagePoint& p : path.points) farthest = std::max(farthest, p.x);
    EXPECT_GT(farthest, 32.0);
    EXPECT_LE(farthest, 34.0 - 0.5 * pen);
}

TEST(FillLines, StaysOnThePage) {
    GroupInput input;
    input.add({{20.0, 0.2, 1.0}, {60.0, 0.2, 1.0}});
    output::PageSettings settings = plotter_settings();
    settings.shapes.fills = true;
    const Sorted result = sorted(input, settings);
    EXPECT_GE(result.out.paths.size(), 1U);
    for (const KeptPath& path : result.out.paths)
        for (const PagePoint& p : path.points) EXPECT_GE(p.y, 0.0);
}

TEST(FillLines, LeavesThinLinesAndOnePassAlone) {
    GroupInput input;
    input.add(wave(30.0, 5.0, [](double) { return 0.17; }));
    EXPECT_EQ(filled(input).sorted.counts.filled_paths, 0);
    input.add(wave(30.0, 9.0, [](double) { return 0.5; }));
    EXPECT_EQ(filled(input).sorted.counts.filled_paths, 1);
    const Sorted once = sorted(input);
    EXPECT_EQ(once.counts.filled_paths, 0);
    EXPECT_EQ(once.out.paths.size(), 2U);
    EXPECT_EQ(once.out.paths[1].points.size(), 81U);
}

TEST(FillLines, LimitsItsPasses) {
    GroupInput input;
    input.group.pen_width = 0.001;
    input.add({{10.0, 20.0, 1e5}, {10.1, 20.0, 1e5}});
    output::PageSettings settings = plotter_settings();
    settings.shapes.fills = true;
    EXPECT_LE(sorted(input, settings).out.paths.size(), 20000U);
}

} // namespace
} // namespace hrbfnpr::testing::fill_test
