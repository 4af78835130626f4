// SPDX-License-Identifier: MIT
// Tests curves in which two surfaces cross, against curves that are known exactly.
#include "features/intersections.h"

#include "support/analytic.h"
#include "support/runtime.h"
#include "support/sharp_shapes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

namespace hrbfnpr::curves::intersections_test {
namespace {

constexpr double pi = std::numbers::pi;
const glm::dmat4 in_place(1.0);

base::Runtime& runtime() {
    static base::Runtime two = test::with_threads(2);
    return two;
}

LineSet lines_of(const implicit::Implicit& surface, double side, const base::Runtime& by = runtime()) {
    LineSetSettings settings;
    settings.side = side;
    return {by, surface, std::make_unique<implicit::DifferencedShape>(surface), settings};
}

glm::dmat4 moved(const glm::dvec3& by) { return glm::translate(glm::dmat4(1.0), by); }

double length_of(const Curves& curves) {
    double length = 0.0;
    for_pieces(curves, [&](std::int64_t a, std::int64_t b) {
        const CubicPiece piece(curves.point[a], curves.point[b]);
        for (int k = 0; k < 8; ++k) length += glm::distance(piece.at(k / 8.0), piece.at((k + 1) / 8.0));
    });
    return length;
}

double distance_to(const Curves& curves, const glm::dvec3& place) {
    double least = HUGE_VAL;
    for_pieces(curves, [&](std::int64_t a, std::int64_t b) {
        const CubicPiece piece(curves.point[a], curves.point[b]);
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 p = piece.at(k / 8.0);
            const glm::dvec3 way = piece.at((k + 1) / 8.0) - p;
            const double share = std::clamp(glm::dot(place - p, way) / glm::dot(way, way), 0.0, 1.0);
            least = std::min(least, glm::distance(place, p + share * way));
        }
    });
    return least;
}

// Expects that the curves are the exact curve, once: all of it is near them, they are as long as it is, and all their
// points are on both surfaces. `exact` maps the numbers from 0 to 1 to the places of the exact curve.
void expect_curve(const Curves& curves, const std::function<glm::dvec3(double)>& exact, double side) {
    double length = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 place = exact(i / 1000.0);
        length += glm::distance(place, exact((i + 1) / 1000.0));
        if (i % 10 == 0) {
            EXPECT_LE(distance_to(curves, place), 2e-3 * side) << i;
        }
    }
    EXPECT_NEAR(length_of(curves), length, 1e-3 * length);
}

// Returns the largest distance of a point of the curves from the zero set of a function, which is a distance near it.
double farthest(const Curves& curves, const implicit::Implicit& surface, const glm::dmat4& to_surface = in_place) {
    double most = 0.0;
    for (const CurvePoint& p : curves.point) {
        const glm::dvec3 place(to_surface * glm::dvec4(p.position, 1.0));
        double value = 0.0;
        surface.evaluate({&place.x, &place.y, &place.z, 1}, {&value, {}, {}});
        most = std::max(most, std::abs(value));
    }
    return most;
}

TEST(Intersections, TwoSpheresCrossInACircle) {
    const test::Sphere ball(1.0);
    const test::Sphere other(0.8);
    for (const double side : {0.2, 0.1}) {
        const LineSet a = lines_of(ball, side);
        const LineSet b = lines_of(other, 0.13);
        const glm::dmat4 to_other = moved({-1.0, 0.0, 0.0});
        const Intersections found = find_intersections(runtime(), a, b, to_other);
        ASSERT_EQ(found.curves.count(), 1);
        EXPECT_EQ(found.curves.closed[0], 1);
        EXPECT_EQ(found.broken, 0);
        const double x = 0.5 * (1.0 + 1.0 - 0.64);
        const double r = std::sqrt(1.0 - x * x);
        expect_curve(
            found.curves,
            [&](double t) { return glm::dvec3(x, r * std::cos(2.0 * pi * t), r * std::sin(2.0 * pi * t)); }, side);
        EXPECT_LE(farthest(found.curves, ball), 1e-6);
        EXPECT_LE(farthest(found.curves, other, to_other), 1e-6);
        // The law of cosines gives the angle between the two radii at a place of the circle.
        EXPECT_NEAR(found.angle[0], std::acos((1.0 + 0.64 - 1.0) / 1.6) * 180.0 / pi, 0.1);
    }
}

TEST(Intersections, BoxesThatAreApartAreNotSearched) {
    const test::Sphere ball(1.0);
    const LineSet a = lines_of(ball, 0.2);
    EXPECT_FALSE(may_intersect(a, a, moved({2.1, 0.0, 0.0})));
    EXPECT_TRUE(may_intersect(a, a, moved({1.9, 0.0, 0.0})));
    EXPECT_EQ(find_intersections(runtime(), a, a, moved({1.5, 1.5, 0.0})).curves.count(), 0);
}

TEST(Intersections, ASheetThatEndsInsideABallCutsItInArcs) {
    const test::Sphere ball(1.0);
    const test::Plane sheet({0.0, 0.0, 1.0}, 0.3, {{-2.0, -0.5, 0.0}, {2.0, 0.5, 0.6}});
    const LineSet a = lines_of(ball, 0.1);
    const LineSet b = lines_of(sheet, 0.1);
    const geometry::Bounds& region = b.mesh().region;
    const Intersections found = find_intersections(runtime(), a, b, in_place);
    EXPECT_EQ(found.curves.count(), 2);
    const double r = std::sqrt(1.0 - 0.09);
    EXPECT_NEAR(length_of(found.curves), 4.0 * r * std::asin(region.max.y / r), 1e-3);
    for (const CurvePoint& p : found.curves.point) EXPECT_LE(std::abs(p.position.y), region.max.y + 1.1e-4);
    // The same on the mesh of the sheet.
    const Intersections turned = find_intersections(runtime(), b, a, in_place);
    EXPECT_EQ(turned.curves.count(), 2);
    EXPECT_EQ(turned.broken + found.broken, 0);
    EXPECT_NEAR(length_of(turned.curves), length_of(found.curves), 1e-3);
}

// A pipe that a thinner one crosses at a right angle: two loops.
TEST(Intersections, PipesOfTwoWidthsCrossInTwoLoops) {
    const test::Cylinder thin(0.6, 2.0);
    const test::Cylinder wide(1.0, 2.0);
    const LineSet a = lines_of(thin, 0.1);
    const LineSet b = lines_of(wide, 0.14);
    const glm::dmat4 to_other = glm::rotate(glm::dmat4(1.0), 0.5 * pi, glm::dvec3(1.0, 0.0, 0.0));
    const Intersections found = find_intersections(runtime(), a, b, to_other);
    ASSERT_EQ(found.curves.count(), 2);
    Curves upper(runtime().memory);
    for (std::int64_t c = 0; c < 2; ++c) {
        EXPECT_EQ(found.curves.closed[c], 1);
        if (found.curves.point[found.curves.first[c]].position.z < 0.0) continue;
        for (std::int64_t i = found.curves.first[c]; i < found.curves.first[c + 1]; ++i)
            upper.point.push_back(found.curves.point[i]);
        upper.end(true);
    }
    ASSERT_EQ(upper.count(), 1);
    expect_curve(
        upper,
        [](double t) {
            const double x = 0.6 * std::cos(2.0 * pi * t);
            return glm::dvec3(x, 0.6 * std::sin(2.0 * pi * t), std::sqrt(1.0 - x * x));
        },
        0.1);
}

// Two equal pipes cross in two ellipses, which cross each other where both surfaces touch.
TEST(Intersections, EqualPipesCrossInTwoEllipses) {
    const test::Cylinder pipe(1.0, 2.0);
    const glm::dmat4 to_other = glm::rotate(glm::dmat4(1.0), 0.5 * pi, glm::dvec3(1.0, 0.0, 0.0));
    const LineSet a = lines_of(pipe, 0.1);
    const Intersections found = find_intersections(runtime(), a, a, to_other);
    EXPECT_EQ(found.broken, 0);
    double length = 0.0;
    for (const double way : {-1.0, 1.0})
        for (int i = 0; i < 1000; ++i) {
            const auto exact = [&](double t) { return glm::dvec3(std::cos(t), std::sin(t), way * std::sin(t)); };
            const double t = 2.0 * pi * i / 1000.0;
            length += glm::distance(exact(t), exact(t + 2.0 * pi / 1000.0));
            EXPECT_LE(distance_to(found.curves, exact(t)), 1e-3) << t;
        }
    EXPECT_NEAR(length_of(found.curves), length, 0.01);
}

TEST(Intersections, OpenSheetsCrossInAnEllipse) {
    const geometry::Bounds box{{-1.0, -1.0, -0.2}, {1.0, 1.0, 1.2}};
    const test::AnyField bowl(box, [](const glm::dvec3& p) {
        return test::Field{p.x * p.x + p.y * p.y - p.z, {2.0 * p.x, 2.0 * p.y, -1.0}, {2.0, 0.0, 0.0, 2.0, 0.0, 0.0}};
    });
    const test::Plane plane({0.4, 0.0, -1.0}, -0.5, box); // z = 0.5 + 0.4 x
    const LineSet a = lines_of(bowl, 0.06);
    const LineSet b = lines_of(plane, 0.1);
    const Intersections found = find_intersections(runtime(), a, b, in_place);
    ASSERT_EQ(found.curves.count(), 1);
    EXPECT_EQ(found.curves.closed[0], 1);
    const double r = std::sqrt(0.54); // (x - 0.2)^2 + y^2 = 0.54
    expect_curve(
        found.curves,
        [&](double t) {
            const double x = 0.2 + r * std::cos(2.0 * pi * t);
            return glm::dvec3(x, r * std::sin(2.0 * pi * t), 0.5 + 0.4 * x);
        },
        0.06);
}

// Lines of two cubes: on each pair of faces, the line that both planes have in common, as far as it is in both cubes.
double length_of_cubes(const glm::dmat4& to_other) {
    double sum = 0.0;
    const auto inside = [](const glm::dvec3& p) {
        return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= 1.0 + 1e-9;
    };
    const glm::dmat4 back = glm::inverse(to_other);
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
            glm::dvec3 n(0.0), m(0.0);
            n[i % 3] = i < 3 ? 1.0 : -1.0;
            m[j % 3] = j < 3 ? 1.0 : -1.0;
            const glm::dvec3 there(back * glm::dvec4(m, 0.0));
            const double at = 1.0 + glm::dot(there, glm::dvec3(back * glm::dvec4(0.0, 0.0, 0.0, 1.0)));
            const glm::dvec3 along = glm::cross(n, there);
            if (!(glm::length(along) > 1e-9)) continue;
            const double nm = glm::dot(n, there);
            const glm::dvec3 start = ((1.0 - at * nm) * n + (at - nm) * there) / (1.0 - nm * nm);
            const glm::dvec3 way = glm::normalize(along);
            constexpr int steps = 40000;
            for (int k = 0; k < steps; ++k) {
                const glm::dvec3 p = start + way * (8.0 * ((k + 0.5) / steps) - 4.0);
                if (inside(p) && inside(glm::dvec3(to_other * glm::dvec4(p, 1.0)))) sum += 8.0 / steps;
            }
        }
    return sum;
}

TEST(Intersections, CubesCrossInPolygons) {
    const auto cube = test::sharp_cube(glm::dmat3(1.0));
    const LineSet a = lines_of(*cube, 0.15);
    const LineSet b = lines_of(*cube, 0.2);
    glm::dmat4 to_other = glm::rotate(moved({0.7, 0.3, -0.5}), 0.6, glm::normalize(glm::dvec3(1.0, 2.0, 0.5)));
    const Intersections found = find_intersections(runtime(), a, b, to_other);
    EXPECT_EQ(found.broken, 0);
    EXPECT_LE(farthest(found.curves, *cube), 1e-6);
    EXPECT_LE(farthest(found.curves, *cube, to_other), 1e-6);
    const double length = length_of_cubes(to_other);
    EXPECT_GT(length, 3.0);
    EXPECT_NEAR(length_of(found.curves), length, 2e-3 * length);
    for (std::int64_t c = 0; c < found.curves.count(); ++c) EXPECT_EQ(found.curves.closed[c], 0);
}

// A cube that a ring passes through: the length is counted on a dense grid of the ring.
TEST(Intersections, ARingCrossesACube) {
    const auto cube = test::sharp_cube(glm::dmat3(1.0));
    const test::Torus ring(1.0, 0.3);
    const LineSet a = lines_of(ring, 0.06);
    const LineSet b = lines_of(*cube, 0.15);
    const glm::dmat4 to_other = moved({0.9, 0.2, 0.35});
    const Intersections found = find_intersections(runtime(), a, b, to_other);
    EXPECT_EQ(found.broken, 0);
    EXPECT_LE(farthest(found.curves, ring), 1e-6);
    EXPECT_LE(farthest(found.curves, *cube, to_other), 1e-6);
    const auto place = [](double u, double v) {
        return glm::dvec3((1.0 + 0.3 * std::cos(v)) * std::cos(u), (1.0 + 0.3 * std::cos(v)) * std::sin(u),
                          0.3 * std::sin(v));
    };
    const auto value = [&](double u, double v) {
        const glm::dvec3 p = glm::abs(glm::dvec3(to_other * glm::dvec4(place(u, v), 1.0)));
        return std::max({p.x, p.y, p.z}) - 1.0;
    };
    // Every change of sign along a circle of the tube is near the curves.
    int changes = 0;
    for (int i = 0; i < 300; ++i)
        for (int k = 0; k < 300; ++k) {
            const double u = 2.0 * pi * i / 300.0;
            double low = 2.0 * pi * k / 300.0;
            double high = 2.0 * pi * (k + 1) / 300.0;
            if ((value(u, low) < 0.0) == (value(u, high) < 0.0)) continue;
            const bool rises = value(u, low) < 0.0;
            for (int step = 0; step < 40; ++step) {
                const double middle = 0.5 * (low + high);
                ((value(u, middle) < 0.0) == rises ? low : high) = middle;
            }
            ++changes;
            EXPECT_LE(distance_to(found.curves, place(u, low)), 1e-3);
        }
    EXPECT_GT(changes, 100);
}

TEST(Intersections, TouchingSurfacesHaveNone) {
    const test::Sphere ball(1.0);
    const LineSet a = lines_of(ball, 0.1);
    const LineSet b = lines_of(ball, 0.13);
    // The same surface, one nearly the same, and one that touches from outside and from inside.
    EXPECT_EQ(find_intersections(runtime(), a, b, in_place).curves.count(), 0);
    EXPECT_EQ(find_intersections(runtime(), a, b, moved({1e-4, 0.0, 0.0})).curves.count(), 0);
    EXPECT_EQ(find_intersections(runtime(), a, b, moved({2.0, 0.0, 0.0})).curves.count(), 0);
    const test::Sphere half(0.5);
    EXPECT_EQ(find_intersections(runtime(), a, lines_of(half, 0.1), moved({0.5, 0.0, 0.0})).curves.count(), 0);
    const test::Plane floor({0.0, 0.0, 1.0}, -1.0, {{-2.0, -2.0, -1.2}, {2.0, 2.0, -0.8}});
    EXPECT_EQ(find_intersections(runtime(), a, lines_of(floor, 0.1), in_place).curves.count(), 0);
}

// A box that stands on a larger one: if there are lines, they are on the border of the area in which both touch.
TEST(Intersections, ABoxOnABoxHasNoLinesOnTheArea) {
    const auto cube = test::sharp_cube(glm::dmat3(1.0));
    const LineSet a = lines_of(*cube, 0.15);
    // The other cube is twice as large, and its lower face is in the plane z = 1.
    const glm::dmat4 to_other = glm::scale(glm::dmat4(1.0), glm::dvec3(0.5)) * moved({0.1, -0.2, -3.0});
    const Intersections small = find_intersections(runtime(), a, a, to_other);
    const Intersections large = find_intersections(runtime(), a, a, glm::inverse(to_other));
    const auto expect_on_border = [](const glm::dvec3& p) {
        EXPECT_NEAR(p.z, 1.0, 1e-3);
        EXPECT_NEAR(std::max(std::abs(p.x), std::abs(p.y)), 1.0, 1e-3);
    };
    for (const CurvePoint& p : small.curves.point) expect_on_border(p.position);
    for (const CurvePoint& p : large.curves.point)
        expect_on_border(glm::dvec3(glm::inverse(to_other) * glm::dvec4(p.position, 1.0)));
    EXPECT_LE(length_of(small.curves), 8.01);
    EXPECT_LE(length_of(large.curves), 16.02);
}

TEST(Intersections, PosesTurnAndScale) {
    const test::Sphere ball(1.0);
    const test::Torus ring(1.0, 0.3);
    const LineSet a = lines_of(ring, 0.08);
    const LineSet b = lines_of(ball, 0.1);
    const glm::dmat4 to_other =
        glm::scale(glm::rotate(moved({0.3, 0.2, 0.1}), 0.7, glm::dvec3(0.0, 1.0, 0.0)), glm::dvec3(1.2, 0.8, 1.5));
    const Intersections found = find_intersections(runtime(), a, b, to_other);
    EXPECT_GT(found.curves.count(), 0);
    EXPECT_EQ(found.broken, 0);
    EXPECT_LE(farthest(found.curves, ring), 1e-6);
    EXPECT_LE(farthest(found.curves, ball, to_other), 1e-6);
    const Intersections turned = find_intersections(runtime(), b, a, glm::inverse(to_other));
    for (const CurvePoint& p : turned.curves.point)
        EXPECT_LE(distance_to(found.curves, glm::dvec3(glm::inverse(to_other) * glm::dvec4(p.position, 1.0))), 1e-3);
}

TEST(Intersections, SameBitsForAnyNumberOfThreads) {
    const auto cube = test::sharp_cube(glm::dmat3(1.0));
    const test::Torus ring(1.0, 0.3);
    const base::Runtime one = test::with_threads(1);
    const glm::dmat4 to_other = moved({0.9, 0.2, 0.35});
    const LineSet a = lines_of(ring, 0.06);
    const LineSet b = lines_of(*cube, 0.15);
    const Intersections some = find_intersections(runtime(), a, b, to_other);
    const Intersections same = find_intersections(one, a, b, to_other);
    ASSERT_EQ(some.curves.point.size(), same.curves.point.size());
    for (std::int64_t i = 0; i < some.curves.point.size(); ++i)
        EXPECT_EQ(some.curves.point[i].position, same.curves.point[i].position);
}

} // namespace
} // namespace hrbfnpr::curves::intersections_test
