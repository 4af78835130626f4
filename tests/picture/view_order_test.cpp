// SPDX-License-Identifier: MIT
#include "picture/view_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace picture_tests::view_order_test {
namespace {

using namespace hrbfnpr;
using namespace hrbfnpr::picture;

class ViewOrderTest : public testing::Test {
protected:
    // Adds a line that is either wholly hidden or wholly visible.
    ViewCurve& add(std::initializer_list<glm::dvec2> points, bool hidden = false) {
        ViewCurve curve(pool);
        curve.points = points;
        curve.hidden.assign(points.size() - 1, hidden ? 1 : 0);
        curves.push_back(std::move(curve));
        return curves.back();
    }
    // Adds a circle of radius 4 mm that begins at an angle. The first `count` of its 180 pieces are hidden.
    ViewCurve& add_circle(double begin, std::size_t count) {
        ViewCurve curve(pool);
        for (std::size_t i = 0; i <= 180; ++i) {
            const double angle = (begin + 2.0 * static_cast<double>(i)) * std::numbers::pi / 180.0;
            curve.points.push_back(4.0 * glm::dvec2(std::cos(angle), std::sin(angle)));
            if (i < 180) curve.hidden.push_back(i < count ? 1 : 0);
        }
        curve.points.back() = curve.points.front();
        curves.push_back(std::move(curve));
        return curves.back();
    }
    [[nodiscard]] ShownLines shown(bool with_hidden = true) { return draw_in_order(curves, with_hidden, pool); }

    // Returns the least and the largest x of each line, in ascending order.
    [[nodiscard]] static std::vector<std::pair<double, double>> spans(const Vector<PaperLine>& lines) {
        std::vector<std::pair<double, double>> found;
        for (const PaperLine& line : lines) {
            const auto [low, high] =
                std::minmax_element(line.begin(), line.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
            found.emplace_back(low->x, high->x);
        }
        std::sort(found.begin(), found.end());
        return found;
    }
    // Returns the widest angle of a circle, in degrees, in which nothing is drawn.
    [[nodiscard]] static double gap_of(const Vector<PaperLine>& lines) {
        std::vector<double> angles;
        for (const PaperLine& line : lines)
            for (const glm::dvec2& p : line) angles.push_back(std::atan2(p.y, p.x) * 180.0 / std::numbers::pi);
        std::sort(angles.begin(), angles.end());
        if (angles.empty()) return 360.0;
        double widest = angles.front() + 360.0 - angles.back();
        for (std::size_t i = 1; i < angles.size(); ++i) widest = std::max(widest, angles[i] - angles[i - 1]);
        return widest;
    }

    using Spans = std::vector<std::pair<double, double>>;
    base::Memory memory;
    Pool pool{memory};
    Vector<ViewCurve> curves{&pool};
};

TEST_F(ViewOrderTest, EmptyAndTooShortLinesAreNotDrawn) {
    EXPECT_TRUE(shown().outlines.empty());
    add({{0, 0}, {0.5, 0}}); // This line is too short to be drawn.
    add({{7, 7}, {7, 7}});
    EXPECT_TRUE(shown().outlines.empty());
}

TEST_F(ViewOrderTest, TheVisibleOfCoincidentLinesIsDrawn) {
    add({{0, 0.1}, {30, 0.1}}, true);
    add({{0, 0}, {30, 0}});
    add({{15, -10}, {15, 10}}, true); // This line crosses the others.
    const ShownLines lines = shown();
    EXPECT_EQ(spans(lines.outlines), (Spans{{0, 30}}));
    EXPECT_EQ(spans(lines.hidden), (Spans{{15, 15}}));
    EXPECT_TRUE(shown(false).hidden.empty());
}

TEST_F(ViewOrderTest, TheLowestRankOfVisibleLinesIsDrawn) {
    add({{0, 0.1}, {30, 0.1}}).rank = 2;
    add({{0, 0.2}, {20, 0.2}}).rank = 1;
    const ShownLines lines = shown();
    ASSERT_FALSE(lines.outlines.empty());
    EXPECT_EQ(lines.outlines[0].front().y, 0.2);
    for (const PaperLine& line : lines.outlines)
        if (line.front().y == 0.1) {
            EXPECT_GT(spans({{line}, &pool})[0].first, 19.0);
        }
}

TEST_F(ViewOrderTest, SmoothLinesAreDrawnWhereTheyAreVisible) {
    add({{0, 0}, {30, 0}}, true).of_class = ViewClass::smooth;
    add({{0, 5}, {30, 5}}).of_class = ViewClass::smooth;
    const ShownLines lines = shown();
    EXPECT_EQ(spans(lines.smooth), (Spans{{0, 30}}));
    EXPECT_TRUE(lines.hidden.empty() && lines.outlines.empty());
}

TEST_F(ViewOrderTest, VisibleTangentEdgesComeBeforeHiddenEdges) {
    add({{0, 0}, {30, 0}}).of_class = ViewClass::tangent;
    add({{0, 0.1}, {30, 0.1}}, true);
    add({{0, 5}, {30, 5}}, true).of_class = ViewClass::tangent;
    add({{0, 10}, {30, 10}}).of_class = ViewClass::tangent;
    add({{-5, 10.1}, {20, 10.1}});
    const ShownLines lines = shown();
    EXPECT_TRUE(lines.hidden.empty());
    EXPECT_EQ(spans(lines.outlines), (Spans{{-5, 20}}));
    const Spans found = spans(lines.tangent);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0], (std::pair{0.0, 30.0}));
    EXPECT_NEAR(found[1].first, 20.0, 0.5);
    EXPECT_EQ(found[1].second, 30.0);
}

TEST_F(ViewOrderTest, ShortenedLinesTouchNothing) {
    const Vector<PaperLine> lines({{{0, 0}, {10, 0}, {30, 0}}, {{0, 0}, {2, 0}}, {{0, 0}, {4, 0}, {0, 4}, {0, 0}}},
                                  &pool);
    const Vector<PaperLine> made = shortened(lines, 1.5, pool);
    ASSERT_EQ(made.size(), 3U);
    EXPECT_EQ(made[0], (PaperLine({{1.5, 0}, {10, 0}, {28.5, 0}}, &pool)));
    EXPECT_EQ(made[1], (PaperLine({{0.5, 0}, {1.5, 0}}, &pool)));
    EXPECT_EQ(made[2], lines[2]);
}

TEST_F(ViewOrderTest, HiddenLinesAreLeftOutAlongShortVisibleOnes) {
    add({{0, 0}, {30, 0}}, true);
    add({{13, 0.1}, {17, 0.1}});
    const Spans found = spans(shown().hidden);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].second, 13.0, 0.5);
    EXPECT_NEAR(found[1].first, 17.0, 0.5);
}

TEST_F(ViewOrderTest, AHiddenCircleIsLeftOutBesideAVisibleArc) {
    add_circle(0.0, 90); // Its first half is hidden.
    add_circle(1.0, 180).points.resize(136);
    curves.back().hidden.resize(135); // A hidden arc of 270 degrees, on the same circle.
    const ShownLines lines = shown();
    double hidden = 0.0;
    for (const PaperLine& line : lines.hidden) hidden += length_of_line(line);
    EXPECT_NEAR(hidden, 4.0 * std::numbers::pi, 1.5);
}

TEST_F(ViewOrderTest, LinesThatContinueEachOtherHaveNoGap) {
    add({{0, 0}, {10, 0}});
    add({{10, 0}, {20, 0}});
    EXPECT_EQ(spans(shown().outlines), (Spans{{0, 10}, {10, 20}}));
}

TEST_F(ViewOrderTest, ShortGapsAreBridged) {
    for (const auto& [from, to] : Spans{{0, 10}, {11, 20}, {24, 30}}) add({{from, 0}, {to, 0}});
    EXPECT_EQ(spans(shown().outlines), (Spans{{0, 20}, {24, 30}}));
}

TEST_F(ViewOrderTest, ACircleHasNoGapWhereItBegins) {
    add_circle(20.0, 2);
    EXPECT_LT(gap_of(shown().outlines), 2.1);
}

TEST_F(ViewOrderTest, TwoHalvesOfACircleHaveNoGap) {
    // The upper rim of a hole is visible from 0 to 240 degrees, the lower rim from -120 to 200 degrees.
    for (const std::size_t i : {0U, 1U}) {
        ViewCurve& rim = add_circle(i == 0 ? 0.0 : -120.0, i == 0 ? 120 : 160);
        for (std::uint8_t& hidden : rim.hidden) hidden = static_cast<std::uint8_t>(1 - hidden);
    }
    EXPECT_LT(gap_of(shown().outlines), 2.1);
}

TEST_F(ViewOrderTest, ShortPartsBeforeALongerLineAreDrawnOnce) {
    ViewCurve behind(pool);
    for (int i = 0; i <= 80; ++i) {
        behind.points.emplace_back(0.5 * i, 0.0);
        if (i < 80) behind.hidden.push_back(i >= 20 && i < 29 ? 0 : 1);
    }
    curves.push_back(std::move(behind));
    add({{5, 0}, {35, 0}});
    EXPECT_EQ(spans(shown().outlines), (Spans{{5, 35}}));
}

TEST_F(ViewOrderTest, ShortFlickerTakesTheStateAroundIt) {
    ViewCurve& curve = add({{0, 0}, {10, 0}, {11.5, 0}, {20, 0}});
    curve.hidden[1] = 1;
    EXPECT_EQ(steady(curve, pool), (Flags{{0, 0, 0}, &pool}));
    ViewCurve& longer = add({{0, 0}, {10, 0}, {12.5, 0}, {20, 0}});
    longer.hidden[1] = 1;
    EXPECT_EQ(steady(longer, pool), longer.hidden);
    // The curve turns back, and another line continues.
    ViewCurve& cusp = add({{0, 0}, {10, 0}, {10.7, 0}, {10.1, 0}, {0, 1}});
    cusp.hidden[1] = cusp.hidden[2] = 1;
    EXPECT_EQ(steady(cusp, pool), cusp.hidden);
}

TEST_F(ViewOrderTest, LinesMatchAReference) { // A reference program in Python drew these points.
    add({{0, 0}, {12, 0}, {12, 7}}).hidden[1] = 1;
    add({{3, 0.2}, {9, 0.2}, {9, 6}}).rank = 2;
    const ShownLines lines = shown();
    ASSERT_EQ(lines.outlines.size(), 2U);
    EXPECT_EQ(lines.outlines[0], (PaperLine{{{0, 0}, {12, 0}}, &pool}));
    EXPECT_EQ(lines.outlines[1], (PaperLine{{{8.67594936708861, 0.2}, {9, 0.2}, {9, 6}}, &pool}));
    EXPECT_EQ(lines.hidden.size(), 1U);
    EXPECT_EQ(lines.hidden[0], (PaperLine{{{12, 0}, {12, 7}}, &pool}));
}

} // namespace
} // namespace picture_tests::view_order_test
