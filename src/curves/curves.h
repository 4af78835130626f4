// SPDX-License-Identifier: MIT
// Curves on a surface as polylines that cubics go through.
#pragma once

#include "base/memory.h"
#include "curves/curve_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hrbfnpr::curves {

struct Curves {
    explicit Curves(base::Memory& memory) noexcept : first(memory), closed(memory), point(memory), cusp(memory) {}

    base::Array<std::int64_t> first;  // of each curve's points, and the end of the last: one more than curves
    base::Array<std::uint8_t> closed; // 1: the first point follows the last, and stands there once
    base::Array<CurvePoint> point;    // in the order of CurvePoint::direction()
    base::Array<std::uint8_t> cusp; // 1: a point where the line of sight is tangent to the curve; empty: none is known

    [[nodiscard]] std::int64_t count() const noexcept { return closed.size(); }
    [[nodiscard]] std::int64_t size_of(std::int64_t curve) const noexcept { return first[curve + 1] - first[curve]; }
    // Pieces between points.
    [[nodiscard]] std::int64_t pieces_of(std::int64_t curve) const noexcept {
        return size_of(curve) - (closed[curve] != 0 ? 0 : 1);
    }
    // The point after a point of the curve that has one.
    [[nodiscard]] std::int64_t next(std::int64_t curve, std::int64_t at) const noexcept {
        return at + 1 < first[curve + 1] ? at + 1 : first[curve];
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return first.bytes() + closed.bytes() + point.bytes() + cusp.bytes();
    }
};

// The cubic between two points of a curve.
class CubicPiece {
public:
    CubicPiece(const CurvePoint& a, const CurvePoint& b) noexcept
        : a_(a.position), b_(b.position), length_(glm::distance(a_, b_)), begin_(tangent(a)), end_(tangent(b)) {
        const double speed = length_ * over_chord(glm::dot(begin_, end_));
        begin_ *= speed;
        end_ *= speed;
    }

    [[nodiscard]] glm::dvec3 at(double u) const noexcept {
        const double v = 1.0 - u;
        return v * v * (1.0 + 2.0 * u) * a_ + u * u * (3.0 - 2.0 * u) * b_ + u * v * (v * begin_ - u * end_);
    }
    // By u.
    [[nodiscard]] glm::dvec3 derivative(double u) const noexcept {
        const double v = 1.0 - u;
        return 6.0 * u * v * (b_ - a_) + v * (v - 2.0 * u) * begin_ + u * (u - 2.0 * v) * end_;
    }
    [[nodiscard]] double length() const noexcept { return length_; }

private:
    // Where the curve's functions do not tell, as where one of them is constant, along the chord.
    [[nodiscard]] glm::dvec3 tangent(const CurvePoint& point) const noexcept {
        const glm::dvec3 unit = glm::normalize(point.direction());
        if (std::isfinite(unit.x + unit.y + unit.z)) return unit;
        return length_ > 0.0 ? (b_ - a_) / length_ : glm::dvec3(0.0);
    }
    // How fast it begins and ends, in chords, for its middle to lie on the arc of a circle: an arc of the angle t wants
    // 4 tan(t / 4) radii, and its chord has 2 sin(t / 2).
    [[nodiscard]] static double over_chord(double cosine) noexcept {
        return 2.0 / (1.0 + std::sqrt(0.5 * (1.0 + std::clamp(cosine, 0.0, 1.0))));
    }

    glm::dvec3 a_, b_;
    double length_;
    glm::dvec3 begin_, end_;
};

} // namespace hrbfnpr::curves
