// SPDX-License-Identifier: MIT
// Curves f = g = 0 on a surface as polylines that cubics go through: their points, Newton's steps that bring places
// onto a curve, the cubic pieces between points, and the question whether a curve passes by a place.
#pragma once

#include "base/assert.h"
#include "base/memory.h"
#include "curves/level.h"
#include "geometry/point_grid.h"
#include "geometry/vec_array.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hrbfnpr::curves {

// ---- Points

// The values of f and g at a place near a curve.
struct CurvePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 gradient{0.0};       // grad f
    glm::dvec3 level_gradient{0.0}; // grad g
    double value = 0.0;             // f
    double level = 0.0;             // g

    // The direction of the curve, with negative g to its left; it is not unit.
    [[nodiscard]] glm::dvec3 direction() const noexcept { return glm::cross(gradient, level_gradient); }
    // The shortest way to f = g = 0 where both are taken as linear: -J^T (J J^T)^-1 (f, g). It is not finite where the
    // gradients are parallel.
    [[nodiscard]] glm::dvec3 newton_step() const noexcept;
};

// Evaluates f and g at the positions of all points, on all threads.
void evaluate(const base::Runtime& runtime, const Level& level, base::Array<CurvePoint>& points,
              const base::Progress& progress);

// Brings points onto their curves by one of Newton's steps, and by a second one where the first was longer than
// `enough` of that point. Adds to `evaluations`.
void bring_closer(const base::Runtime& runtime, const Level& level, const base::Array<double>& enough,
                  base::Array<CurvePoint>& points, std::int64_t& evaluations, const base::Progress& progress);

struct NewtonSettings {
    double tolerance = 0.0; // a shorter step is the last one, and a longer one if the next one would be negligible
    double farthest = 0.0;  // a point that is led farther from where it began is given up
};

// Brings points onto curves, all at once. found[i] is 1 where that succeeded. Returns the number of evaluations.
std::int64_t bring_to_curve(const base::Runtime& runtime, const Level& level, const NewtonSettings& settings,
                            base::Array<CurvePoint>& points, base::Array<std::uint8_t>& found,
                            const base::Progress& progress);

// Two places of the surface near each other: g < 0 at one and >= 0 at the other, so that g has a zero
// between them.
struct Straddle {
    glm::dvec3 negative, positive;
};

// Finds zeros of g between places by halving, on the surface: each point is within 2^-halvings of the places' distance
// of one. Returns the number of evaluations.
std::int64_t halve(const base::Runtime& runtime, const Level& level, const base::Array<Straddle>& places, int halvings,
                   base::Array<CurvePoint>& points, const base::Progress& progress);

// Makes a step towards f = 0 along grad f.
inline void step_to_surface(CurvePoint& p) noexcept {
    p.position -= p.value / glm::dot(p.gradient, p.gradient) * p.gradient;
}

// ---- Curves

struct Curves {
    explicit Curves(base::Memory& memory) noexcept : first(memory), closed(memory), point(memory), cusp(memory) {}

    base::Array<std::int64_t> first;  // the first point of each curve, and the number of points
    base::Array<std::uint8_t> closed; // 1: the first point follows the last one; it is not repeated
    base::Array<CurvePoint> point;    // in the order of CurvePoint::direction()
    base::Array<std::uint8_t> cusp;   // 1: the line of sight is tangent to the curve at this point; empty: not known

    [[nodiscard]] std::int64_t count() const noexcept { return closed.size(); }
    [[nodiscard]] std::int64_t size_of(std::int64_t curve) const noexcept {
        HRBFNPR_ASSERT(curve >= 0 && curve < count());
        return first[curve + 1] - first[curve];
    }
    // The number of pieces between points.
    [[nodiscard]] std::int64_t pieces_of(std::int64_t curve) const noexcept {
        return size_of(curve) - (closed[curve] != 0 ? 0 : 1);
    }
    // The point after a point of the curve; the last point of an open curve has none.
    [[nodiscard]] std::int64_t next(std::int64_t curve, std::int64_t at) const noexcept {
        HRBFNPR_ASSERT(at >= first[curve] && at < first[curve + 1]);
        return at + 1 < first[curve + 1] ? at + 1 : first[curve];
    }
    // Ends a curve after the points that were added since the last one. `first` must not be empty.
    void end_curve(bool is_closed) {
        HRBFNPR_ASSERT(first.size() == closed.size() + 1);
        first.push_back(point.size());
        closed.push_back(is_closed ? 1 : 0);
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return first.bytes() + closed.bytes() + point.bytes() + cusp.bytes();
    }
};

// No curves, ready for points and end_curve().
[[nodiscard]] inline Curves no_curves(base::Memory& memory) {
    Curves curves(memory);
    curves.first.push_back(0);
    return curves;
}

// The cubic between two points of a curve.
class CubicPiece {
public:
    CubicPiece(const CurvePoint& a, const CurvePoint& b) noexcept
        : a_(a.position), b_(b.position), length_(glm::distance(a_, b_)), begin_(tangent(a)), end_(tangent(b)) {
        // The middle of the cubic lies on the arc of a circle with this speed at both ends, in chords: an arc of the
        // angle t wants 4 tan(t / 4) radii, and its chord has 2 sin(t / 2).
        const double cosine = std::clamp(glm::dot(begin_, end_), 0.0, 1.0);
        const double speed = length_ * (2.0 / (1.0 + std::sqrt(0.5 * (1.0 + cosine))));
        begin_ *= speed;
        end_ *= speed;
    }

    [[nodiscard]] glm::dvec3 at(double u) const noexcept {
        const double v = 1.0 - u;
        return v * v * (1.0 + 2.0 * u) * a_ + u * u * (3.0 - 2.0 * u) * b_ + u * v * (v * begin_ - u * end_);
    }
    [[nodiscard]] glm::dvec3 derivative(double u) const noexcept {
        const double v = 1.0 - u;
        return 6.0 * u * v * (b_ - a_) + v * (v - 2.0 * u) * begin_ + u * (u - 2.0 * v) * end_;
    }
    [[nodiscard]] double length() const noexcept { return length_; }

private:
    // The tangent is the chord where the curve has no direction, as where one of its functions is constant.
    [[nodiscard]] glm::dvec3 tangent(const CurvePoint& point) const noexcept {
        const glm::dvec3 unit = glm::normalize(point.direction());
        if (std::isfinite(unit.x + unit.y + unit.z)) return unit;
        return length_ > 0.0 ? (b_ - a_) / length_ : glm::dvec3(0.0);
    }

    glm::dvec3 a_, b_;
    double length_;
    glm::dvec3 begin_, end_;
};

// ---- Nearness

[[nodiscard]] geometry::VecArray positions_of(const base::Array<CurvePoint>& points);
// The curve of each point.
[[nodiscard]] base::Array<std::int32_t> curve_of_points(const Curves& curves);

class NearCurves {
public:
    // Answers for curves whose pieces are no longer than `longest`, up to the distance `farthest`. The curves must
    // outlive it.
    NearCurves(const Curves& curves, double longest, double farthest)
        : curves_(curves), curve_(curve_of_points(curves)), grid_(positions_of(curves.point), longest + farthest) {
        HRBFNPR_ASSERT(longest > 0.0 && farthest >= 0.0);
    }

    // A place of a cubic.
    struct Foot {
        glm::dvec3 place{0.0};
        double distance = HUGE_VAL;
        std::int64_t curve = -1; // -1: no curve is near
    };
    // The nearest place of the curves other than `but` that run in the direction `along`.
    [[nodiscard]] Foot nearest(const glm::dvec3& place, const glm::dvec3& along, std::int64_t but = -1) const;
    // The nearest of these curves if it is within the distance; -1: it is farther.
    [[nodiscard]] std::int64_t passing(const glm::dvec3& place, const glm::dvec3& along, double distance,
                                       std::int64_t but = -1) const {
        const Foot foot = nearest(place, along, but);
        return foot.distance <= distance ? foot.curve : -1;
    }

private:
    const Curves& curves_;
    base::Array<std::int32_t> curve_; // the curve of each point
    geometry::PointGrid grid_;
};

} // namespace hrbfnpr::curves
