// SPDX-License-Identifier: MIT
#include "output/vector/curve_fit.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;

constexpr double corner_cosine = 0.766;         // of 40 degrees
constexpr double near_enough_to_improve = 16.0; // times the tolerance's square
constexpr int improvements = 4;
// Of the tolerance, at the points that are measured: between them a curve may be somewhat farther off.
constexpr double measured_share = 0.9;
constexpr int deep = 24; // from here on runs are halved in the middle, so that the depth is bounded
constexpr double most_between = 64.0;

dvec2 at(const dvec2& start, const Cubic& c, double t) noexcept {
    const double s = 1.0 - t;
    return s * s * s * start + 3.0 * s * s * t * c.control_1 + 3.0 * s * t * t * c.control_2 + t * t * t * c.end;
}

double square(const dvec2& a) noexcept { return glm::dot(a, a); }

dvec2 unit_or_zero(const dvec2& a) noexcept {
    const double length = std::sqrt(square(a));
    return length > 0.0 ? (1.0 / length) * a : dvec2(0.0);
}

} // namespace

// Points that follow each other are apart, and near enough for what lies between to be seen.
void CurveFit::densify(std::span<const dvec2> points) {
    points_.clear();
    const double spacing = 16.0 * std::sqrt(square_);
    for (const dvec2& p : points) {
        if (!points_.empty()) {
            const dvec2 from = points_[points_.size() - 1];
            const double length = std::sqrt(square(p - from));
            if (!(length > 0.0)) continue;
            const auto parts = 1 + static_cast<std::int64_t>(std::clamp(length / spacing, 1.0, most_between));
            for (std::int64_t k = 1; k < parts; ++k)
                points_.push_back(from + (static_cast<double>(k) / static_cast<double>(parts)) * (p - from));
        }
        points_.push_back(p);
    }
}

bool CurveFit::is_corner(std::int64_t before, std::int64_t i, std::int64_t after) const noexcept {
    const dvec2 a = points_[i] - points_[before];
    const dvec2 b = points_[after] - points_[i];
    return glm::dot(a, b) < corner_cosine * std::sqrt(square(a) * square(b));
}

dvec2 CurveFit::direction(std::int64_t from, std::int64_t to) const noexcept {
    return unit_or_zero(points_[to] - points_[from]);
}

// Of the parabola through an end and the next two points that are not between points, at the end.
dvec2 CurveFit::direction_from(std::int64_t end, std::int64_t other) const noexcept {
    const std::int64_t step = other > end ? 2 : -2;
    if (std::abs(other - end) < 4) return direction(end, other > end ? end + 1 : end - 1);
    const dvec2 a = points_[end + step] - points_[end];
    const dvec2 b = points_[end + 2 * step] - points_[end + step];
    const double la = std::sqrt(square(a)), lb = std::sqrt(square(b));
    if (!(la > 0.0) || !(lb > 0.0)) return unit_or_zero(a + b);
    return unit_or_zero((1.0 / la) * a + (la / (la + lb)) * ((1.0 / la) * a - (1.0 / lb) * b));
}

// Of the parabola through three points, at the middle one.
dvec2 CurveFit::direction_at(std::int64_t i, std::int64_t first, std::int64_t last) const noexcept {
    const dvec2 a = points_[i] - points_[std::max(i - 1, first)];
    const dvec2 b = points_[std::min(i + 1, last)] - points_[i];
    const double la = std::sqrt(square(a)), lb = std::sqrt(square(b));
    if (!(la > 0.0) || !(lb > 0.0)) return unit_or_zero(a + b);
    return unit_or_zero((lb / la) * a + (la / lb) * b);
}

std::span<const Cubic> CurveFit::fit(std::span<const dvec2> points, double tolerance, bool closed) {
    cubics_.clear();
    square_ = measured_share * measured_share * tolerance * tolerance;
    densify(points);
    const std::int64_t count = points_.size();
    if (count < 2) return {};
    places_.resize(count);
    const std::int64_t last = count - 1;
    bool goes_round = closed && count > 3;
    if (goes_round) {
        // A ring begins at a corner, if it has one.
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
    if (goes_round) round = unit_or_zero(direction(last - 1, last) + direction(0, 1));
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

void CurveFit::set_places(std::int64_t first, std::int64_t last) noexcept {
    places_[first] = 0.0;
    for (std::int64_t i = first + 1; i <= last; ++i)
        places_[i] = places_[i - 1] + std::sqrt(square(points_[i] - points_[i - 1]));
    const double scale = 1.0 / places_[last];
    for (std::int64_t i = first + 1; i < last; ++i) places_[i] *= scale;
    places_[last] = 1.0;
}

// One step of Newton's method towards the nearest place.
void CurveFit::improve_places(std::int64_t first, std::int64_t last, const Cubic& c) noexcept {
    const dvec2 start = points_[first];
    const dvec2 a = c.control_1 - start, b = c.control_2 - c.control_1, d = c.end - c.control_2;
    for (std::int64_t i = first + 1; i < last; ++i) {
        const double t = places_[i], s = 1.0 - t;
        const dvec2 off = at(start, c, t) - points_[i];
        const dvec2 slope = 3.0 * (s * s * a + 2.0 * s * t * b + t * t * d);
        const dvec2 bend = 6.0 * (s * (b - a) + t * (d - b));
        const double denominator = glm::dot(slope, slope) + glm::dot(off, bend);
        if (denominator > 0.0) places_[i] = std::clamp(t - glm::dot(off, slope) / denominator, 0.0, 1.0);
    }
}

// The lengths of both handles.  Where they make no sense: a third of the chord [Schneider 1990].
Cubic CurveFit::least_squares(std::int64_t first, std::int64_t last, const dvec2& from,
                              const dvec2& to) const noexcept {
    const dvec2 start = points_[first], end = points_[last];
    double c00 = 0.0, c01 = 0.0, c11 = 0.0, x0 = 0.0, x1 = 0.0;
    for (std::int64_t i = first; i <= last; ++i) {
        const double t = places_[i], s = 1.0 - t;
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

// The square of the distance, and whose it is.
double CurveFit::farthest(std::int64_t first, std::int64_t last, const Cubic& cubic,
                          std::int64_t& where) const noexcept {
    double most = 0.0;
    where = (first + last) / 2;
    for (std::int64_t i = first + 1; i < last; ++i) {
        const double off = square(at(points_[first], cubic, places_[i]) - points_[i]);
        if (off > most) {
            most = off;
            where = i;
        }
    }
    return most;
}

void CurveFit::fit_run(std::int64_t first, std::int64_t last, const dvec2& from, const dvec2& to, int depth) {
    const dvec2 start = points_[first], end = points_[last];
    if (last - first == 1) {
        cubics_.push_back({start + (1.0 / 3.0) * (end - start), start + (2.0 / 3.0) * (end - start), end});
        return;
    }
    set_places(first, last);
    std::int64_t where = 0;
    for (int i = 0; i <= improvements; ++i) {
        const Cubic cubic = least_squares(first, last, from, to);
        const double off = farthest(first, last, cubic, where);
        if (off <= square_) {
            cubics_.push_back(cubic);
            return;
        }
        if (off > near_enough_to_improve * square_) break;
        improve_places(first, last, cubic);
    }
    if (depth >= deep) where = (first + last) / 2;
    const dvec2 along = direction_at(where, first, last);
    fit_run(first, where, from, -along, depth + 1);
    fit_run(where, last, along, to, depth + 1);
}

} // namespace hrbfnpr::output
