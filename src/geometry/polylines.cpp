// SPDX-License-Identifier: MIT
#include "geometry/polylines.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::geometry {
namespace {

using glm::dvec2;

double square(const dvec2& a) noexcept { return glm::dot(a, a); }

dvec2 unit_or_zero(const dvec2& a) noexcept {
    const double length = std::sqrt(square(a));
    return length > 0.0 ? (1.0 / length) * a : dvec2(0.0);
}

} // namespace

// Copies the points without repetitions, and inserts at least one on each segment so that the fit is measured there.
void CurveFit::densify(std::span<const dvec2> points) {
    points_.clear();
    const double spacing = curve_fit_tuning.spacing * std::sqrt(squared_tolerance_);
    for (const dvec2& p : points) {
        if (!points_.empty()) {
            const dvec2 from = points_[points_.size() - 1];
            const double length = std::sqrt(square(p - from));
            if (!(length > 0.0)) continue;
            const auto parts =
                1 + static_cast<std::int64_t>(std::clamp(length / spacing, 1.0, curve_fit_tuning.most_between));
            for (std::int64_t k = 1; k < parts; ++k)
                points_.push_back(from + (static_cast<double>(k) / static_cast<double>(parts)) * (p - from));
        }
        points_.push_back(p);
    }
}

bool CurveFit::is_corner(std::int64_t before, std::int64_t i, std::int64_t after) const noexcept {
    const dvec2 a = points_[i] - points_[before];
    const dvec2 b = points_[after] - points_[i];
    return glm::dot(a, b) < curve_fit_tuning.corner_cosine * std::sqrt(square(a) * square(b));
}

// Returns the direction at an end of the line. It is the direction there of the parabola through the end and the second
// and fourth points from it. If densify() inserted one point per segment, these are the next two given points.
dvec2 CurveFit::direction_from(std::int64_t end, std::int64_t other) const noexcept {
    const std::int64_t step = other > end ? 2 : -2;
    if (std::abs(other - end) < 4) return unit_or_zero(points_[other > end ? end + 1 : end - 1] - points_[end]);
    const dvec2 a = points_[end + step] - points_[end];
    const dvec2 b = points_[end + 2 * step] - points_[end + step];
    const double la = std::sqrt(square(a)), lb = std::sqrt(square(b));
    if (!(la > 0.0) || !(lb > 0.0)) return unit_or_zero(a + b);
    return unit_or_zero((1.0 / la) * a + (la / (la + lb)) * ((1.0 / la) * a - (1.0 / lb) * b));
}

// Returns the direction, at the middle point, of the parabola through three consecutive points.
dvec2 CurveFit::direction_at(std::int64_t i, std::int64_t first, std::int64_t last) const noexcept {
    const dvec2 a = points_[i] - points_[std::max(i - 1, first)];
    const dvec2 b = points_[std::min(i + 1, last)] - points_[i];
    const double la = std::sqrt(square(a)), lb = std::sqrt(square(b));
    if (!(la > 0.0) || !(lb > 0.0)) return unit_or_zero(a + b);
    return unit_or_zero((lb / la) * a + (la / lb) * b);
}

std::span<const Cubic> CurveFit::fit(std::span<const dvec2> points, double tolerance, bool closed) {
    HRBFNPR_ASSERT(tolerance > 0.0);
    cubics_.clear();
    squared_tolerance_ = curve_fit_tuning.measured_share * curve_fit_tuning.measured_share * tolerance * tolerance;
    densify(points);
    const std::int64_t count = points_.size();
    if (count < 2) return {};
    parameters_.resize(count);
    const std::int64_t last = count - 1;
    bool goes_round = closed && count > 3;
    if (goes_round) {
        // The index at which a closed line begins: its corner, if it has one.
        std::int64_t corner = 0;
        while (corner < last && !is_corner(corner > 0 ? corner - 1 : last - 1, corner, corner + 1)) ++corner;
        if (corner > 0 && corner < last) {
            points_.resize(last);
            std::rotate(points_.begin(), points_.begin() + corner, points_.end());
            points_.push_back(points_[0]);
        }
        goes_round = corner == last;
    }
    dvec2 round(0.0);
    if (goes_round)
        round = unit_or_zero(unit_or_zero(points_[last] - points_[last - 1]) + unit_or_zero(points_[1] - points_[0]));
    for (std::int64_t begin = 0; begin < last;) {
        std::int64_t end = begin + 1;
        while (end < last && !is_corner(end - 1, end, end + 1)) ++end;
        const dvec2 from = goes_round && begin == 0 ? round : direction_from(begin, end);
        const dvec2 to = goes_round && end == last ? -round : direction_from(end, begin);
        fit_run(begin, end, from, to, 0);
        begin = end;
    }
    return {cubics_.data(), static_cast<std::size_t>(cubics_.size())};
}

void CurveFit::set_parameters(std::int64_t first, std::int64_t last) noexcept {
    parameters_[first] = 0.0;
    for (std::int64_t i = first + 1; i <= last; ++i)
        parameters_[i] = parameters_[i - 1] + std::sqrt(square(points_[i] - points_[i - 1]));
    const double scale = 1.0 / parameters_[last];
    for (std::int64_t i = first + 1; i < last; ++i) parameters_[i] *= scale;
    parameters_[last] = 1.0;
}

// Makes one step of Newton's method towards the nearest parameter of each point.
void CurveFit::improve_parameters(std::int64_t first, std::int64_t last, const Cubic& c) noexcept {
    const dvec2 start = points_[first];
    const dvec2 a = c.control_1 - start, b = c.control_2 - c.control_1, d = c.end - c.control_2;
    for (std::int64_t i = first + 1; i < last; ++i) {
        const double t = parameters_[i], s = 1.0 - t;
        const dvec2 off = point_on_cubic(start, c, t) - points_[i];
        const dvec2 slope = 3.0 * (s * s * a + 2.0 * s * t * b + t * t * d);
        const dvec2 bend = 6.0 * (s * (b - a) + t * (d - b));
        const double denominator = glm::dot(slope, slope) + glm::dot(off, bend);
        if (denominator > 0.0) parameters_[i] = std::clamp(t - glm::dot(off, slope) / denominator, 0.0, 1.0);
    }
}

// Finds the lengths of both handles. If they are not usable, both are set to a third of the chord [Schneider 1990].
Cubic CurveFit::least_squares(std::int64_t first, std::int64_t last, const dvec2& from,
                              const dvec2& to) const noexcept {
    const dvec2 start = points_[first], end = points_[last];
    double c00 = 0.0, c01 = 0.0, c11 = 0.0, x0 = 0.0, x1 = 0.0;
    for (std::int64_t i = first; i <= last; ++i) {
        const double t = parameters_[i], s = 1.0 - t;
        const double b1 = 3.0 * s * s * t, b2 = 3.0 * s * t * t;
        const dvec2 a0 = b1 * from, a1 = b2 * to;
        const dvec2 rest = points_[i] - ((s * s * s + b1) * start + (t * t * t + b2) * end);
        c00 += glm::dot(a0, a0);
        c01 += glm::dot(a0, a1);
        c11 += glm::dot(a1, a1);
        x0 += glm::dot(a0, rest);
        x1 += glm::dot(a1, rest);
    }
    const double chord = std::sqrt(square(end - start));
    const double determinant = c00 * c11 - c01 * c01;
    double alpha = chord / 3.0, beta = chord / 3.0;
    if (determinant > 1e-12 * c00 * c11) {
        const double a = (x0 * c11 - x1 * c01) / determinant, b = (c00 * x1 - c01 * x0) / determinant;
        if (a > 1e-6 * chord && b > 1e-6 * chord && a + b < 4.0 * chord) {
            alpha = a;
            beta = b;
        }
    }
    return {start + alpha * from, end + beta * to, end};
}

// Finds the point that is farthest from the curve, and returns the square of its distance.
double CurveFit::farthest(std::int64_t first, std::int64_t last, const Cubic& cubic,
                          std::int64_t& where) const noexcept {
    HRBFNPR_ASSERT(first < last && last < points_.size());
    double most = 0.0;
    where = (first + last) / 2;
    for (std::int64_t i = first + 1; i < last; ++i) {
        const double off = square(point_on_cubic(points_[first], cubic, parameters_[i]) - points_[i]);
        if (off > most) {
            most = off;
            where = i;
        }
    }
    return most;
}

void CurveFit::fit_run(std::int64_t first, std::int64_t last, const dvec2& from, const dvec2& to, int depth) {
    HRBFNPR_ASSERT(first < last && last < points_.size());
    const dvec2 start = points_[first], end = points_[last];
    if (last - first == 1) {
        cubics_.push_back({start + (1.0 / 3.0) * (end - start), start + (2.0 / 3.0) * (end - start), end});
        return;
    }
    set_parameters(first, last);
    std::int64_t where = 0;
    for (int i = 0; i <= curve_fit_tuning.improvements; ++i) {
        const Cubic cubic = least_squares(first, last, from, to);
        const double off = farthest(first, last, cubic, where);
        if (off <= squared_tolerance_) {
            cubics_.push_back(cubic);
            return;
        }
        if (off > curve_fit_tuning.near_enough_to_improve * squared_tolerance_) break;
        improve_parameters(first, last, cubic);
    }
    if (depth >= curve_fit_tuning.deepest) where = (first + last) / 2;
    const dvec2 along = direction_at(where, first, last);
    fit_run(first, where, from, -along, depth + 1);
    fit_run(where, last, along, to, depth + 1);
}

} // namespace hrbfnpr::geometry
