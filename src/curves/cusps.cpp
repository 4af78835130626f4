// SPDX-License-Identifier: MIT
#include "curves/cusps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::curves {
namespace {

constexpr int cusp_steps = 40;
constexpr int trusted_steps = 6; // after these every step halves what is left: the value may jump at a sample
constexpr int model_steps = 8;   // on a cubic, with no evaluation
// Where more points are put on a piece that has a cusp.
constexpr std::array<double, 3> inner_shares = {0.25, 0.5, 0.75};
// Of an angle with the line of sight: pieces, which turn by a third of a radian, come to no cusp from there and back.
constexpr double clear_of_cusps = 0.5;
// In lengths of a piece: a point that came onto the curve by a shorter step knows enough of it.
constexpr double near_curve = 2e-4;
// In lengths of the piece: where a cusp is known so well, the search for it ends; nearer to an end of the piece than
// the second, that end is replaced.
constexpr double known_cusp = 1e-8;
// In lengths of the piece, too: a point that is led farther off it belongs to another curve.
constexpr double astray = 0.3;
constexpr double at_end = 1e-2;

// A point of a piece, that was brought closer; where its level has a kink, a step may lead anywhere.
void keep_beside(CurvePoint& p, const glm::dvec3& place, double length) noexcept {
    if (!(glm::distance(p.position, place) <= astray * length)) p.position = place;
}

// v^T H v = v . grad g on the contour: the radial curvature but for a positive factor.
double radial(const CurvePoint& p, const View& view) noexcept {
    return glm::dot(p.level_gradient, view.sight(p.position));
}

// The same along a cubic between points, by normals between theirs, but for the length of n x grad g:
// t . (n x v) = v . grad g for t = n x grad g.
class RadialModel {
public:
    RadialModel(const CurvePoint& a, const CurvePoint& b, const View& view) noexcept
        : view_(view), cubic_(a, b), begin_(glm::normalize(a.gradient)), end_(glm::normalize(b.gradient)) {}

    [[nodiscard]] double at(double u) const noexcept {
        const glm::dvec3 normal = (1.0 - u) * begin_ + u * end_;
        return glm::dot(glm::normalize(cubic_.derivative(u)), glm::cross(normal, view_.sight(cubic_.at(u))));
    }
    // By u, of what radial() is at a point of the curve there.
    [[nodiscard]] double slope(double u, const CurvePoint& p) const noexcept {
        constexpr double h = 1e-4;
        return (at(u + h) - at(u - h)) / (2.0 * h) * glm::length(p.direction()) / glm::length(p.gradient);
    }
    // Where it changes its sign, if it does between the ends.  By regula falsi; the value of an end that stays twice is
    // halved: Illinois.
    [[nodiscard]] double root() const noexcept {
        struct End {
            double at, value;
        };
        End fixed{0.0, at(0.0)};
        End moved{1.0, at(1.0)};
        if ((fixed.value < 0.0) == (moved.value < 0.0)) return 0.5;
        const auto between = [&] {
            return moved.at - moved.value * (moved.at - fixed.at) / (moved.value - fixed.value);
        };
        for (int step = 0; step < model_steps; ++step) {
            const double u = between();
            const End next{u, at(u)};
            if ((next.value < 0.0) == (moved.value < 0.0))
                fixed.value *= 0.5;
            else
                fixed = moved;
            moved = next;
        }
        return between();
    }

private:
    const View& view_;
    CubicPiece cubic_;
    glm::dvec3 begin_, end_;
};

// The sine of the angle between the curve and the line of sight, with the sign of the radial curvature.
double sine(const CurvePoint& p, const View& view) noexcept {
    const glm::dvec3 sight = view.sight(p.position);
    return radial(p, view) * glm::length(p.gradient) / (glm::length(sight) * glm::length(p.direction()));
}

// Whether the radial curvature changes its sign on the way.
bool changes_between(const CurvePoint& a, const CurvePoint& b, const View& view) noexcept {
    const double begin = sine(a, view);
    const double end = sine(b, view);
    if (std::min(begin, end) > clear_of_cusps || std::max(begin, end) < -clear_of_cusps) return false;
    const RadialModel model(a, b, view);
    const bool first = begin < 0.0;
    for (const double u : inner_shares)
        if ((model.at(u) < 0.0) != first) return true;
    return (end < 0.0) != first;
}

// The curves with points added where there are cusps: two of them may lie between two points.
Curves refined_at_cusps(const base::Runtime& runtime, const Level& contour, const View& view, const Curves& curves,
                        std::int64_t& evaluations, const base::Progress& progress) {
    base::Array<CurvePoint> added(runtime.memory);
    geometry::VecArray place(runtime.memory); // of these on their pieces
    base::Array<double> length(runtime.memory), enough(runtime.memory);
    base::Array<std::int64_t> after(runtime.memory); // which point
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        for (std::int64_t k = 0; k < curves.pieces_of(c); ++k) {
            const std::int64_t at = curves.first[c] + k;
            const CurvePoint& a = curves.point[at];
            const CurvePoint& b = curves.point[curves.next(c, at)];
            if (!changes_between(a, b, view)) continue;
            const CubicPiece cubic(a, b);
            for (const double u : inner_shares) {
                CurvePoint p;
                p.position = cubic.at(u);
                added.push_back(p);
                place.push_back(p.position);
                length.push_back(cubic.length());
                enough.push_back(near_curve * cubic.length());
            }
            after.push_back(at);
        }
    }
    bring_closer(runtime, contour, enough, added, evaluations, progress);
    for (std::int64_t i = 0; i < added.size(); ++i) keep_beside(added[i], place[i], length[i]);
    Curves result(runtime.memory);
    result.first.push_back(0);
    std::int64_t next = 0;
    constexpr auto count = static_cast<std::int64_t>(inner_shares.size());
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        for (std::int64_t at = curves.first[c]; at < curves.first[c + 1]; ++at) {
            result.point.push_back(curves.point[at]);
            if (next >= after.size() || after[next] != at) continue;
            for (std::int64_t k = 0; k < count; ++k) result.point.push_back(added[count * next + k]);
            ++next;
        }
        result.first.push_back(result.point.size());
        result.closed.push_back(curves.closed[c]);
    }
    return result;
}

// A change of sign between two points of a curve.
struct Search {
    std::int64_t piece; // its first point
    std::int64_t next;
    double low = 0.0, high = 1.0;
    bool low_negative;
    double share = 0.5;
    double last_share = 0.0, last_value = 0.0;
    CurvePoint a, b; // of the curve, where low and high are
    CurvePoint found = {};
    int steps = 0;
    bool done = false;
};

// By the cubic's slope at first, then by secants.
double next_share(const Search& s, double value, const View& view) noexcept {
    if (s.steps > trusted_steps) return 0.5 * (s.low + s.high);
    const double slope = s.steps == 1 ? RadialModel(s.a, s.b, view).slope(s.share, s.found)
                                      : (value - s.last_value) / (s.share - s.last_share);
    const double next = s.share - value / slope;
    return next > s.low && next < s.high ? next : 0.5 * (s.low + s.high);
}

void narrow(Search& s, double value, const View& view) noexcept {
    ++s.steps;
    const bool is_low = (value < 0.0) == s.low_negative;
    (is_low ? s.low : s.high) = s.share;
    const double next = next_share(s, value, view);
    (is_low ? s.a : s.b) = s.found;
    s.done = s.high - s.low <= known_cusp || std::abs(next - s.share) <= known_cusp;
    s.last_share = std::exchange(s.share, next);
    s.last_value = value;
}

base::Array<Search> find_changes(base::Memory& memory, const View& view, const Curves& curves) {
    base::Array<Search> found(memory);
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        for (std::int64_t k = 0; k < curves.pieces_of(c); ++k) {
            const std::int64_t at = curves.first[c] + k;
            const std::int64_t next = curves.next(c, at);
            const CurvePoint& p = curves.point[at];
            const CurvePoint& q = curves.point[next];
            const bool negative = radial(p, view) < 0.0;
            if (negative != (radial(q, view) < 0.0))
                found.push_back({at, next, 0.0, 1.0, negative, RadialModel(p, q, view).root(), 0.0, 0.0, p, q});
        }
    }
    return found;
}

// Points of cubics are brought onto the curve before their values are asked for: the first by two steps if it is off.
// Then a cubic begins or ends near the place, and one step says as much of it.
void search(const base::Runtime& runtime, const Level& contour, const View& view, base::Array<Search>& searches,
            std::int64_t& evaluations, const base::Progress& progress) {
    base::Array<std::int64_t> active(runtime.memory);
    for (std::int64_t i = 0; i < searches.size(); ++i) active.push_back(i);
    base::Array<CurvePoint> points(runtime.memory);
    geometry::VecArray place(runtime.memory);
    base::Array<double> enough(runtime.memory);
    for (int step = 0; step < cusp_steps && !active.empty(); ++step) {
        points.resize(active.size());
        place.resize(active.size());
        enough.resize(active.size());
        for (std::int64_t i = 0; i < active.size(); ++i) {
            const Search& s = searches[active[i]];
            const CubicPiece cubic(s.a, s.b);
            points[i].position = cubic.at((s.share - s.low) / (s.high - s.low));
            place.set(i, points[i].position);
            enough[i] = step == 0 ? near_curve * cubic.length() : std::numeric_limits<double>::infinity();
        }
        bring_closer(runtime, contour, enough, points, evaluations, progress);
        std::int64_t left = 0;
        for (std::int64_t i = 0; i < active.size(); ++i) {
            Search& s = searches[active[i]];
            keep_beside(points[i], place[i], glm::distance(s.a.position, s.b.position));
            s.found = points[i];
            narrow(s, radial(points[i], view), view);
            if (!s.done) active[left++] = active[i];
        }
        active.resize(left);
    }
}

} // namespace

Curves with_cusps(const base::Runtime& runtime, const Level& contour, const View& view, const Curves& given,
                  std::int64_t& evaluations, const base::Progress& progress) {
    const Curves curves = refined_at_cusps(runtime, contour, view, given, evaluations, progress);
    base::Array<Search> searches = find_changes(runtime.memory, view, curves);
    search(runtime, contour, view, searches, evaluations, progress);
    Curves result(runtime.memory);
    result.first.push_back(0);
    const auto add = [&](const CurvePoint& p, bool cusp) {
        result.point.push_back(p);
        result.cusp.push_back(cusp ? 1 : 0);
    };
    std::int64_t s = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        bool replaced = false; // the point that comes next, by a cusp just before it
        for (std::int64_t at = curves.first[c]; at < curves.first[c + 1]; ++at) {
            const bool changes = s < searches.size() && searches[s].piece == at;
            const double share = changes ? searches[s].share : 0.5;
            if (!replaced && !(changes && share < at_end)) add(curves.point[at], false);
            replaced = changes && share > 1.0 - at_end && searches[s].next > at;
            if (changes) add(searches[s++].found, true);
        }
        result.first.push_back(result.point.size());
        result.closed.push_back(curves.closed[c]);
    }
    return result;
}

} // namespace hrbfnpr::curves
