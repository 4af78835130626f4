// SPDX-License-Identifier: MIT
// 1. take() copies the points without repetitions.
// 2. find_circle() fits a circle to a closed line without corners.
// 3. split() divides a run of points: each part is the line or the arc that reaches farthest from the end of the part
//    before it. Each arc is the one through both ends that fits the points between them best.
// 4. move_breaks() moves the ends of the parts to where the sum of the squared errors is least. The first parts reach
//    too far, as the tolerance allows it.
// 5. fit() keeps the cubics of a run if the curve does not consist of the parts, or if there are more of them than
//    cubics.
#include "output/vector/curves.h"

#include "output/vector/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hrbfnpr::output {
namespace {

using glm::dvec2;
using Kind = CurvePiece::Kind;
using Points = std::span<const dvec2>;

constexpr double full_turn = 2.0 * std::numbers::pi;

struct Arc {
    dvec2 centre{0.0};
    double radius = 0.0, sweep = 0.0;
};

double cross(const dvec2& a, const dvec2& b) noexcept { return a.x * b.y - a.y * b.x; }

// Computes the sweep of the polyline around the arc's centre. Returns false if the polyline is not within the tolerance
// of the arc, or if it turns back.
bool find_sweep(Points points, double tolerance, Arc& arc) noexcept {
    if (!(arc.radius <= arc_tuning.largest_radius)) return false;
    arc.sweep = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const dvec2 a = points[i - 1] - arc.centre, b = points[i] - arc.centre;
        if (!(std::abs(glm::length(b) - arc.radius) <= tolerance)) return false;
        if (!(geometry::distance_to_segment(arc.centre, points[i - 1], points[i]) >= arc.radius - tolerance))
            return false;
        const double turn = std::atan2(cross(a, b), glm::dot(a, b));
        if (arc.sweep * turn < 0.0 && std::abs(turn) * arc.radius > tolerance) return false;
        arc.sweep += turn;
    }
    return arc.sweep != 0.0 && std::abs(arc.sweep) <= full_turn * (1.0 + 1e-9);
}

// Finds the arc through the first and the last point that fits the others best. Circles through both ends have their
// centres on one line; with q the squared distance of a point from the middle of the ends and s its distance from the
// chord, q - half^2 - 2 t s is zero on the circle whose centre is at t. The squares of these errors are least.
bool find_arc(Points points, double tolerance, Arc& arc) noexcept {
    if (points.size() < 3) return false;
    const dvec2 chord = points.back() - points.front();
    const double half = 0.5 * glm::length(chord);
    if (!(half > 0.0)) return false;
    const dvec2 middle = points.front() + 0.5 * chord, normal = dvec2(-chord.y, chord.x) / (2.0 * half);
    double above = 0.0, below = 0.0;
    for (const dvec2& p : points) {
        const dvec2 from = p - middle;
        const double s = glm::dot(from, normal);
        above += (glm::dot(from, from) - half * half) * s;
        below += s * s;
    }
    if (!(below > 0.0)) return false;
    const double t = 0.5 * above / below;
    arc.centre = middle + t * normal;
    arc.radius = std::hypot(half, t);
    return find_sweep(points, tolerance, arc);
}

// Finds the circle with the least squared errors of squared distances [Kasa 1976, "A circle fitting procedure and its
// error analysis"], and the part of it along a line or a ring.
bool find_circle(Points points, double tolerance, Arc& arc) noexcept {
    if (points.size() < 5) return false;
    const Points once = points.first(points.size() - (points.front() == points.back() ? 1 : 0));
    const double share = 1.0 / static_cast<double>(once.size());
    dvec2 mean(0.0);
    for (const dvec2& p : once) mean += share * p;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    dvec2 cubes(0.0);
    for (const dvec2& p : once) {
        const dvec2 d = p - mean;
        xx += share * d.x * d.x;
        xy += share * d.x * d.y;
        yy += share * d.y * d.y;
        cubes += share * glm::dot(d, d) * d;
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0.0)) return false;
    const dvec2 off = 0.5 / determinant * dvec2(yy * cubes.x - xy * cubes.y, xx * cubes.y - xy * cubes.x);
    arc.centre = mean + off;
    arc.radius = std::sqrt(glm::dot(off, off) + xx + yy);
    return std::abs(glm::distance(points[0], arc.centre) - arc.radius) <= tolerance &&
           find_sweep(points, tolerance, arc);
}

bool is_full(const Arc& arc) noexcept { return std::abs(arc.sweep) > full_turn * (1.0 - 1e-9); }

// Makes an arc of a circle that was found for points. Its ends are the places of the circle nearest to theirs.
CurveLine arc_along(Points points, const Arc& arc, base::Array<CurvePiece>& pieces) {
    const auto on_circle = [&](const dvec2& p) { return arc.centre + arc.radius * glm::normalize(p - arc.centre); };
    CurvePiece piece;
    piece.kind = Kind::arc;
    piece.end = on_circle(points.back());
    piece.centre = arc.centre;
    piece.sweep = arc.sweep;
    pieces.clear();
    pieces.push_back(piece);
    return {on_circle(points.front()), pieces.span()};
}

bool fits(Kind kind, Points points, double tolerance) noexcept {
    if (kind == Kind::arc) {
        Arc arc;
        return find_arc(points, tolerance, arc);
    }
    return std::all_of(points.begin(), points.end(), [&](const dvec2& p) {
        return geometry::squared_distance_to_segment(p, points.front(), points.back()) <= tolerance * tolerance;
    });
}

// Returns the number of points, from the first on, that a line or an arc fits: at least 2 for a line, else 0. The
// number doubles as long as the piece fits, and is then found by bisection.
std::size_t reach(Kind kind, Points points, double tolerance) noexcept {
    std::size_t good = kind == Kind::line ? 2 : 0;
    std::size_t bad = points.size() + 1;
    for (std::size_t count = 3; count < bad;) {
        if (fits(kind, points.first(count), tolerance)) {
            good = count;
            if (count == points.size()) break;
            count = std::min(2 * count - 1, points.size());
        } else {
            bad = count;
        }
    }
    while (good > 0 && bad - good > 1) {
        const std::size_t count = good + (bad - good) / 2;
        (fits(kind, points.first(count), tolerance) ? good : bad) = count;
    }
    return good;
}

double squared_error(Kind kind, Points points) noexcept {
    constexpr double none = std::numeric_limits<double>::infinity();
    Arc arc;
    if (kind == Kind::arc && !find_arc(points, none, arc)) return none;
    double sum = 0.0;
    for (const dvec2& p : points) {
        const double off = glm::distance(p, arc.centre) - arc.radius;
        sum += kind == Kind::arc ? off * off : geometry::squared_distance_to_segment(p, points.front(), points.back());
    }
    return sum;
}

CurvePiece piece_of(Kind kind, Points points) noexcept {
    CurvePiece piece;
    piece.kind = kind;
    piece.end = points.back();
    Arc arc;
    if (kind == Kind::arc) {
        find_arc(points, std::numeric_limits<double>::infinity(), arc);
        piece.centre = arc.centre;
        piece.sweep = arc.sweep;
    }
    return piece;
}

// Returns the direction of a piece at a place on it.
dvec2 direction_at(const CurvePiece& piece, const dvec2& start, const dvec2& place) noexcept {
    if (piece.kind == Kind::line) return piece.end - start;
    const dvec2 out = place - piece.centre;
    return piece.sweep > 0.0 ? dvec2(-out.y, out.x) : dvec2(out.y, -out.x);
}

bool is_corner(const dvec2& before, const dvec2& at, const dvec2& after) noexcept {
    const dvec2 a = at - before, b = after - at;
    return glm::dot(a, b) < geometry::curve_fit_tuning.corner_cosine * std::sqrt(glm::dot(a, a) * glm::dot(b, b));
}

Points run_of(const base::Array<dvec2>& points, std::int64_t first, std::int64_t last) noexcept {
    HRBFNPR_ASSERT(0 <= first && first < last && last < points.size());
    return points.span().subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first + 1));
}

} // namespace

void CurvePieces::take(Points points) {
    points_.clear();
    pieces_.clear();
    for (const dvec2& p : points)
        if (points_.empty() || p != points_.back()) points_.push_back(p);
}

// Divides a run of points into parts. Returns false if more than `most` are needed.
bool CurvePieces::split(std::int64_t first, std::int64_t last, double tolerance, std::int64_t most) {
    parts_.clear();
    while (first < last) {
        if (parts_.size() == most) return false;
        const Points rest = run_of(points_, first, last);
        const std::size_t line = reach(Kind::line, rest, tolerance), arc = reach(Kind::arc, rest, tolerance);
        const auto end = first + static_cast<std::int64_t>(std::max(line, arc)) - 1;
        parts_.push_back({arc > line ? Kind::arc : Kind::line, first, end});
        first = end;
    }
    return true;
}

void CurvePieces::move_breaks(double tolerance) noexcept {
    for (std::int64_t i = 1; i < parts_.size(); ++i) {
        Part &a = parts_[i - 1], &b = parts_[i];
        const auto error_at = [&](std::int64_t at) {
            return squared_error(a.kind, run_of(points_, a.first, at)) +
                   squared_error(b.kind, run_of(points_, at, b.last));
        };
        std::int64_t best = a.last;
        double least = error_at(best);
        for (std::int64_t step = std::max((a.last - a.first) / 4, std::int64_t{1}); step > 0;) {
            std::int64_t better = best;
            for (const std::int64_t at : {best - step, best + step}) {
                if (at <= a.first || at >= b.last) continue;
                if (const double error = error_at(at); error < least) {
                    least = error;
                    better = at;
                }
            }
            if (better == best) step /= 2;
            best = better;
        }
        if (fits(a.kind, run_of(points_, a.first, best), tolerance) &&
            fits(b.kind, run_of(points_, best, b.last), tolerance))
            a.last = b.first = best;
    }
}

// Adds the parts to the pieces.
void CurvePieces::add_parts() {
    for (const Part& part : parts_) pieces_.push_back(piece_of(part.kind, run_of(points_, part.first, part.last)));
}

// Returns whether the parts are the lines and arcs that the curve consists of, and not just near it. Consecutive parts
// have the same direction where they meet, lines and arcs alternate unless the curve bends to the other side, and each
// arc turns by more than directions may differ.
bool CurvePieces::are_the_curve(bool goes_round) const noexcept {
    const auto found = [&](const Part& part) { return piece_of(part.kind, run_of(points_, part.first, part.last)); };
    for (std::int64_t i = 0; i < parts_.size(); ++i) {
        const Part& b = parts_[i];
        const CurvePiece after = found(b);
        if (b.kind == Kind::arc && std::abs(after.sweep) < arc_tuning.widest_kink) return false;
        if (i == 0 && !goes_round) continue;
        const Part& a = parts_[i > 0 ? i - 1 : parts_.size() - 1];
        const CurvePiece before = found(a);
        if (a.kind == b.kind && before.sweep * after.sweep >= 0.0) return false;
        const dvec2 place = points_[b.first];
        const dvec2 in = direction_at(before, points_[a.first], place), out = direction_at(after, place, place);
        if (!(std::atan2(std::abs(cross(in, out)), glm::dot(in, out)) <= arc_tuning.widest_kink)) return false;
    }
    return true;
}

// Divides a run into at most `most` parts that can replace cubics.
bool CurvePieces::find_parts(std::int64_t first, std::int64_t last, double tolerance, std::int64_t most,
                             bool goes_round) {
    const double closer = arc_tuning.share_of_several * tolerance;
    if (!goes_round) {
        const Points run = run_of(points_, first, last);
        const bool is_line = fits(Kind::line, run, closer) ||
                             (fits(Kind::line, run, tolerance) &&
                              arc_tuning.least_gain * squared_error(Kind::arc, run) > squared_error(Kind::line, run));
        parts_.clear();
        parts_.push_back({is_line ? Kind::line : Kind::arc, first, last});
        if (is_line || fits(Kind::arc, run, tolerance)) return true;
    }
    if (goes_round) { // let the ring begin where a part ends
        if (!split(first, last, closer, most + 1) || parts_.size() < 2) return false;
        const std::int64_t start = parts_[0].last;
        points_.resize(last);
        std::rotate(points_.begin(), points_.begin() + start, points_.end());
        points_.push_back(points_[0]);
    }
    if (!split(first, last, closer, most)) return false;
    move_breaks(closer);
    return are_the_curve(goes_round);
}

CurveLine CurvePieces::fit(Points points, double tolerance, bool closed, Curves curves) {
    HRBFNPR_ASSERT(tolerance > 0.0 && !points.empty());
    take(points);
    const std::int64_t last = points_.size() - 1;
    if (curves == Curves::lines) {
        geometry::simplify_polyline(Points(points_.span()), tolerance, keeps_);
        for (std::int64_t i = 1; i <= last; ++i)
            if (keeps_[i] != 0) pieces_.push_back({Kind::line, points_[i]});
        return result(points_[0]);
    }
    const std::span<const geometry::Cubic> cubics = fit_.fit(points, tolerance, closed);
    if (cubics.empty()) return result(points_[0]);
    dvec2 start = closed ? cubics.back().end : points_[0];
    const auto add_cubic = [&](const geometry::Cubic& c) {
        pieces_.push_back({Kind::cubic, c.end, c.control_1, c.control_2});
    };
    // Cubics begin at the first corner of a closed line.
    const bool is_ring = closed && last > 2 && points_[0] == points_[last];
    std::int64_t corner = 0;
    if (is_ring) {
        while (corner < last &&
               !is_corner(points_[corner > 0 ? corner - 1 : last - 1], points_[corner], points_[corner + 1]))
            ++corner;
        if (corner > 0 && corner < last) {
            points_.resize(last);
            std::rotate(points_.begin(), points_.begin() + corner, points_.end());
            points_.push_back(points_[0]);
        }
    }
    const bool goes_round = is_ring && corner == last;
    Arc circle;
    if (curves == Curves::arcs && goes_round && find_circle(points_.span(), tolerance, circle) && is_full(circle))
        return arc_along(points_.span(), circle, pieces_);
    std::size_t next = 0; // the first cubic of the run
    for (std::int64_t begin = 0; begin < last;) {
        std::int64_t end = begin + 1;
        while (end < last && !is_corner(points_[end - 1], points_[end], points_[end + 1])) ++end;
        std::size_t after = next; // the first cubic after the run
        while (after < cubics.size() && (after == next || cubics[after - 1].end != points_[end])) ++after;
        if (end == last) after = cubics.size();
        if (curves == Curves::arcs &&
            find_parts(begin, end, tolerance, static_cast<std::int64_t>(after - next), goes_round)) {
            if (goes_round) start = points_[0];
            add_parts();
        } else if (curves == Curves::arcs && !closed && end - begin == last &&
                   find_circle(points_.span(), tolerance, circle)) {
            // A nearly full circle, whose centre does not follow from its ends
            return arc_along(points_.span(), circle, pieces_);
        } else {
            std::for_each(cubics.begin() + static_cast<std::ptrdiff_t>(next),
                          cubics.begin() + static_cast<std::ptrdiff_t>(after), add_cubic);
        }
        next = after;
        begin = end;
    }
    return result(start);
}

CurveLine CurvePieces::fit_arcs(Points points, double tolerance, bool closed) {
    HRBFNPR_ASSERT(tolerance > 0.0 && !points.empty());
    take(points);
    const std::int64_t last = points_.size() - 1;
    Arc circle;
    if (closed && last > 0 && points_[0] == points_[last] && find_circle(points_.span(), tolerance, circle) &&
        is_full(circle))
        return arc_along(points_.span(), circle, pieces_);
    if (last > 0) {
        split(0, last, tolerance, last);
        move_breaks(tolerance);
        add_parts();
    }
    return result(points_[0]);
}

} // namespace hrbfnpr::output
