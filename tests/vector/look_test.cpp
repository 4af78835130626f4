// SPDX-License-Identifier: MIT
// That no stage goes on for long without a look at its operation: the calls of a callback are counted, which come with
// every look.
#include "output/vector/plot_lines.h"
#include "recorder.h"

#include <gtest/gtest.h>

#include <functional>

namespace hrbfnpr::testing::look_test {
namespace {

constexpr int many = 100000;

std::int64_t looks_of(const std::function<void(const base::Progress&)>& work) {
    std::int64_t calls = 0;
    const auto count = [](void* user, double) {
        ++*static_cast<std::int64_t*>(user);
        return std::int32_t{0};
    };
    base::Operation operation;
    operation.set_callback(count, &calls);
    operation.begin();
    work(base::Progress(&operation));
    return calls;
}

std::vector<glm::dvec2> places(int count) {
    Random random(5);
    std::vector<glm::dvec2> result(static_cast<std::size_t>(count));
    for (glm::dvec2& place : result) {
        place.x = random();
        place.y = random();
    }
    return result;
}

// So many lines, each from where the one before it ends.
output::PlotLines chained(base::Memory& memory, int count) {
    output::PlotLines lines(memory);
    for (int i = 0; i < count; ++i) {
        output::PlotLine line;
        line.first = lines.points.size();
        line.count = 2;
        line.width = 0.3;
        for (int k = 0; k < 2; ++k) lines.points.push_back({1.0 * (i + k), 0.0, 0.1});
        lines.lines.push_back(line);
    }
    return lines;
}

TEST(Looks, AreManyWhereLinesAreJoined) {
    std::int64_t joined = 0;
    const std::int64_t looks = looks_of([&](const base::Progress& progress) {
        base::Memory memory;
        output::PlotLines lines = chained(memory, many);
        joined = output::join_lines(lines, 0.0, true, progress);
    });
    EXPECT_EQ(joined, many - 1);
    // Six loops over the lines, one of them over their ends, two over pairs; sorting; the tree of the ends.
    EXPECT_GE(looks, 9 * many / 1024 + 4 * many / 65536 + 15 * 2 * many / 16384 - 20);
}

TEST(Looks, AreManyOnTours) {
    const std::vector<glm::dvec2> points = places(20000);
    std::vector<output::PagePoint> page;
    for (const glm::dvec2& p : points) page.push_back({100.0 * p.x, 100.0 * p.y, 0.1});
    std::vector<output::Stop> stops;
    for (const output::PagePoint& p : page) stops.push_back({{&p, 1}, false});
    std::size_t legs = 0;
    const std::int64_t looks = looks_of([&](const base::Progress& progress) {
        base::Memory memory;
        legs = static_cast<std::size_t>(output::find_tour(memory, stops, {0.0, 0.0}, progress).size());
    });
    EXPECT_EQ(legs, stops.size());
    // The work of kicks is used up, and looked at each 100 000 steps.
    EXPECT_GE(looks, 2000 * 20000 / 100000 + 3 * 20000 / 512);
}

TEST(Looks, AreManyWhileAGroupIsTakenAndHandedOn) {
    const GroupInput input = random_lines(3, 5000, 3.0);
    const std::int64_t looks = looks_of([&](const base::Progress& progress) {
        base::Memory memory;
        Recorder out;
        output::PageCounts counts;
        const auto order = output::plot_order(memory, out, plotter_settings(), counts, nullptr, progress);
        input.hand_to(*order);
    });
    EXPECT_GE(looks, 3 * 4900 / 64 + 5000 * 2000 / 100000);
}

TEST(Looks, AreManyWhereLinesAreFilled) {
    const std::int64_t looks = looks_of([&](const base::Progress& progress) {
        base::Memory memory;
        output::PlotLines lines = chained(memory, 1000);
        for (output::PagePoint& p : lines.points) p.radius = 1.0;
        EXPECT_EQ(output::fill_lines(lines, 0.05, progress), 1000);
    });
    EXPECT_GE(looks, 1000);
}

} // namespace
} // namespace hrbfnpr::testing::look_test
