// SPDX-License-Identifier: MIT
// Contours of a surface with measures for tests, and the conditions that all contours must meet.
#pragma once

#include "curves/curve_changes.h"
#include "curves/curves.h"
#include "curves/trace.h"
#include "shapes.h"
#include "support/runtime.h"
#include "support/views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace hrbfnpr::curves::test_traced {

using test::cube_directions;
using test::Eye;

// A surface and its mesh.
struct Meshed {
    Meshed(const base::Runtime& runtime, const implicit::Implicit& implicit, std::initializer_list<glm::dvec3> places,
           double side)
        : surface(implicit), mesh(triangulate(runtime, implicit, test_shapes::seeds(runtime, places),
                                              test_shapes::settings(implicit, side))) {}
    Meshed(const base::Runtime& runtime, const implicit::Implicit& implicit, const geometry::VecArray& seeds,
           double side)
        : surface(implicit), mesh(triangulate(runtime, implicit, seeds, test_shapes::settings(implicit, side))) {}

    const implicit::Implicit& surface;
    SurfaceMesh mesh;
};

inline std::int64_t count_cusps(const Curves& curves) {
    return std::count_if(curves.point.begin(), curves.point.end(), [](const CurvePoint& p) { return p.is_cusp != 0; });
}

struct Contours {
    Contours(const base::Runtime& runtime, const Meshed& of, const View& seen, const TraceSettings& settings = {})
        : view(seen), level(of.surface, seen), curves(runtime.memory) {
        const Curves found = trace(runtime, level, of.mesh, settings, report);
        curves = with_cusps(runtime, level, view, found, report.evaluations);
    }
    [[nodiscard]] std::int64_t cusps() const { return count_cusps(curves); }
    [[nodiscard]] std::int64_t closed() const { return std::count(curves.closed.begin(), curves.closed.end(), 1); }

    View view;
    ContourLevel level;
    TraceReport report;
    Curves curves;
};

inline double length(const Curves& curves, std::int64_t curve) {
    double sum = 0.0;
    for (std::int64_t k = 0; k < curves.pieces_of(curve); ++k) {
        const std::int64_t at = curves.first[curve] + k;
        const CubicPiece piece(curves.point[at], curves.point[curves.next(curve, at)]);
        glm::dvec3 last = piece.at(0.0);
        for (int i = 1; i <= 8; ++i) {
            const glm::dvec3 next = piece.at(i / 8.0);
            sum += glm::distance(last, next);
            last = next;
        }
    }
    return sum;
}

// The largest distance of the points from f = g = 0, as the length of a Newton step with values that are evaluated
// anew.
inline double farthest_off(const base::Runtime& runtime, const Level& level, const Curves& curves) {
    base::Array<CurvePoint> points(runtime.memory);
    for (const CurvePoint& p : curves.point) points.push_back(p);
    evaluate(runtime, level, points);
    double farthest = 0.0;
    for (const CurvePoint& p : points) {
        const double off = glm::length(p.newton_step());
        if (!(off <= farthest)) farthest = off;
    }
    return farthest;
}

// The sharpest turn between consecutive points, in radians.
inline double sharpest_turn(const Curves& curves) {
    double sharpest = 0.0;
    for (std::int64_t c = 0; c < curves.count(); ++c)
        for (std::int64_t k = 0; k < curves.pieces_of(c); ++k) {
            const std::int64_t at = curves.first[c] + k;
            const glm::dvec3 a = glm::normalize(curves.point[at].direction());
            const glm::dvec3 b = glm::normalize(curves.point[curves.next(c, at)].direction());
            sharpest = std::max(sharpest, std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)));
        }
    return sharpest;
}

// A chord between points, and the distance along its curve at which it begins.
struct Chord {
    glm::dvec3 a, b;
    std::int64_t curve;
    double at, whole;

    [[nodiscard]] glm::dvec3 way() const noexcept { return b - a; }
    // Tells whether both chords are of the same curve and begin less than `distance` apart along it.
    [[nodiscard]] bool follows(const Chord& other, double distance) const noexcept {
        const double apart = std::abs(at - other.at);
        return curve == other.curve && std::min(apart, whole - apart) < distance;
    }
    // Tells whether the chord begins within `distance` of another one, and is nearly parallel to it.
    [[nodiscard]] bool alike(const Chord& other, double distance) const noexcept {
        const glm::dvec3 along = other.way();
        const double share = std::clamp(glm::dot(a - other.a, along) / glm::dot(along, along), 0.0, 1.0);
        return glm::distance(a, other.a + share * along) <= distance &&
               std::abs(glm::dot(along, way())) > 0.9 * glm::length(along) * glm::length(way());
    }
};

inline std::vector<Chord> chords_of(const Curves& curves) {
    std::vector<Chord> chords;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        const std::size_t first = chords.size();
        double at = 0.0;
        for (std::int64_t k = 0; k < curves.pieces_of(c); ++k) {
            const std::int64_t i = curves.first[c] + k;
            chords.push_back({curves.point[i].position, curves.point[curves.next(c, i)].position, c, at, 0.0});
            at += glm::length(chords.back().way());
        }
        for (std::size_t i = first; i < chords.size(); ++i) chords[i].whole = at;
    }
    return chords;
}

// The number of chords that run along another chord within the distance, in the same direction or the opposite one.
inline std::int64_t run_alike(const Curves& curves, double distance) {
    std::vector<Chord> chords = chords_of(curves);
    double reach = distance;
    for (const Chord& chord : chords) reach = std::max(reach, distance + glm::length(chord.way()));
    std::sort(chords.begin(), chords.end(), [](const Chord& s, const Chord& t) { return s.a.x < t.a.x; });
    std::int64_t count = 0;
    for (const Chord& own : chords) {
        auto other = std::lower_bound(chords.begin(), chords.end(), own.a.x - reach,
                                      [](const Chord& t, double x) { return t.a.x < x; });
        bool found = false;
        for (; other != chords.end() && other->a.x <= own.a.x + reach && !found; ++other)
            found = !own.follows(*other, 2.0 * reach) && own.alike(*other, distance);
        count += found ? 1 : 0;
    }
    return count;
}

// Checks the conditions that contours of any closed surface without samples must meet.
inline void expect_sound(const base::Runtime& runtime, const Meshed& of, const Contours& found) {
    EXPECT_EQ(found.closed(), found.curves.count());
    EXPECT_EQ(found.report.broken, 0);
    EXPECT_EQ(found.report.missed, 0);
    EXPECT_LE(farthest_off(runtime, found.level, found.curves), 1e-6 * of.mesh.side);
    EXPECT_LE(sharpest_turn(found.curves), 1.001 * 2.0 * std::asin(0.5 * TraceSettings{}.turn));
    EXPECT_EQ(run_alike(found.curves, 0.01 * of.mesh.side), 0);
}

} // namespace hrbfnpr::curves::test_traced
