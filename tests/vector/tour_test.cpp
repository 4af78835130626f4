// SPDX-License-Identifier: MIT
// Tours against the best ones.
#include "recorder.h"
#include "support/watched_operation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace hrbfnpr::testing {
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
    if (stop.closed) return {stop.points[static_cast<std::size_t>(leg.start)], stop.points[static_cast<std::size_t>(leg.start)]};
    return leg.reversed ? std::pair{stop.points.back(), stop.points.front()}
                        : std::pair{stop.points.front(), stop.points.back()};
}

Result tour_of(const std::vector<Stop>& stops, PagePoint from = {0.0, 100.0, 0.0}) {
    base::Memory memory;
    output::Tour tour(memory);
    const base::Progress progress;
    Result result;
    for (const Leg& leg : tour.find(stops, {from.x, from.y}, progress)) {
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

// The least travel through all open stops: the least to each set of them, by its last one [Held and Karp 1962].
double least_travel(const std::vector<Stop>& stops, const PagePoint& from) {
    const std::size_t n = stops.size();
    const auto end = [&](std::size_t node) { return node % 2 == 0 ? stops[node / 2].points.front() : stops[node / 2].points.back(); };
    // Of (set, node that the pen leaves from).
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

TEST(Tour, IsNearTheBestOfFewLines) {
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
    std::printf("worst %g mean %g\n", worst, sum / trials);
    EXPECT_LE(worst, 1.15);
    EXPECT_LE(sum / trials, 1.01);
}

} // namespace
} // namespace hrbfnpr::testing
