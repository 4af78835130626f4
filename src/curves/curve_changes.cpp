// SPDX-License-Identifier: MIT
// All changes are found in one way: where a function has different signs at the ends of a piece, a Bracket narrows to
// its zero, and the places that it asks for are points of the piece's cubic, brought onto the curve.
#include "curves/curve_changes.h"

#include "curves/surface_lines.h"
#include "curves/tuning.h"
#include "implicit/evaluate_all.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// The zero of a function on a piece of a curve, by the Illinois method [Dowell & Jarratt 1971].
struct Bracket {
    std::int64_t piece, next; // the points of the curve between which it lies
    double at_low, at_high;   // values of different signs
    double low = 0.0, high = 1.0;
    double share = 0.5; // where the function is to be evaluated next
    int kept = 0;       // how often the same end was kept, negative for the low one
    int steps = 0;
    bool done = false; // whether `share` is the zero

    void begin() noexcept { share = at_low / (at_low - at_high); }
    void take(double value) noexcept {
        HRBFNPR_ASSERT(low <= share && share <= high);
        const bool is_low = (value < 0.0) == (at_low < 0.0);
        (is_low ? low : high) = share;
        (is_low ? at_low : at_high) = value;
        kept = is_low ? std::max(1, kept + 1) : std::min(-1, kept - 1);
        if (kept > 1) at_high *= 0.5;
        if (kept < -1) at_low *= 0.5;
        double wanted = low + (high - low) * at_low / (at_low - at_high);
        // The value may jump, as at a sample: then halving goes on.
        if (++steps > curve_tuning.trusted_steps || !(wanted > low && wanted < high)) wanted = 0.5 * (low + high);
        done = value == 0.0 || !(high - low > curve_tuning.exact) || std::abs(wanted - share) <= curve_tuning.exact ||
               steps == curve_tuning.most_steps;
        if (!done) share = wanted;
    }
};

// A place of the cubic between two points of a curve, to be brought onto the curve.
struct OnPiece {
    CurvePoint a, b;
    double share;
    CurvePoint found = {};
    bool astray = false; // whether it came onto another curve; then `found` is left on the cubic
};

// Brings places onto their curves by one or two of Newton's steps. Adds to `evaluations`.
void bring_onto(const base::Runtime& runtime, const Level& level, base::Array<OnPiece>& places,
                std::int64_t& evaluations, const base::Progress& progress) {
    base::Array<CurvePoint> points(runtime.memory, places.size());
    base::Array<double> enough(runtime.memory, places.size());
    geometry::VecArray begin(runtime.memory, places.size());
    for (std::int64_t i = 0; i < places.size(); ++i) {
        const CubicPiece cubic(places[i].a, places[i].b);
        begin.set(i, points[i].position = cubic.at(places[i].share));
        enough[i] = curve_tuning.near_curve * cubic.length();
    }
    bring_closer(runtime, level, enough, points, evaluations, progress);
    for (std::int64_t i = 0; i < places.size(); ++i) {
        OnPiece& place = places[i];
        const double most = curve_tuning.astray * glm::distance(place.a.position, place.b.position);
        place.astray = !(glm::distance(points[i].position, begin[i]) <= most);
        place.found = points[i];
        if (place.astray) place.found.position = begin[i];
    }
}

// Narrows brackets until all are done; value(place) is the function at a point of the curve. Returns the points.
template <class Value>
base::Array<CurvePoint> find_zeros(const base::Runtime& runtime, const Level& level, const Curves& curves,
                                   base::Array<Bracket>& brackets, Value&& value, std::int64_t& evaluations,
                                   const base::Progress& progress) {
    base::Array<CurvePoint> found(runtime.memory, brackets.size());
    // The piece between the ends of the bracket: it comes to lie on the curve.
    struct Ends {
        CurvePoint low, high;
    };
    base::Array<Ends> ends(runtime.memory);
    base::Array<std::int64_t> active(runtime.memory);
    for (std::int64_t i = 0; i < brackets.size(); ++i) {
        ends.push_back({curves.point[brackets[i].piece], curves.point[brackets[i].next]});
        active.push_back(i);
    }
    base::Array<OnPiece> places(runtime.memory);
    while (!active.empty()) {
        places.clear();
        for (const std::int64_t i : active) {
            const Bracket& b = brackets[i];
            places.push_back({ends[i].low, ends[i].high, (b.share - b.low) / (b.high - b.low)});
        }
        bring_onto(runtime, level, places, evaluations, progress);
        std::int64_t left = 0;
        for (std::int64_t k = 0; k < places.size(); ++k) {
            const std::int64_t i = active[k];
            Bracket& b = brackets[i];
            found[i] = places[k].found;
            const double before = b.low;
            b.take(value(found[i]));
            (b.low != before ? ends[i].low : ends[i].high) = found[i];
            if (!b.done) active[left++] = i;
        }
        active.resize(left);
    }
    return found;
}

// A point on the piece that begins at a point of a curve.
struct AddedPoint {
    std::int64_t piece;
    double share;
    CurvePoint point;
};

// Appends a curve with the points that were added on its pieces; `next` is the first of these and goes on to the next
// curve's.
void append_with(const Curves& curves, std::int64_t curve, const base::Array<AddedPoint>& added, std::int64_t& next,
                 Curves& result) {
    for (std::int64_t at = curves.first[curve]; at < curves.first[curve + 1]; ++at) {
        result.point.push_back(curves.point[at]);
        for (; next < added.size() && added[next].piece == at; ++next) result.point.push_back(added[next].point);
    }
    result.end_curve(curves.closed[curve] != 0);
}

// ---- Cusps

// v^T H v = v . grad g on the contour: the radial curvature but for a positive factor.
double radial(const CurvePoint& p, const View& view) noexcept {
    return glm::dot(p.level_gradient, view.sight(p.position));
}

// Two cusps may lie between two points: pieces that may have one get points at these shares.
constexpr std::array<double, 3> inner_shares = {0.25, 0.5, 0.75};

// Whether the radial curvature may change its sign on the way.
bool changes_between(const CurvePoint& a, const CurvePoint& b, const View& view) noexcept {
    // The sine of the angle between the curve and the line of sight, with the sign of the radial curvature.
    const auto sine = [&](const CurvePoint& p) {
        const glm::dvec3 sight = view.sight(p.position);
        return radial(p, view) * glm::length(p.gradient) / (glm::length(sight) * glm::length(p.direction()));
    };
    const double begin = sine(a);
    const double end = sine(b);
    if (std::min(begin, end) > curve_tuning.clear_of_cusps || std::max(begin, end) < -curve_tuning.clear_of_cusps)
        return false;
    // The same along the cubic by normals between the ends', but for the length of n x grad g:
    // t . (n x v) = v . grad g for t = n x grad g.
    const CubicPiece cubic(a, b);
    const auto turned = [&](double u) {
        const glm::dvec3 normal = (1.0 - u) * glm::normalize(a.gradient) + u * glm::normalize(b.gradient);
        const glm::dvec3 along = cubic.derivative(u);
        return (glm::dot(along, glm::cross(normal, view.sight(cubic.at(u)))) < 0.0) != (begin < 0.0);
    };
    return (end < 0.0) != (begin < 0.0) || std::any_of(inner_shares.begin(), inner_shares.end(), turned);
}

Curves refined_at_cusps(const base::Runtime& runtime, const Level& contour, const View& view, const Curves& curves,
                        std::int64_t& evaluations, const base::Progress& progress) {
    base::Array<OnPiece> places(runtime.memory);
    base::Array<AddedPoint> added(runtime.memory);
    for (std::int64_t c = 0; c < curves.count(); ++c)
        for (std::int64_t at = curves.first[c]; at < curves.first[c] + curves.pieces_of(c); ++at) {
            const CurvePoint& a = curves.point[at];
            const CurvePoint& b = curves.point[curves.next(c, at)];
            if (!changes_between(a, b, view)) continue;
            for (const double u : inner_shares) {
                places.push_back({a, b, u});
                added.push_back({at, u, {}});
            }
        }
    bring_onto(runtime, contour, places, evaluations, progress);
    for (std::int64_t i = 0; i < added.size(); ++i) added[i].point = places[i].found;
    Curves result = no_curves(runtime.memory);
    std::int64_t next = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c) append_with(curves, c, added, next, result);
    return result;
}

// ---- The border

// Whether the surface is there, for each point. Far from the border a curve is where it was when it last came near it.
base::Array<std::uint8_t> find_held(const base::Runtime& runtime, const implicit::Domain& domain,
                                    const Curves& curves) {
    constexpr std::uint8_t unknown = 2;
    base::Array<std::uint8_t> holds(runtime.memory, curves.point.size());
    runtime.parallel.for_chunks(holds.size(), 256, [&](std::int64_t first, std::int64_t last) {
        for (std::int64_t i = first; i < last; ++i) {
            const CurvePoint& p = curves.point[i];
            holds[i] = !domain.near_end(p.position) ? unknown : domain.beyond(p.position, p.gradient) <= 0.0 ? 1 : 0;
        }
    });
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        const std::int64_t first = curves.first[c];
        const std::int64_t count = curves.size_of(c);
        std::int64_t begin = 0;
        while (begin < count && holds[first + begin] == unknown) ++begin;
        // A curve that is nowhere near the border is there as a whole.
        std::uint8_t last = begin < count ? holds[first + begin] : 1;
        for (std::int64_t k = 0; k < count; ++k) {
            std::uint8_t& held = holds[first + (begin + k) % count];
            if (curves.closed[c] == 0 && begin + k == count) last = holds[first + begin];
            held = last = held == unknown ? last : held;
        }
    }
    return holds;
}

// Calls add(a, b) for the points at both ends of each piece.
template <class Add>
void for_pieces(const Curves& curves, Add&& add) {
    for (std::int64_t c = 0; c < curves.count(); ++c)
        for (std::int64_t at = curves.first[c]; at < curves.first[c] + curves.pieces_of(c); ++at)
            add(at, curves.next(c, at));
}

} // namespace

Curves with_cusps(const base::Runtime& runtime, const Level& contour, const View& view, const Curves& given,
                  std::int64_t& evaluations, const base::Progress& progress) {
    const Curves curves = refined_at_cusps(runtime, contour, view, given, evaluations, progress);
    base::Array<Bracket> brackets(runtime.memory);
    for_pieces(curves, [&](std::int64_t at, std::int64_t next) {
        const CurvePoint& a = curves.point[at];
        const CurvePoint& b = curves.point[next];
        Bracket bracket{at, next, radial(a, view), radial(b, view)};
        if ((bracket.at_low < 0.0) == (bracket.at_high < 0.0)) return;
        bracket.begin();
        brackets.push_back(bracket);
    });
    const base::Array<CurvePoint> cusps = find_zeros(
        runtime, contour, curves, brackets, [&](const CurvePoint& p) { return radial(p, view); }, evaluations,
        progress);
    Curves result = no_curves(runtime.memory);
    const auto add = [&](const CurvePoint& p, bool cusp) {
        result.point.push_back(p);
        result.cusp.push_back(cusp ? 1 : 0);
    };
    std::int64_t s = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        bool replaced = false; // whether a cusp just before the next point stands for it
        for (std::int64_t at = curves.first[c]; at < curves.first[c + 1]; ++at) {
            const bool changes = s < brackets.size() && brackets[s].piece == at;
            const double share = changes ? brackets[s].share : 0.5;
            if (!replaced && !(changes && share < curve_tuning.at_end)) add(curves.point[at], false);
            replaced = changes && share > 1.0 - curve_tuning.at_end && brackets[s].next > at;
            if (changes) add(cusps[s++], true);
        }
        result.end_curve(curves.closed[c] != 0);
    }
    HRBFNPR_ASSERT(result.cusp.size() == result.point.size());
    return result;
}

Curves finer_curves(const base::Runtime& runtime, const Level& contour, const View& view, const Curves& curves,
                    std::span<const std::uint8_t> marked, double tolerance, std::int64_t& evaluations,
                    const base::Progress& progress) {
    HRBFNPR_ASSERT(static_cast<std::int64_t>(marked.size()) == curves.point.size());
    const auto seen = [&](const glm::dvec3& p) {
        const glm::dvec4 q = view.to_window * glm::dvec4(p, 1.0);
        return glm::dvec2(q) / q.w;
    };
    // The part of a piece between two shares of it, and its middle.
    struct Part {
        std::int64_t piece;
        double low, high;
    };
    base::Array<std::uint8_t> changes(runtime.memory, curves.count());
    base::Array<Part> parts(runtime.memory);
    base::Array<OnPiece> middles(runtime.memory); // the middle of each part
    for (std::int64_t c = 0; c < curves.count(); ++c)
        for (std::int64_t at = curves.first[c]; at < curves.first[c] + curves.pieces_of(c); ++at) {
            if (marked[static_cast<std::size_t>(at)] == 0) continue;
            changes[c] = 1;
            parts.push_back({at, 0.0, 1.0});
            middles.push_back({curves.point[at], curves.point[curves.next(c, at)], 0.5});
        }
    base::Array<AddedPoint> added(runtime.memory);
    const std::int64_t limit = curve_tuning.most_added * parts.size();
    for (int depth = 0; depth < curve_tuning.deepest_piece && !parts.empty() && added.size() < limit; ++depth) {
        bring_onto(runtime, contour, middles, evaluations, progress);
        base::Array<Part> next(runtime.memory);
        base::Array<OnPiece> next_middles(runtime.memory);
        for (std::int64_t i = 0; i < parts.size(); ++i) {
            const auto [piece, low, high] = parts[i];
            const auto& [a, b, half, middle, astray] = middles[i];
            if (astray) continue;
            const double share = 0.5 * (low + high);
            added.push_back({piece, share, middle});
            const CubicPiece cubic(a, b);
            const double off = glm::distance(seen(middle.position), seen(cubic.at(half)));
            if (!(off > tolerance)) continue;
            next.push_back({piece, low, share});
            next.push_back({piece, share, high});
            next_middles.push_back({a, middle, 0.5});
            next_middles.push_back({middle, b, 0.5});
        }
        std::swap(parts, next);
        std::swap(middles, next_middles);
    }
    std::sort(added.begin(), added.end(), [](const AddedPoint& a, const AddedPoint& b) {
        return a.piece != b.piece ? a.piece < b.piece : a.share < b.share;
    });
    Curves changed = no_curves(runtime.memory);
    std::int64_t next = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c)
        if (changes[c] != 0) append_with(curves, c, added, next, changed);
    const Curves with = with_cusps(runtime, contour, view, changed, evaluations, progress);
    Curves result = no_curves(runtime.memory);
    std::int64_t number = 0; // the place of the next changed curve in `with`
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        const Curves& from = changes[c] != 0 ? with : curves;
        const std::int64_t curve = changes[c] != 0 ? number++ : c;
        for (std::int64_t at = from.first[curve]; at < from.first[curve + 1]; ++at) {
            result.point.push_back(from.point[at]);
            result.cusp.push_back(from.cusp.empty() ? std::uint8_t{0} : from.cusp[at]);
        }
        result.end_curve(from.closed[curve] != 0);
    }
    return result;
}

Curves clip(const base::Runtime& runtime, const Level& level, const implicit::Domain& domain, const Curves& curves,
            const base::Progress& progress) {
    const base::Array<std::uint8_t> holds = find_held(runtime, domain, curves);
    const auto beyond = [&](const CurvePoint& p) { return domain.beyond(p.position, p.gradient); };
    base::Array<Bracket> brackets(runtime.memory);
    for_pieces(curves, [&](std::int64_t at, std::int64_t next) {
        if (holds[at] == holds[next]) return;
        brackets.push_back({at, next, holds[at] != 0 ? -1.0 : 1.0, holds[next] != 0 ? -1.0 : 1.0});
    });
    std::int64_t evaluations = 0;
    const base::Array<CurvePoint> ends = find_zeros(runtime, level, curves, brackets, beyond, evaluations, progress);
    Curves result = no_curves(runtime.memory);
    const auto finish = [&](bool closed) {
        const std::int64_t first = result.first.back();
        if (result.point.size() - first < 2)
            result.point.resize(first);
        else
            result.end_curve(closed);
    };
    // A point of the curve, or an end on the border, where the surface is.
    struct Held {
        CurvePoint point;
        bool holds;
    };
    base::Array<Held> points(runtime.memory);
    std::int64_t next = 0; // the next bracket
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        points.clear();
        for (std::int64_t at = curves.first[c]; at < curves.first[c + 1]; ++at) {
            points.push_back({curves.point[at], holds[at] != 0});
            if (next == brackets.size() || brackets[next].piece != at) continue;
            const double from_held = holds[at] != 0 ? brackets[next].share : 1.0 - brackets[next].share;
            if (from_held > curve_tuning.at_point) points.push_back({ends[next], true});
            ++next;
        }
        // A closed curve that is cut is walked from a point where there is no surface.
        const Held* const lost = std::find_if(points.begin(), points.end(), [](const Held& p) { return !p.holds; });
        const bool closed = curves.closed[c] != 0;
        if (closed && lost != points.end())
            std::rotate(points.begin(), points.begin() + (lost - points.begin()), points.end());
        for (const Held& p : points) {
            if (p.holds)
                result.point.push_back(p.point);
            else
                finish(false);
        }
        finish(closed && lost == points.end());
    }
    return result;
}

} // namespace hrbfnpr::curves
