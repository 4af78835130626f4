// SPDX-License-Identifier: MIT
// Curves f = g = 0 on a surface as polylines that cubics go through: their points, Newton's steps that bring places
// onto a curve, the cubic pieces between points, and the question whether a curve passes by a place.
#pragma once

#include "base/assert.h"
#include "base/memory.h"
#include "curves/chains.h"
#include "curves/level.h"
#include "curves/tuning.h"
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

// Points stand in the order of CurvePoint::direction().
struct Curves : Chains<CurvePoint> {
    explicit Curves(base::Memory& memory) : Chains(memory), cusp(memory) {}

    base::Array<std::uint8_t> cusp; // 1: the line of sight is tangent to the curve at this point; empty: not known

    [[nodiscard]] std::int64_t bytes() const noexcept { return Chains::bytes() + cusp.bytes(); }
};

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

// The search for a zero of a function between two places where its signs differ: the Illinois method. [Dowell & Jarratt
// 1971]
struct Illinois {
    double low = 0.0, high = 1.0;
    double at_low, at_high; // the values there; the value of an end that stays is halved
    double trial;           // where the function is asked for next
    int trusted;            // from this many steps on it halves
    int steps = 0;
    int kept = 0; // how many times in a row the same end stayed: above 0 the higher one

    Illinois(double from, double to, int trusted_steps = curve_tuning.most_steps) noexcept
        : at_low(from), at_high(to), trial(from / (from - to)), trusted(trusted_steps) {
        HRBFNPR_ASSERT(!(from * to > 0.0));
    }
    // The value at the trial.
    void take(double value) noexcept {
        const bool same = (value < 0.0) == (at_low < 0.0);
        (same ? low : high) = trial;
        (same ? at_low : at_high) = value;
        kept = same ? std::max(1, kept + 1) : std::min(-1, kept - 1);
        if (kept > 1) at_high *= 0.5;
        if (kept < -1) at_low *= 0.5;
        trial = low + (high - low) * at_low / (at_low - at_high);
        const bool found = at_low == 0.0 || at_high == 0.0;
        // The value may jump, as at a sample: then halving goes on.
        if (++steps > trusted || (!found && !(trial > low && trial < high))) trial = 0.5 * (low + high);
    }
    [[nodiscard]] bool done(double width) const noexcept {
        return !(high - low > width) || at_low == 0.0 || at_high == 0.0;
    }
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
