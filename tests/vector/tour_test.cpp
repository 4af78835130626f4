// SPDX-License-Identifier: MIT
// Compares tours with the best ones.
#include "output/vector/plot_lines.h"
#include "recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace hrbfnpr::testing::tour_test {
namespace {

using output::Leg;
using output::PagePoint;
using output::Stop;

struct Result {
    std::vector<Leg> legs;
    double travel = 0.0;
};

std::vector<Stop> stops_of(const GroupInput& input) {
    std::vector<Stop> stops;
    for (const KeptPath& path : input.paths) stops.push_back({path.points, path.closed});
    return stops;
}

std::pair<PagePoint, PagePoint> ends_of(const Stop& stop, const Leg& leg) {
    if (stop.closed)
        return {stop.points[static_cast<std::size_t>(leg.start)], stop.points[static_cast<std::size_t>(leg.start)]};
    return leg.reversed ? std::pair{stop.points.back(), stop.points.front()}
                        : std::pair{stop.points.front(), stop.points.back()};
}

Result tour_of(const std::vector<Stop>& stops, PagePoint from = {0.0, 100.0, 0.0}) {
    base::Memory memory;
    const base::Progress progress;
    Result result;
    for (const Leg& leg : output::find_tour(memory, stops, {from.x, from.y}, progress)) {
        result.legs.push_back(leg);
        const auto [first, last] = ends_of(stops[static_cast<std::size_t>(leg.stop)], leg);
        result.travel += between(from, first);
        from = last;
    }
    return result;
}

void expect_each_once(const Result& result, std::size_t count) {
    std::set<std::int32_t> seen;
    for (const Leg& leg : result.legs) seen.insert(leg.stop);
    EXPECT_EQ(result.legs.size(), count);
    EXPECT_EQ(seen.size(), count);
}

// Returns the least travel through all open stops. For each set of stops and each last one, it keeps the least travel
// [Held and Karp 1962].
double least_travel(const std::vector<Stop>& stops, const PagePoint& from) {
    const std::size_t n = stops.size();
    const auto end = [&](std::size_t node) {
        return node % 2 == 0 ? stops[node / 2].points.front() : stops[node / 2].points.back();
    };
    // The index is a set and the node from which the pen leaves.
    std::vector<double> least((std::size_t{1} << n) * 2 * n, std::numeric_limits<double>::infinity());
    for (std::size_t node = 0; node < 2 * n; ++node)
        least[(std::size_t{1} << node / 2) * 2 * n + (node ^ 1)] = between(from, end(node));
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t set = 1; set < std::size_t{1} << n; ++set)
        for (std::size_t at = 0; at < 2 * n; ++at) {
            const double so_far = least[set * 2 * n + at];
            if (set + 1 == std::size_t{1} << n) best = std::min(best, so_far);
            for (std::size_t node = 0; node < 2 * n; ++node) {
                if ((set >> node / 2 & 1) != 0) continue;
                double& there = least[(set | std::size_t{1} << node / 2) * 2 * n + (node ^ 1)];
                there = std::min(there, so_far + between(end(at), end(node)));
            }
        }
    return best;
}

TEST(Tour, IsNearlyOptimalForFewLines) {
    double worst = 1.0, sum = 0.0;
    constexpr int trials = 200;
    for (int seed = 0; seed < trials; ++seed) {
        const GroupInput input = random_lines(static_cast<std::uint64_t>(seed), 8, 30.0);
        const std::vector<Stop> stops = stops_of(input);
        const Result result = tour_of(stops);
        expect_each_once(result, 8);
        const double ratio = result.travel / least_travel(stops, {0.0, 100.0, 0.0});
        EXPECT_GE(ratio, 1.0 - 1e-12);
        worst = std::max(worst, ratio);
        sum += ratio;
    }
    EXPECT_LE(worst, 1.05);
    EXPECT_LE(sum / trials, 1.001);
}

TEST(Tour, AcceptsOneStopOrNoStops) {
    EXPECT_EQ(tour_of({}).legs.size(), 0U);
    const Line line{{10.0, 100.0, 0.1}, {30.0, 100.0, 0.1}};
    Result result = tour_of({{line, false}});
    ASSERT_EQ(result.legs.size(), 1U);
    EXPECT_EQ(result.legs.at(0).reversed, false);
    EXPECT_DOUBLE_EQ(result.travel, 10.0);
    result = tour_of({{line, false}}, {50.0, 100.0, 0.0});
    EXPECT_EQ(result.legs.at(0).reversed, true);
    EXPECT_DOUBLE_EQ(result.travel, 20.0);
}

// The best tour through n random places in a square of side a has a length of about 0.7124 a sqrt(n) [Beardwood, Halton
// and Hammersley 1959]. 2-opt and Or-opt alone end 5 % above it, greedy tours 25 %.
TEST(Tour, IsNearlyOptimalForManyDots) {
    constexpr int count = 5000;
    Random random(3);
    std::vector<PagePoint> dots;
    for (int i = 0; i < count; ++i) {
        const double x = 100.0 * random();
        dots.push_back({x, 100.0 * random(), 0.1});
    }
    std::vector<Stop> stops;
    for (const PagePoint& dot : dots) stops.push_back({{&dot, 1}, false});
    const Result result = tour_of(stops);
    expect_each_once(result, count);
    EXPECT_LT(result.travel, 1.06 * 0.7124 * 100.0 * std::sqrt(count));
}

// Many distances are equal, and most stops would share one cell of a grid.
TEST(Tour, IsFastForCoincidentStops) {
    Line places;
    for (int i = 0; i < 20000; ++i) places.push_back({i % 2 == 0 ? 50.0 : 50.0 + 1e-7 * (i % 100), 50.0, 0.1});
    places.push_back({1e6, 1e6, 0.1});
    std::vector<Stop> stops;
    for (const PagePoint& place : places) stops.push_back({{&place, 1}, false});
    expect_each_once(tour_of(stops), places.size());
}

TEST(Tour, StartsClosedLinesAtTheirBestPoints) {
    // Two squares of many points are beside each other. The way between them is straight.
    const auto square = [](double x) {
        Line line;
        const double side = 20.0;
        for (int i = 0; i <= 400; ++i) {
            const double at = 0.01 * (i % 400);
            const int edge = static_cast<int>(at);
            const double t = side * (at - edge);
            line.push_back(edge == 0   ? PagePoint{x + t, 50.0, 0.1}
                           : edge == 1 ? PagePoint{x + side, 50.0 + t, 0.1}
                           : edge == 2 ? PagePoint{x + side - t, 70.0, 0.1}
                                       : PagePoint{x, 70.0 - t, 0.1});
        }
        return line;
    };
    const Line left = square(10.0), right = square(60.0);
    const Result result = tour_of({{right, true}, {left, true}});
    ASSERT_EQ(result.legs.size(), 2U);
    EXPECT_EQ(result.legs.at(0).stop, 1);
    // The best tour passes through one point of each square, such as the lower left corner of the first.
    double best = 1e9;
    for (const PagePoint& a : left)
        for (const PagePoint& b : right) best = std::min(best, between({0.0, 100.0, 0.0}, a) + between(a, b));
    EXPECT_LT(result.travel, 1.02 * best);
}

} // namespace
} // namespace hrbfnpr::testing::tour_test
