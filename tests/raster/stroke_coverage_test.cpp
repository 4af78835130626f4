// SPDX-License-Identifier: MIT
// Compares the part of a pixel that a stroke covers with a plain reference in doubles.
#include "base/random.h"
#include "output/raster/raster.h"
#include "raster/stroke_reference.h"

#include <gtest/gtest.h>

#include <numbers>

namespace hrbfnpr::testing::stroke_coverage_test {
namespace {

using drawing::Cap;
using drawing::Stroke;
using drawing::StrokePoint;

constexpr std::int32_t side = 64;
constexpr std::int32_t stride = side + 16;
constexpr double pi = std::numbers::pi;
constexpr double step = 1.0 / 255.0;

struct Difference {
    double most = 0.0, ink = 0.0, expected_ink = 0.0;
    int x = 0, y = 0;
};

class StrokeCoverage : public ::testing::Test {
protected:
    static StrokePoint point(double x, double y, double radius) {
        StrokePoint p{};
        p.x = static_cast<float>(x);
        p.y = static_cast<float>(y);
        p.radius = static_cast<float>(radius);
        p.opacity = 1.0F;
        return p;
    }
    void begin(Cap cap_begin = Cap::round, Cap cap_end = Cap::round) {
        points.clear();
        stroke = {};
        stroke.cap_begin = cap_begin;
        stroke.cap_end = cap_end;
    }
    void add(double x, double y, double radius) { points.push_back(point(x, y, radius)); }
    // Draws the stroke's part in the tile at (left, top).
    std::vector<float> lay(float left = 0.0F, float top = 0.0F) {
        stroke.count = static_cast<std::int32_t>(points.size());
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t i = 0; i + 1 < points.size(); ++i)
            if (reaches(points[i], points[i + 1], left, top)) numbers.push_back(i);
        std::vector<float> transmittance(stride * side, 1.0F);
        std::vector<float> cover(stride * side, 0.0F);
        std::vector<float> ink(stride * side, 0.0F);
        output::StrokeUnion overlaps(memory);
        const float color[] = {0.0F, 0.0F, 0.0F, 1.0F};
        output::raster_loops(base::InstructionSet::automatic)
            .stroke({side, side, stride, transmittance.data(), {}, nullptr},
                    {points.data(), &stroke, numbers.data(), static_cast<std::int64_t>(numbers.size()), left, top,
                     color, 1.0F},
                    {cover.data(), ink.data(), &overlaps});
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto at = static_cast<std::size_t>(y * stride + x);
                EXPECT_TRUE(cover[at] == 0.0F && ink[at] == 0.0F) << x << " " << y;
            }
        return transmittance;
    }
    Difference compare(float left = 0.0F, float top = 0.0F) {
        const std::vector<float> transmittance = lay(left, top);
        const std::vector<double> expected =
            StrokeReference(points, stroke).coverage(side, static_cast<double>(left), static_cast<double>(top));
        Difference difference;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double own = 1.0 - static_cast<double>(transmittance[static_cast<std::size_t>(y * stride + x)]);
                const double other = expected[static_cast<std::size_t>(y * side + x)];
                difference.ink += own;
                difference.expected_ink += other;
                if (std::abs(own - other) <= difference.most) continue;
                difference.most = std::abs(own - other);
                difference.x = x;
                difference.y = y;
            }
        return difference;
    }
    // Expects agreement within `limit`, by default a step of 255, and keeps the largest difference.
    void expect_exact(const char* what, double limit = step, float left = 0.0F, float top = 0.0F) {
        const Difference difference = compare(left, top);
        EXPECT_LE(difference.most, limit) << what << " ink " << difference.ink << " of " << difference.expected_ink
                                          << " at " << difference.x << " " << difference.y;
        worst = std::max(worst, difference.most);
    }
    void TearDown() override { RecordProperty("worst_of_255", std::to_string(255.0 * worst)); }

    static bool reaches(const StrokePoint& a, const StrokePoint& b, float left, float top) {
        const float reach = 5.0F * std::max(a.radius, b.radius) + 1.0F;
        const float far = static_cast<float>(side) + reach;
        return std::max(a.x, b.x) > left - reach && std::min(a.x, b.x) < left + far &&
               std::max(a.y, b.y) > top - reach && std::min(a.y, b.y) < top + far;
    }

    base::Memory memory;
    std::vector<StrokePoint> points;
    Stroke stroke;
    double worst = 0.0;
};

constexpr double radii[] = {0.1, 0.25, 0.5, 0.7, 1.0, 1.6, 3.0, 6.0};

TEST_F(StrokeCoverage, IsExactForStraightLines) {
    for (const Cap cap : {Cap::round, Cap::flat, Cap::pointed}) {
        for (const double radius : radii) {
            for (int k = 0; k < 24; ++k) {
                begin(cap, cap);
                const double angle = k < 20 ? 2.0 * pi * k / 20.0 : 1e-4 * std::pow(10.0, k - 20);
                const double reach = cap == Cap::pointed ? 12.0 : 22.0;
                const double x = 32.0 + 0.37 * k;
                add(x - reach * std::cos(angle), 31.6 - reach * std::sin(angle), radius);
                add(x + reach * std::cos(angle), 31.6 + reach * std::sin(angle), radius);
                expect_exact(("radius " + std::to_string(radius) + " turn " + std::to_string(k)).c_str());
            }
        }
    }
}

TEST_F(StrokeCoverage, IsExactForTapers) {
    for (int k = 0; k < 20; ++k) {
        const double angle = 0.1 + 2.0 * pi * k / 20.0;
        for (const double radius : {0.6, 2.0, 6.0}) {
            begin(Cap::flat, Cap::round);
            for (int i = 0; i <= 10; ++i) {
                const double at = 5.0 * (i - 5) / 1.2;
                add(32.0 + at * std::cos(angle), 32.0 + at * std::sin(angle), radius * i * (10 - i) / 25.0);
            }
            expect_exact("straight");
        }
    }
}

// Curves of a quarter turn, sampled finely and coarsely.
TEST_F(StrokeCoverage, IsExactForBentLines) {
    for (const int pieces : {3, 6, 12, 40}) {
        for (const double radius : radii) {
            for (int k = 0; k < 5; ++k) {
                for (const double taper : {0.0, 0.5}) {
                    begin();
                    for (int i = 0; i <= pieces; ++i) {
                        const double angle = 0.3 * k + 1.6 * i / pieces;
                        add(10.0 + 35.0 * std::cos(angle), 12.0 + 35.0 * std::sin(angle),
                            radius * (1.0 - taper * std::cos(9.0 * i / pieces)));
                    }
                    expect_exact(("radius " + std::to_string(radius) + " pieces " + std::to_string(pieces) + " taper " +
                                  std::to_string(taper))
                                     .c_str());
                }
            }
        }
    }
}

TEST_F(StrokeCoverage, IsExactForCorners) {
    for (int degrees = -176; degrees <= 176; degrees += 8) {
        for (const double radius : {0.3, 1.0, 2.5}) {
            begin(Cap::flat, Cap::flat);
            const double turn = degrees * pi / 180.0;
            add(8.0, 30.3, radius);
            add(38.4, 33.7, radius);
            add(38.4 + 24.0 * std::cos(turn), 33.7 + 24.0 * std::sin(turn), radius);
            expect_exact(std::to_string(degrees).c_str());
        }
    }
}

// A curve that winds back and forth, over and beside itself.
TEST_F(StrokeCoverage, IsTheUnionOfOverlaps) {
    for (const double radius : {0.4, 1.5, 5.0}) {
        for (int k = 0; k < 8; ++k) {
            begin();
            for (int i = 0; i <= 120; ++i) {
                const double t = 0.05 * i;
                add(32.0 + 20.0 * std::sin(t + 0.1 * k) + 3.0 * std::sin(7.0 * t),
                    32.0 + (2.0 + 2.0 * k) * std::sin(2.0 * t), radius);
            }
            expect_exact("winding");
        }
        begin();
        for (int i = 0; i <= 30; ++i) // a hairpin whose turn is narrower than the stroke
            add(10.0 + 1.3 * std::min(i, 30 - i), 30.0 + 0.05 * i, radius);
        expect_exact("hairpin");
    }
}

// Loops and cusps that are smaller than the pen, so that places are covered three times.
TEST_F(StrokeCoverage, IsTheUnionOfLoopsSmallerThanThePen) {
    for (const double radius : {1.0, 3.0, 7.0}) {
        for (const double size : {0.2, 1.0, 3.0}) {
            begin();
            for (int i = 0; i <= 60; ++i) { // loops along a line
                const double t = 0.35 * i;
                add(8.0 + 0.8 * i + size * std::sin(t), 31.7 + size * std::cos(t), radius);
            }
            expect_exact(("loops " + std::to_string(size)).c_str());
            begin(Cap::pointed, Cap::flat);
            for (int i = -30; i <= 30; ++i) { // the curve (t^2, t^3)
                const double t = i / 30.0;
                add(20.3 + 20.0 * t * t, 32.1 + size * 4.0 * t * t * t, radius * (1.2 - std::abs(t)));
            }
            expect_exact(("cusp " + std::to_string(size)).c_str());
        }
    }
}

TEST_F(StrokeCoverage, IsTheUnionOfThreefoldOverlaps) {
    for (const double radius : {0.3, 2.0, 5.0}) {
        for (const int corners : {3, 5, 7}) { // stars: each line crosses the others
            begin();
            for (int i = 0; i <= 2 * corners; ++i) {
                const double angle = 0.2 + 2.0 * pi * i * ((corners - 1) / 2) / corners;
                add(32.0 + 25.0 * std::cos(angle), 32.0 + 25.0 * std::sin(angle), radius);
            }
            expect_exact("star");
        }
        begin(Cap::flat, Cap::pointed);
        for (int i = 0; i <= 9; ++i) add(i % 2 == 0 ? 10.0 : 54.0, 31.0 + 0.4 * radius * i, radius); // back and forth
        expect_exact("to and fro");
    }
}

// Random strokes whose width varies from point to point, and one with enough lines for a row to be sampled evenly
// instead.
TEST_F(StrokeCoverage, IsTheUnionOfScribbles) {
    const auto number = [](int k, int i, std::size_t which) {
        return base::uniform4(static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(i),
                              base::Purpose::probe)[which];
    };
    for (int k = 0; k < 60; ++k) {
        begin();
        for (int i = 0; i < 12; ++i)
            add(70.0 * number(k, i, 0) - 3.0, 70.0 * number(k, i, 1) - 3.0, 0.2 + 5.0 * number(k, i, 2));
        expect_exact(("scribble " + std::to_string(k)).c_str());
    }
    begin();
    for (int i = 0; i < 700; ++i) add(64.0 * number(99, i, 0), 64.0 * number(99, i, 1), 0.02);
    expect_exact("very many lines");
}

// Where a stroke overlaps itself its opacity counts once. The part that is drawn first sets it.
TEST_F(StrokeCoverage, OverlapsAreNoDarker) {
    begin();
    for (int i = 0; i <= 4; ++i) add(i % 2 == 0 ? 10.0 : 54.0, 31.0 + 0.5 * i, 3.0);
    for (StrokePoint& p : points) p.opacity = 0.5F;
    for (const float left : lay()) EXPECT_GE(left, 0.5F - 1e-5F);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].opacity = i < 2 ? 0.25F : 1.0F;
    const std::vector<float> found = lay();
    EXPECT_NEAR(found[30 * stride + 20], 0.75F, 0.03F); // the first line's opacity, though others pass over it
}

TEST_F(StrokeCoverage, HasNoSeamOnClosedLines) {
    for (const int pieces : {3, 5, 24, 90}) {
        for (const double radius : {0.3, 1.0, 4.0}) {
            begin(Cap::pointed, Cap::flat); // closed lines ignore their caps
            for (int i = 0; i <= pieces; ++i) {
                const double angle = 2.0 * pi * (i % pieces) / pieces;
                add(31.7 + 22.0 * std::cos(angle), 32.2 + 22.0 * std::sin(angle), radius);
            }
            stroke.closed = true;
            expect_exact(std::to_string(pieces).c_str());
        }
    }
}

TEST_F(StrokeCoverage, AcceptsRepeatedPoints) {
    begin(Cap::flat, Cap::flat);
    for (const double x : {5.0, 5.0, 20.0, 20.0, 20.0, 45.0, 45.0}) add(x, 0.7 * x, 2.0);
    expect_exact("straight");
    for (const Cap cap : {Cap::round, Cap::flat}) {
        begin(cap, cap);
        for (int i = 0; i < 4; ++i) add(30.3, 30.6, 3.0);
        if (cap == Cap::round) {
            expect_exact("dot");
        } else {
            for (const float left : lay()) EXPECT_EQ(left, 1.0F);
        }
    }
}

TEST_F(StrokeCoverage, IsExactForLinesThatReachFarOutside) {
    for (int k = 0; k < 32; ++k) {
        for (const double far : {1e3, 1e5, 1e7}) {
            begin();
            // Whole numbers are exact as floats.
            const double x = std::round(far * std::cos(0.2 * k));
            const double y = std::round(far * std::sin(0.2 * k));
            add(32.0 - x, 32.0 - y, 2.5);
            add(32.0 + x, 32.0 + y, 2.5);
            expect_exact(std::to_string(far).c_str());
        }
    }
}

// Each tile finds its own part of the stroke.
TEST_F(StrokeCoverage, ContinuesFromTileToTile) {
    begin(Cap::pointed, Cap::round);
    for (int i = 0; i <= 400; ++i) add(30.0 * i, 6000.0 + 5000.0 * std::sin(0.03 * i), 3.0 + 1.5 * std::sin(0.1 * i));
    int inked = 0;
    for (int row = 0; row < 172; row += 7) {
        for (int column = 0; column < 190; column += 3) {
            const float left = 64.0F * static_cast<float>(column);
            const float top = 64.0F * static_cast<float>(row);
            bool near = false;
            for (std::size_t i = 1; i < points.size(); ++i) near |= reaches(points[i - 1], points[i], left, top);
            if (!near) continue;
            const Difference difference = compare(left, top);
            ASSERT_LE(difference.most, step) << column << " " << row;
            inked += difference.ink > 0.0 ? 1 : 0;
        }
    }
    EXPECT_GT(inked, 20);
}

} // namespace
} // namespace hrbfnpr::testing::stroke_coverage_test
