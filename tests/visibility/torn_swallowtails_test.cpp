// SPDX-License-Identifier: MIT
// Tests groups of cusps that are too small to be seen, with events made by hand.
#include "visibility/invisibility.h"

#include "support/runtime.h"

#include <gtest/gtest.h>

#include <vector>

namespace hrbfnpr::visibility::torn_swallowtails_test {
namespace {

constexpr double size = 0.25;

// A single line of 100 pieces, each one pixel long.
class TornSwallowtailFilter : public testing::TestWithParam<bool> {
protected:
    TornSwallowtailFilter() : lines(runtime.memory) {
        for (std::int32_t i = 0; i < 100; ++i) {
            lines.pieces.push_back({0, 0, i, (i + 1) % 100});
            lines.points.push_back({{static_cast<double>(i), 0.0}, i, 0.0});
        }
        lines.points.push_back({{100.0, 0.0}, 99, 1.0});
        lines.lines.push_back({0, 0, 0, 100, 0, 101, GetParam()});
    }
    [[nodiscard]] Event cusp(double at, int change) const { return event(at, change, -1); }
    // A nearer branch of the line, at `near`, crosses it at `at`.
    [[nodiscard]] Event crossed(double at, int change, double near) const {
        Event e = event(at, change, static_cast<std::int32_t>(near));
        e.near_share = near - e.near_piece;
        return e;
    }
    [[nodiscard]] std::vector<double> kept(const std::vector<Event>& events) {
        const LineLengths lengths(runtime.memory, lines);
        const base::Array<Event> left =
            without_torn_swallowtails(runtime.memory, lines.lines[0], lengths, size, events);
        std::vector<double> at;
        for (const Event& e : left) at.push_back(e.at);
        return at;
    }

    base::Runtime runtime;
    ImageLines lines;

private:
    [[nodiscard]] static Event event(double at, int change, std::int32_t near) {
        const auto piece = static_cast<std::int32_t>(at);
        return {piece, at - piece, change, near, at};
    }
};

using At = std::vector<double>;

TEST_P(TornSwallowtailFilter, KeepsDistantCusps) {
    EXPECT_EQ(kept({cusp(20.5, 1), cusp(21.0, 1), cusp(60.0, 1)}), (At{20.5, 21.0, 60.0}));
    EXPECT_EQ(kept({cusp(20.5, 1)}), At{20.5});
    EXPECT_EQ(kept({}), At{});
}

// A complete swallowtail: the crossing hides the line, and the two cusps show it again.
TEST_P(TornSwallowtailFilter, KeepsBalancedEvents) {
    EXPECT_EQ(kept({cusp(50.1, 1), cusp(50.3, -1)}), (At{50.1, 50.3}));
    EXPECT_EQ(kept({crossed(49.9, 2, 50.6), cusp(50.1, -1), cusp(50.3, -1)}), (At{49.9, 50.1, 50.3}));
}

// The crossing was missed, or found twice.
TEST_P(TornSwallowtailFilter, DropsUnbalancedEvents) {
    EXPECT_EQ(kept({cusp(50.1, -1), cusp(50.3, -1)}), At{});
    EXPECT_EQ(kept({crossed(49.8, 2, 50.6), crossed(49.9, 2, 50.6), cusp(50.1, -1), cusp(50.3, -1)}), At{});
    EXPECT_EQ(kept({cusp(10.0, 1), cusp(50.1, -1), cusp(50.3, -1), cusp(80.0, 1)}), (At{10.0, 80.0}));
}

// If the number of cusps is odd, one remains.
TEST_P(TornSwallowtailFilter, KeepsOneOfThreeUnbalancedCusps) {
    EXPECT_EQ(kept({cusp(50.1, -1), cusp(50.3, -1), cusp(50.5, 1)}), At{50.5});
    EXPECT_EQ(kept({cusp(50.1, 1), cusp(50.3, -1), cusp(50.5, 1)}), (At{50.1, 50.3, 50.5}));
}

// Crossings with other lines, or with a distant branch of the line itself, stay.
TEST_P(TornSwallowtailFilter, KeepsCrossingsWithOtherLines) {
    EXPECT_EQ(kept({crossed(50.0, 2, 150.0), cusp(50.1, -1), crossed(50.2, -2, 90.0), cusp(50.3, -1)}),
              (At{50.0, 50.2}));
}

// A larger swallowtail beside a small one has a crossing of its own.
TEST_P(TornSwallowtailFilter, KeepsCrossingsOfTheNextSwallowtail) {
    const std::vector<Event> next{crossed(50.8, 2, 52.2), cusp(51.1, -1), cusp(51.9, -1)};
    std::vector<Event> whole{crossed(49.9, 2, 50.6), cusp(50.1, -1), cusp(50.3, -1)};
    std::vector<Event> torn{cusp(50.1, -1), cusp(50.3, -1)};
    for (std::vector<Event>* events : {&whole, &torn}) events->insert(events->end(), next.begin(), next.end());
    EXPECT_EQ(kept(whole), (At{49.9, 50.1, 50.3, 50.8, 51.1, 51.9}));
    EXPECT_EQ(kept(torn), (At{50.8, 51.1, 51.9}));
}

INSTANTIATE_TEST_SUITE_P(Lines, TornSwallowtailFilter, testing::Bool(),
                         [](const auto& of) { return of.param ? "Closed" : "Open"; });

// The group spans the end of a closed line, which goes on at its beginning.
class TornSwallowtailFilterOnClosedLines : public TornSwallowtailFilter {};
INSTANTIATE_TEST_SUITE_P(Lines, TornSwallowtailFilterOnClosedLines, testing::Values(true));

TEST_P(TornSwallowtailFilterOnClosedLines, WorksAcrossTheSeam) {
    EXPECT_EQ(kept({cusp(0.1, -1), cusp(40.0, 1), cusp(99.95, -1)}), At{40.0});
    EXPECT_EQ(kept({cusp(0.1, 1), cusp(40.0, 1), cusp(99.95, -1)}), (At{0.1, 40.0, 99.95}));
    EXPECT_EQ(kept({cusp(0.1, -1), crossed(0.3, 2, 99.0), cusp(99.95, -1)}), (At{0.1, 0.3, 99.95}));
    EXPECT_EQ(kept({cusp(0.1, -1), crossed(0.3, 4, 99.0), cusp(99.95, -1)}), At{});
}

class TornSwallowtailFilterOnOpenLines : public TornSwallowtailFilter {};
INSTANTIATE_TEST_SUITE_P(Lines, TornSwallowtailFilterOnOpenLines, testing::Values(false));

TEST_P(TornSwallowtailFilterOnOpenLines, DoesNotWorkAcrossTheEnds) {
    EXPECT_EQ(kept({cusp(0.1, -1), cusp(40.0, 1), cusp(99.95, -1)}), (At{0.1, 40.0, 99.95}));
}

} // namespace
} // namespace hrbfnpr::visibility::torn_swallowtails_test
