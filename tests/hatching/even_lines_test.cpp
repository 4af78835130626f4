// SPDX-License-Identifier: MIT
// Tests lines between others: where they are moved to, and how they turn.
#include "hatching/lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::hatching::even_lines_test {
namespace {

// Adds a line in the plane z = 0 along x that rises by `slope`.
void add_line(Lines& lines, double y, double from, double to, std::uint8_t level = 0, double slope = 0.0) {
    for (double x = from; x <= to; x += 0.4) {
        lines.position.push_back({x, y + slope * x, 0.0});
        lines.normal.push_back({0.0, 0.0, 1.0});
        lines.level.push_back(level);
    }
    lines.end_line(false);
}

// The largest deviation in y of a line's points with x in [from, to].
double farthest_from(const Lines& lines, std::int64_t line, double y, double from, double to) {
    double most = 0.0;
    for (std::int64_t i = lines.first[line]; i < lines.first[line + 1]; ++i)
        if (lines.position.x[i] >= from && lines.position.x[i] <= to)
            most = std::max(most, std::abs(lines.position.y[i] - y));
    return most;
}

TEST(EvenLines, MoveToTheMiddleBetweenNeighbours) {
    const base::Runtime runtime;
    Lines lines(runtime.memory);
    add_line(lines, 0.0, 0.0, 40.0, 1);
    add_line(lines, 0.6, 0.0, 40.0, 3);
    add_line(lines, 2.0, 0.0, 40.0, 2);
    const Lines even = even_out(runtime, lines, 1.0);
    ASSERT_EQ(even.count(), 3);
    EXPECT_LT(farthest_from(even, 1, 1.0, 0.0, 40.0), 0.05);
    // A line with a neighbour on one side only does not move.
    EXPECT_EQ(farthest_from(even, 0, 0.0, 0.0, 40.0), 0.0);
    for (std::int64_t l = 0; l < 3; ++l)
        for (std::int64_t i = even.first[l]; i < even.first[l + 1]; ++i)
            EXPECT_EQ(even.level[i], lines.level[lines.first[l]]);
}

TEST(EvenLines, StayInTheMiddleOfAFan) {
    const base::Runtime runtime;
    Lines lines(runtime.memory);
    // The two lines are 1 apart at one end and 2 at the other.
    add_line(lines, 0.5, 0.0, 60.0, 0, 1.0 / 120.0);
    add_line(lines, -0.5, 0.0, 60.0, 0, -1.0 / 120.0);
    add_line(lines, 0.3, 3.0, 60.0, 1);
    const Lines even = even_out(runtime, lines, 1.0);
    ASSERT_EQ(even.count(), 3);
    EXPECT_LT(farthest_from(even, 2, 0.0, 0.0, 60.0), 0.12);
}

// Adds a line along x that turns to the left by `turn` radians over two separations, and then goes straight on.
void add_turning_line(Lines& lines, double turn) {
    constexpr double step = 0.1;
    glm::dvec2 p(0.0);
    for (double length = 0.0; length <= 40.0; length += step) {
        lines.position.push_back({p.x, p.y, 0.0});
        lines.normal.push_back({0.0, 0.0, 1.0});
        lines.level.push_back(0);
        const double angle = turn * std::clamp((length - 20.0) / 2.0, 0.0, 1.0);
        p += step * glm::dvec2(std::cos(angle), std::sin(angle));
    }
    lines.end_line(false);
}

// The largest angle that a line turns by in two separations.
double most_turn_of(const Lines& lines) {
    const std::int64_t count = lines.position.size();
    double most = 0.0;
    for (std::int64_t i = 0; i + 1 < count; ++i) {
        double way = 0.0;
        const glm::dvec3 first = glm::normalize(lines.position[i + 1] - lines.position[i]);
        for (std::int64_t k = i + 1; k + 1 < count && way < 2.0; ++k) {
            way += glm::distance(lines.position[k], lines.position[k - 1]);
            const glm::dvec3 leg = glm::normalize(lines.position[k + 1] - lines.position[k]);
            most = std::max(most, std::acos(std::min(1.0, glm::dot(first, leg))));
        }
    }
    return most;
}

TEST(EvenLines, TurnSharplyOnlyAroundSingularPoints) {
    const base::Runtime runtime;
    const auto turned = [&](double turn) {
        Lines lines(runtime.memory);
        add_turning_line(lines, turn);
        return even_out(runtime, lines, 1.0);
    };
    constexpr double degree = 0.0174533;
    for (const double kink : {35.0, 50.0, 65.0}) EXPECT_LT(most_turn_of(turned(kink * degree)), 30.0 * degree) << kink;
    // The line goes round a singular point.
    EXPECT_GT(most_turn_of(turned(150.0 * degree)), 90.0 * degree);
    // A line that does not turn much stays where it is.
    Lines lines(runtime.memory);
    add_turning_line(lines, 15.0 * degree);
    const Lines even = even_out(runtime, lines, 1.0);
    EXPECT_NEAR(most_turn_of(even), 15.0 * degree, 2.0 * degree);
}

// Adds a line along x at a distance from y = 0 that falls from 1 to 0.5 between x = 20 and x = 30.
void add_side_of_fork(Lines& lines, double side) {
    for (double x = 0.0; x <= 50.0; x += 0.4) {
        lines.position.push_back({x, side * (1.0 - 0.5 * std::clamp((x - 20.0) / 10.0, 0.0, 1.0)), 0.0});
        lines.normal.push_back({0.0, 0.0, 1.0});
        lines.level.push_back(0);
    }
    lines.end_line(false);
}

// At x = 20 + 10 t the lines at the sides are 2 - t apart, so there is room for the line between them up to t = 0.9.
TEST(EvenLines, AreContinuedIntoForks) {
    const base::Runtime runtime;
    Lines lines(runtime.memory);
    add_side_of_fork(lines, 1.0);
    add_side_of_fork(lines, -1.0);
    add_line(lines, 0.0, 0.0, 26.0, 1);
    const Lines even = even_out(runtime, lines, 1.0);
    ASSERT_EQ(even.count(), 3);
    const glm::dvec3 end = even.position[even.first[3] - 1];
    EXPECT_GT(end.x, 27.9);
    EXPECT_LT(end.x, 29.1);
    EXPECT_LT(farthest_from(even, 2, 0.0, 0.0, 40.0), 0.05);
    EXPECT_EQ(even.level[even.first[3] - 1], 1);
    // A line that ends far away from the fork has wide room beside it, too, but is continued only a little.
    Lines early(runtime.memory);
    add_side_of_fork(early, 1.0);
    add_side_of_fork(early, -1.0);
    add_line(early, 0.0, 0.0, 12.0, 1);
    const Lines a_little = even_out(runtime, early, 1.0);
    EXPECT_LT(a_little.position[a_little.first[3] - 1].x, 16.1);
}

TEST(EvenLines, DoNotMeetOthersWhenContinued) {
    const base::Runtime runtime;
    Lines lines(runtime.memory);
    add_line(lines, 1.0, 0.0, 40.0);
    add_line(lines, -1.0, 0.0, 40.0);
    add_line(lines, 0.0, 0.0, 17.0);
    add_line(lines, 0.0, 21.0, 40.0);
    const Lines even = even_out(runtime, lines, 1.0);
    ASSERT_EQ(even.count(), 4);
    const double between = even.position[even.first[3]].x - even.position[even.first[3] - 1].x;
    EXPECT_GT(between, 0.5);
    EXPECT_LT(between, 3.0);
}

// A line across a narrow face has both ends at the border. It stays, however short it is, if the lines beside it are a
// separation away. Otherwise it is a stray.
TEST(EvenLines, CrossNarrowFaces) {
    const base::Runtime runtime;
    const auto count_of = [&](double y, std::uint8_t border) {
        Lines lines(runtime.memory);
        add_line(lines, 0.0, 0.0, 40.0);
        for (double x = 20.0; x <= 21.7; x += 0.4) lines.add_point({x, y, 0.0}, {0.0, 0.0, 1.0}, 0, base::Progress());
        lines.end_line(false, border);
        return even_out(runtime, lines, 1.0).count();
    };
    EXPECT_EQ(count_of(1.0, Lines::begins_at_border | Lines::ends_at_border), 2);
    EXPECT_EQ(count_of(1.0, Lines::begins_at_border), 1) << "one end at the border";
    EXPECT_EQ(count_of(1.0, 0), 1) << "no end at the border";
    EXPECT_EQ(count_of(0.3, Lines::begins_at_border | Lines::ends_at_border), 1) << "a stray";
}

} // namespace
} // namespace hrbfnpr::hatching::even_lines_test
