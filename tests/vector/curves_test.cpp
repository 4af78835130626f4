// SPDX-License-Identifier: MIT
// Tests the lines, arcs and cubics that are fitted to polylines, against shapes that are known.
#include "output/vector/curves.h"

#include "recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace hrbfnpr::testing::curves_test {
namespace {

using glm::dvec2;
using output::CurveLine;
using output::CurvePiece;
using output::CurvePieces;
using output::Curves;
using Kind = CurvePiece::Kind;
using Places = std::vector<dvec2>;

constexpr double pi = std::numbers::pi;
constexpr double tolerance = 0.05;

// Adds places on an arc of a circle, without the last one.
void add_arc(Places& places, const dvec2& centre, double radius, double from, double to, int count) {
    for (int i = 0; i < count; ++i) {
        const double angle = from + (to - from) * i / count;
        places.push_back(centre + radius * dvec2(std::cos(angle), std::sin(angle)));
    }
}

Places slot() { // two half circles of radius 5 and two lines of length 20
    Places places;
    add_arc(places, {20.0, 0.0}, 5.0, -0.5 * pi, 0.5 * pi, 60);
    places.push_back({20.0, 5.0});
    add_arc(places, {0.0, 0.0}, 5.0, 0.5 * pi, 1.5 * pi, 60);
    places.push_back({0.0, -5.0});
    places.push_back(places[0]);
    return places;
}

Places ellipse() {
    Places places;
    for (int i = 0; i <= 400; ++i) places.push_back({20.0 * std::cos(i * pi / 200), 10.0 * std::sin(i * pi / 200)});
    places.back() = places[0];
    return places;
}

// The kinds of the pieces, as letters.
std::string kinds_of(const CurveLine& line) {
    std::string kinds;
    for (const CurvePiece& piece : line.pieces) kinds += "lac"[static_cast<int>(piece.kind)];
    return kinds;
}

// Samples the pieces.
Line sampled(const CurveLine& line) {
    Line points;
    dvec2 at = line.start;
    for (const CurvePiece& piece : line.pieces) {
        const double angle = std::atan2(at.y - piece.centre.y, at.x - piece.centre.x);
        const double radius = glm::distance(at, piece.centre);
        for (int i = 0; i < 64; ++i) {
            const double t = i / 64.0, turned = angle + t * piece.sweep;
            dvec2 p = at + t * (piece.end - at);
            if (piece.kind == Kind::arc) p = piece.centre + radius * dvec2(std::cos(turned), std::sin(turned));
            if (piece.kind == Kind::cubic)
                p = geometry::point_on_cubic(at, {piece.control_1, piece.control_2, piece.end}, t);
            points.push_back({p.x, p.y, 0.0});
        }
        if (piece.kind == Kind::arc) { // the arc ends at its end
            const dvec2 end =
                piece.centre + radius * dvec2(std::cos(angle + piece.sweep), std::sin(angle + piece.sweep));
            EXPECT_LT(glm::distance(end, piece.end), 1e-9);
        }
        at = piece.end;
    }
    points.push_back({at.x, at.y, 0.0});
    return points;
}

double farthest(const Line& from, const Line& to) {
    double most = 0.0;
    for (const output::PagePoint& p : from) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i < to.size(); ++i)
            least =
                std::min(least, geometry::distance_to_segment(dvec2(p.x, p.y), place_of(to[i - 1]), place_of(to[i])));
        most = std::max(most, least);
    }
    return most;
}

Line line_of(const Places& places) {
    Line line;
    for (const dvec2& p : places) line.push_back({p.x, p.y, 0.0});
    return line;
}

class CurvesTest : public ::testing::Test {
protected:
    CurveLine fit(const Places& places, bool closed = false, Curves curves = Curves::arcs) {
        return pieces_.fit(places, tolerance, closed, curves);
    }
    void expect_near(const Places& places, const CurveLine& line) {
        const Line drawn = sampled(line), given = line_of(places);
        EXPECT_LE(farthest(given, drawn), tolerance * 1.001);
        EXPECT_LE(farthest(drawn, given), tolerance * 1.2);
    }
    base::Memory memory_;
    CurvePieces pieces_{memory_};
};

TEST_F(CurvesTest, FindsACircle) {
    Places places;
    add_arc(places, {3.0, 4.0}, 7.0, 1.0, 1.0 + 2.0 * pi, 100);
    places.push_back(places[0]);
    for (const bool for_pen : {false, true}) {
        const CurveLine line = for_pen ? pieces_.fit_arcs(places, tolerance, true) : fit(places, true);
        ASSERT_EQ(kinds_of(line), "a");
        EXPECT_LT(glm::distance(line.pieces[0].centre, dvec2(3.0, 4.0)), 1e-9);
        EXPECT_NEAR(line.pieces[0].sweep, 2.0 * pi, 1e-9);
        EXPECT_LT(glm::distance(line.start, places[0]), 1e-9);
        EXPECT_EQ(line.start, line.pieces[0].end);
    }
}

TEST_F(CurvesTest, FindsAnArcInEitherDirection) {
    for (const double to : {-1.0, 3.0, 5.5}) {
        Places places;
        add_arc(places, {0.0, 0.0}, 12.0, 0.5, to, 80);
        const CurveLine line = fit(places);
        ASSERT_EQ(kinds_of(line), "a") << to;
        EXPECT_NEAR(line.pieces[0].sweep, 79.0 / 80.0 * (to - 0.5), 1e-6);
        EXPECT_EQ(line.start, places[0]);
        EXPECT_EQ(line.pieces[0].end, places.back());
    }
}

// The centre does not follow from the ends, because they are near each other and not exact.
TEST_F(CurvesTest, FindsANearlyFullCircle) {
    Places places;
    add_arc(places, {0.0, 0.0}, 24.0, 0.0, 1.99 * pi, 200);
    for (std::size_t i = 0; i < places.size(); ++i) places[i] *= 1.0 + 0.0008 * std::sin(1.7 * static_cast<double>(i));
    const CurveLine line = fit(places);
    ASSERT_EQ(kinds_of(line), "a");
    EXPECT_LT(glm::length(line.pieces[0].centre), 0.01);
    EXPECT_LE(glm::distance(line.start, places[0]), tolerance);
    expect_near(places, line);
}

TEST_F(CurvesTest, FindsTheLinesAndArcsOfASlot) {
    const CurveLine line = fit(slot(), true);
    const std::string kinds = kinds_of(line);
    EXPECT_TRUE(kinds == "lala" || kinds == "alal") << kinds;
    for (const CurvePiece& piece : line.pieces)
        if (piece.kind == Kind::arc) {
            EXPECT_NEAR(std::abs(piece.sweep), pi, 0.05);
            EXPECT_NEAR(glm::distance(piece.end, piece.centre), 5.0, 0.01);
        }
    expect_near(slot(), line);
}

TEST_F(CurvesTest, KeepsCornersBetweenArcsAndCubics) {
    Places places; // a half circle, a corner, and a part of a parabola
    add_arc(places, {0.0, 0.0}, 5.0, pi, 0.0, 60);
    for (int i = 0; i <= 50; ++i) places.push_back({5.0 + 0.3 * i, 0.02 * i * i * 0.3});
    const CurveLine line = fit(places);
    EXPECT_EQ(kinds_of(line).find('a'), 0U);
    EXPECT_NE(kinds_of(line).find('c'), std::string::npos);
    EXPECT_LT(glm::distance(line.pieces[0].end, dvec2(5.0, 0.0)), 1e-9);
    expect_near(places, line);
}

TEST_F(CurvesTest, DrawsOtherCurvesAsCubics) {
    const CurveLine line = fit(ellipse(), true);
    EXPECT_EQ(kinds_of(line).find_first_not_of('c'), std::string::npos) << kinds_of(line);
    expect_near(ellipse(), line);
}

// Several arcs to one side may stand for any curve that bends ever more, so they are not taken for the curve itself.
TEST_F(CurvesTest, DrawsArcsThatBendMoreAndMoreAsCubics) {
    Places places;
    add_arc(places, {0.0, 0.0}, 10.0, 0.0, 2.0, 100);
    add_arc(places, -4.0 * dvec2(std::cos(2.0), std::sin(2.0)), 14.0, 2.0, 4.0, 100);
    const CurveLine line = fit(places);
    EXPECT_EQ(kinds_of(line).find_first_not_of('c'), std::string::npos) << kinds_of(line);
    EXPECT_GE(line.pieces.size(), 2U);
    expect_near(places, line);
}

TEST_F(CurvesTest, CanDrawEverythingAsCubicsOrLines) {
    EXPECT_EQ(kinds_of(fit(slot(), true, Curves::splines)).find('a'), std::string::npos);
    const CurveLine lines = fit(slot(), true, Curves::lines);
    EXPECT_EQ(kinds_of(lines).find_first_not_of('l'), std::string::npos);
    EXPECT_LT(lines.pieces.size(), 40U);
    expect_near(slot(), lines);
}

TEST_F(CurvesTest, DrawsAWavyEdgeAsALine) {
    Places places;
    for (int i = 0; i <= 100; ++i) places.push_back({0.5 * i, 0.02 * std::sin(0.3 * i)});
    places[0].y = places[100].y = 0.0;
    EXPECT_EQ(kinds_of(fit(places)), "l");
}

// The plainest reference of a pen's arcs: they are near, they are few, and they end where the lines end.
TEST_F(CurvesTest, CoversAnyLineByArcsAndLines) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        for (const KeptPath& path : random_lines(seed, 20, 60.0, 200).paths) {
            Places places;
            for (const output::PagePoint& p : path.points) places.push_back(place_of(p));
            const CurveLine line = pieces_.fit_arcs(places, tolerance, false);
            EXPECT_LE(line.pieces.size(), 3U); // each of these lines bends evenly
            EXPECT_EQ(line.start, places[0]);
            EXPECT_EQ(line.pieces.back().end, places.back());
            expect_near(places, line);
        }
    }
    const std::size_t lines = fit(ellipse(), true, Curves::lines).pieces.size();
    EXPECT_EQ(kinds_of(pieces_.fit_arcs(ellipse(), tolerance, true)).find('c'), std::string::npos);
    EXPECT_LT(2 * pieces_.fit_arcs(ellipse(), tolerance, true).pieces.size(), lines);
    expect_near(ellipse(), pieces_.fit_arcs(ellipse(), tolerance, true));
}

TEST_F(CurvesTest, HasNoPiecesForOnePlace) {
    for (const Curves curves : {Curves::arcs, Curves::splines, Curves::lines}) {
        const CurveLine line = fit({{1.0, 2.0}, {1.0, 2.0}}, false, curves);
        EXPECT_TRUE(line.pieces.empty());
        EXPECT_EQ(line.start, dvec2(1.0, 2.0));
    }
    EXPECT_TRUE(pieces_.fit_arcs(Places{{1.0, 2.0}, {1.0, 2.0}}, tolerance, true).pieces.empty());
}

TEST_F(CurvesTest, SurvivesHostilePlaces) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), huge = 1e300;
    for (const Places& places :
         {Places{{0.0, 0.0}, {nan, 1.0}, {2.0, 2.0}}, Places{{huge, 0.0}, {-huge, 1.0}, {0.0, huge}},
          Places{{0.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}}})
        for (const bool closed : {false, true}) {
            fit(places, closed);
            fit(places, closed, Curves::lines);
            EXPECT_FALSE(pieces_.fit_arcs(places, tolerance, closed).pieces.empty());
        }
}

TEST(ForParts, DividesAnArcEvenly) {
    CurvePiece arc{Kind::arc, {-1.0, 0.0}, {}, {}, {0.0, 0.0}, -pi};
    Places ends;
    output::for_parts(arc, 1.2, [&](const CurvePiece& part) {
        EXPECT_NEAR(part.sweep, -pi / 3.0, 1e-12);
        ends.push_back(part.end);
    });
    ASSERT_EQ(ends.size(), 3U);
    EXPECT_LT(glm::distance(ends[0], dvec2(0.5, -std::sqrt(0.75))), 1e-12);
    EXPECT_EQ(ends[2], arc.end);
}

} // namespace
} // namespace hrbfnpr::testing::curves_test
