// SPDX-License-Identifier: MIT
#include "curves/cusps.h"

#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::curves {
namespace {

constexpr int most_steps = 40;
// Where more points are put on a piece that has a cusp.
constexpr std::array<double, 3> inner_shares = {0.25, 0.5, 0.75};
// In lengths of a piece: a point that came onto the curve by a shorter step knows enough of it.
constexpr double near_curve = 2e-4;
// In lengths of the piece: where a cusp is known so well, the search for it ends; nearer to an end of the piece than
// the second, that end is replaced.
constexpr double known = 1e-8;
constexpr double at_end = 1e-2;

// v^T H v = v . grad g on the contour: the radial curvature but for a positive factor.
double radial(const CurvePoint& p, const View& view) noexcept {
    return glm::dot(p.level_gradient, view.sight(p.position));
}

// The same along a cubic between points, by normals between theirs: t . (n x v) = v . grad g for t = n x grad g.
double radial_of(const CubicPiece& cubic, const CurvePoint& a, const CurvePoint& b, const View& view,
                 double u) noexcept {
    const glm::dvec3 normal = (1.0 - u) * glm::normalize(a.gradient) + u * glm::normalize(b.gradient);
    return glm::dot(cubic.derivative(u), glm::cross(normal, view.sight(cubic.at(u))));
}

// Whether the radial curvature changes its sign on the way.
bool changes_between(const CurvePoint& a, const CurvePoint& b, const View& view) noexcept {
    const CubicPiece cubic(a, b);
    const bool first = radial(a, view) < 0.0;
    for (const double u : inner_shares)
        if ((radial_of(cubic, a, b, view, u) < 0.0) != first) return true;
    return (radial(b, view) < 0.0) != first;
}

// The curves with points added where there are cusps: two of them may lie between two points.
Curves refined_at_cusps(const base::Runtime& runtime, const Level& contour, const View& view, const Curves& curves,
                        std::int64_t& evaluations, const base::Progress& progress) {
    base::Array<CurvePoint> added(runtime.memory);
    base::Array<double> enough(runtime.memory);
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
                enough.push_back(near_curve * cubic.length());
            }
            after.push_back(at);
        }
    }
    bring_closer(runtime, contour, enough, added, evaluations, progress);
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
    double low_value, high_value;
    double share = 0.5;
    CurvePoint a, b; // of the curve, where low and high are
    int side = 0;    // that moved last
    CurvePoint found;
    bool done = false;
};

// Illinois: regula falsi that halves the value of an end which stays twice.  The value may jump at a sample.
void narrow(Search& s, double value) noexcept {
    if ((value < 0.0) == (s.low_value < 0.0)) {
        s.low = s.share;
        s.a = s.found;
        s.low_value = value;
        if (s.side < 0) s.high_value *= 0.5;
        s.side = -1;
    } else {
        s.high = s.share;
        s.b = s.found;
        s.high_value = value;
        if (s.side > 0) s.low_value *= 0.5;
        s.side = 1;
    }
    s.done = s.high - s.low <= known;
    const double share = s.low - s.low_value * (s.high - s.low) / (s.high_value - s.low_value);
    const double next = share > s.low && share < s.high ? share : 0.5 * (s.low + s.high);
    s.done = s.done || std::abs(next - s.share) <= known;
    s.share = next;
}

base::Array<Search> find_changes(base::Memory& memory, const View& view, const Curves& curves) {
    base::Array<Search> found(memory);
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        for (std::int64_t k = 0; k < curves.pieces_of(c); ++k) {
            const std::int64_t at = curves.first[c] + k;
            const std::int64_t next = curves.next(c, at);
            const CurvePoint& p = curves.point[at];
            const CurvePoint& q = curves.point[next];
            const double a = radial(p, view);
            const double b = radial(q, view);
            if ((a < 0.0) != (b < 0.0)) found.push_back({at, next, 0.0, 1.0, a, b, a / (a - b), p, q, 0, {}, false});
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
    base::Array<double> enough(runtime.memory);
    for (int step = 0; step < most_steps && !active.empty(); ++step) {
        points.resize(active.size());
        enough.resize(active.size());
        for (std::int64_t i = 0; i < active.size(); ++i) {
            const Search& s = searches[active[i]];
            const CubicPiece cubic(s.a, s.b);
            points[i].position = cubic.at((s.share - s.low) / (s.high - s.low));
            enough[i] = step == 0 ? near_curve * cubic.length() : std::numeric_limits<double>::infinity();
        }
        bring_closer(runtime, contour, enough, points, evaluations, progress);
        std::int64_t left = 0;
        for (std::int64_t i = 0; i < active.size(); ++i) {
            Search& s = searches[active[i]];
            s.found = points[i];
            narrow(s, radial(points[i], view));
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
