// SPDX-License-Identifier: MIT
// All changes are found in the same way. If a function has different signs at the two ends of a piece, the Illinois
// method finds its zero. It evaluates the function at points of the piece's cubic, after moving them onto the curve.
#include "curves/curve_changes.h"

#include "curves/curves.h"
#include "curves/tuning.h"
#include "implicit/evaluate_all.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// A zero of a function on a piece of a curve.
struct Change {
    std::int64_t piece, next; // the points of the curve before and after the zero
    Illinois root;
    // parameter of the place that was evaluated last, from 0 to 1 along the piece; in the end, that of the zero
    double share = 0.5;
};

// A place on the cubic between two points of a curve. It is to be moved onto the curve.
struct CubicPlace {
    CurvePoint a, b;
    double share;
    CurvePoint found = {};
    bool left_curve = false; // True if the place moved to another curve. `found` is then the place on the cubic.
};

// Moves places onto their curves by one or two Newton steps. Adds to `evaluations`.
void bring_to_curves(const base::Work& work, const Level& level, base::Array<CubicPlace>& places,
                     std::int64_t& evaluations) {
    base::Array<CurvePoint> points(work.memory, places.size());
    base::Array<double> enough(work.memory, places.size());
    geometry::VecArray begin(work.memory, places.size());
    for (std::int64_t i = 0; i < places.size(); ++i) {
        const CubicPiece cubic(places[i].a, places[i].b);
        begin.set(i, points[i].position = cubic.at(places[i].share));
        enough[i] = curve_tuning.near_curve * cubic.length();
    }
    bring_closer(work, level, enough, points, evaluations);
    for (std::int64_t i = 0; i < places.size(); ++i) {
        CubicPlace& place = places[i];
        const double most = curve_tuning.astray * glm::distance(place.a.position, place.b.position);
        place.left_curve = !(glm::distance(points[i].position, begin[i]) <= most);
        place.found = points[i];
        if (place.left_curve) place.found.position = begin[i];
    }
}

// Finds all zeros in parallel, and returns their points. value(place) evaluates the function at a point of the curve.
template <class Value>
base::Array<CurvePoint> find_zeros(const base::Work& work, const Level& level, const Curves& curves,
                                   base::Array<Change>& changes, Value&& value, std::int64_t& evaluations) {
    base::Array<CurvePoint> found(work.memory, changes.size());
    // For each search, the piece between its two ends, which are on the curve.
    base::Array<CubicPlace> ends(work.memory);
    base::Array<std::int64_t> active(work.memory);
    for (std::int64_t i = 0; i < changes.size(); ++i) {
        ends.push_back({curves.point[changes[i].piece], curves.point[changes[i].next], 0.0});
        active.push_back(i);
    }
    base::Array<CubicPlace> places(work.memory);
    while (!active.empty()) {
        places.clear();
        for (const std::int64_t i : active) {
            const Illinois& root = changes[i].root;
            places.push_back({ends[i].a, ends[i].b, (root.trial - root.low) / (root.high - root.low)});
        }
        bring_to_curves(work, level, places, evaluations);
        std::int64_t left = 0;
        for (std::int64_t k = 0; k < places.size(); ++k) {
            const std::int64_t i = active[k];
            Illinois& root = changes[i].root;
            found[i] = places[k].found;
            const double low = root.low;
            const double share = changes[i].share = root.trial;
            root.take(value(found[i]));
            (root.low != low ? ends[i].a : ends[i].b) = found[i];
            if (!root.done(curve_tuning.exact) && std::abs(root.trial - share) > curve_tuning.exact &&
                root.steps < curve_tuning.most_steps)
                active[left++] = i;
        }
        active.resize(left);
    }
    return found;
}

// ---- Cusps

// Returns v^T H v = v . grad g on the contour. It is the radial curvature times a positive factor.
double radial(const CurvePoint& p, const View& view) noexcept {
    return glm::dot(p.level_gradient, view.sight(p.position));
}

// A piece may contain two cusps between its points, so doubtful pieces get additional points at these parameters.
constexpr std::array<double, 3> inner_shares = {0.25, 0.5, 0.75};

// Returns whether the radial curvature may change its sign between two points.
bool changes_between(const CurvePoint& a, const CurvePoint& b, const View& view) noexcept {
    // Returns the sine of the angle between the curve and the line of sight, with the sign of the radial curvature.
    const auto sine = [&](const CurvePoint& p) {
        const glm::dvec3 sight = view.sight(p.position);
        return radial(p, view) * glm::length(p.gradient) / (glm::length(sight) * glm::length(p.direction()));
    };
    const double begin = sine(a);
    const double end = sine(b);
    if (std::min(begin, end) > curve_tuning.clear_of_cusps || std::max(begin, end) < -curve_tuning.clear_of_cusps)
        return false;
    // Along the cubic, the sign of the radial curvature follows from interpolated normals. With t = n x grad g, it is
    // the sign of t . (n x v) = v . grad g, up to the length of t.
    const CubicPiece cubic(a, b);
    const auto turned = [&](double u) {
        const glm::dvec3 normal = (1.0 - u) * glm::normalize(a.gradient) + u * glm::normalize(b.gradient);
        const glm::dvec3 along = cubic.derivative(u);
        return (glm::dot(along, glm::cross(normal, view.sight(cubic.at(u)))) < 0.0) != (begin < 0.0);
    };
    return (end < 0.0) != (begin < 0.0) || std::any_of(inner_shares.begin(), inner_shares.end(), turned);
}

Curves refined_at_cusps(const base::Work& work, const Level& contour, const View& view, const Curves& curves,
                        std::int64_t& evaluations) {
    base::Array<CubicPlace> places(work.memory);
    base::Array<std::int64_t> piece(work.memory); // for each place: the first point of its piece
    for_pieces(curves, [&](std::int64_t at, std::int64_t next) {
        if (!changes_between(curves.point[at], curves.point[next], view)) return;
        for (const double u : inner_shares) {
            places.push_back({curves.point[at], curves.point[next], u});
            piece.push_back(at);
        }
    });
    bring_to_curves(work, contour, places, evaluations);
    Curves result(work.memory);
    std::int64_t k = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        for (std::int64_t at = curves.first[c]; at < curves.first[c + 1]; ++at) {
            result.point.push_back(curves.point[at]);
            for (; k < piece.size() && piece[k] == at; ++k) result.point.push_back(places[k].found);
        }
        result.end(curves.closed[c] != 0);
    }
    return result;
}

// ---- The border

// Returns for each point whether the surface exists there. Points far from the border have the same state as the last
// point near it.
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
        // A curve far from the border is entirely on the surface.
        std::uint8_t last = begin < count ? holds[first + begin] : 1;
        for (std::int64_t k = 0; k < count; ++k) {
            std::uint8_t& held = holds[first + (begin + k) % count];
            if (curves.closed[c] == 0 && begin + k == count && k > 0) last = holds[first + begin];
            held = last = held == unknown ? last : held;
        }
    }
    return holds;
}

// Returns the parts of curves at whose points `holds` equals `wanted`. They end at the changes, whose places are
// `ends`.
Curves held_parts(const Curves& curves, const base::Array<std::uint8_t>& holds, const base::Array<Change>& changes,
                  const base::Array<CurvePoint>& ends, bool wanted) {
    base::Memory& memory = holds.memory();
    HRBFNPR_ASSERT(ends.size() == changes.size());
    Curves result(memory);
    // The points of a curve and its ends, and for each point whether it is in a part.
    base::Array<CurvePoint> points(memory);
    base::Array<std::uint8_t> held(memory);
    std::int64_t next = 0; // the index of the next change
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        points.clear();
        held.clear();
        const auto add = [&](const CurvePoint& p, bool holds_it) {
            points.push_back(p);
            held.push_back(holds_it ? 1 : 0);
        };
        for (std::int64_t at = curves.first[c]; at < curves.first[c + 1]; ++at) {
            const bool is_held = (holds[at] != 0) == wanted;
            add(curves.point[at], is_held);
            if (next == changes.size() || changes[next].piece != at) continue;
            const double from_held = is_held ? changes[next].share : 1.0 - changes[next].share;
            if (from_held > curve_tuning.at_point) add(ends[next], true);
            ++next;
        }
        for_parts(
            points.size(), curves.closed[c] != 0, [&](std::int64_t i) { return held[i] != 0; },
            [&](std::int64_t begin, std::int64_t end, bool whole) {
                if (end - begin < 2) return;
                for (std::int64_t i = begin; i < end; ++i) result.point.push_back(points[i % points.size()]);
                result.end(whole);
            });
    }
    return result;
}

} // namespace

Curves with_cusps(const base::Work& work, const Level& contour, const View& view, const Curves& given,
                  std::int64_t& evaluations) {
    const Curves curves = refined_at_cusps(work, contour, view, given, evaluations);
    base::Array<Change> changes(work.memory);
    for_pieces(curves, [&](std::int64_t at, std::int64_t next) {
        const double from = radial(curves.point[at], view);
        const double to = radial(curves.point[next], view);
        if ((from < 0.0) != (to < 0.0)) changes.push_back({at, next, Illinois(from, to, curve_tuning.trusted_steps)});
    });
    const base::Array<CurvePoint> cusps = find_zeros(
        work, contour, curves, changes, [&](const CurvePoint& p) { return radial(p, view); }, evaluations);
    Curves result(work.memory);
    const auto add = [&](const CurvePoint& p, bool cusp) {
        result.point.push_back(p);
        result.point.back().is_cusp = cusp ? 1 : 0;
    };
    std::int64_t s = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        bool replaced = false; // True if a cusp just before the next point replaces that point.
        for (std::int64_t at = curves.first[c]; at < curves.first[c + 1]; ++at) {
            // True if the next change is a cusp of this curve on the piece that begins at this point.
            const bool is_before = s < changes.size() && changes[s].piece == at;
            const double share = is_before ? changes[s].share : 0.5;
            if (!replaced && !(is_before && share < curve_tuning.at_end)) add(curves.point[at], false);
            replaced = is_before && share > 1.0 - curve_tuning.at_end && changes[s].next > at;
            if (is_before) add(cusps[s++], true);
        }
        result.end(curves.closed[c] != 0);
    }
    return result;
}

Curves finer_curves(const base::Work& work, const Level& contour, const View& view, const Curves& curves,
                    std::span<const std::uint8_t> marked, double tolerance, std::int64_t& evaluations) {
    HRBFNPR_ASSERT(static_cast<std::int64_t>(marked.size()) == curves.point.size());
    struct FinePoint {
        CurvePoint point;
        bool halved; // true if the piece that begins at this point must be halved
    };
    Chains<FinePoint> fine(work.memory); // the curves that have a marked piece
    base::Array<std::uint8_t> changes(work.memory, curves.count());
    std::int64_t marks = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        const auto own =
            marked.subspan(static_cast<std::size_t>(curves.first[c]), static_cast<std::size_t>(curves.pieces_of(c)));
        const std::int64_t count = std::count_if(own.begin(), own.end(), [](std::uint8_t m) { return m != 0; });
        if (count == 0) continue;
        marks += count;
        changes[c] = 1;
        for (std::int64_t at = curves.first[c]; at < curves.first[c + 1]; ++at)
            fine.point.push_back({curves.point[at], marked[static_cast<std::size_t>(at)] != 0});
        fine.end(curves.closed[c] != 0);
    }
    const auto wanted = [&](std::int64_t, std::int64_t i, std::int64_t, FinePoint&) { return fine.point[i].halved; };
    const auto bring = [&](base::Array<FinePoint>& added, const base::Array<std::int64_t>& of,
                           const base::Array<std::int64_t>& after) {
        base::Array<CubicPlace> middles(work.memory);
        for (std::int64_t k = 0; k < added.size(); ++k)
            middles.push_back({fine.point[after[k]].point, fine.point[fine.next(of[k], after[k])].point, 0.5});
        bring_to_curves(work, contour, middles, evaluations);
        base::Array<std::uint8_t> found(work.memory, added.size());
        for (std::int64_t k = 0; k < added.size(); ++k) {
            const CubicPlace& middle = middles[k];
            const glm::dvec2 guess = view.see(CubicPiece(middle.a, middle.b).at(0.5)).place;
            const bool off = glm::distance(view.see(middle.found.position).place, guess) > tolerance;
            added[k] = {middle.found, off};
            fine.point[after[k]].halved = off && !middle.left_curve;
            found[k] = middle.left_curve ? 0 : 1;
        }
        return found;
    };
    const std::int64_t most = fine.point.size() + curve_tuning.most_added * marks;
    for (int depth = 0; depth < curve_tuning.deepest_piece && fine.point.size() < most; ++depth)
        if (!halve_pieces(fine, wanted, bring)) break;
    Curves changed(work.memory);
    for (const FinePoint& p : fine.point) changed.point.push_back(p.point);
    changed.first = std::move(fine.first);
    changed.closed = std::move(fine.closed);
    const Curves with = with_cusps(work, contour, view, changed, evaluations);
    Curves result(work.memory);
    std::int64_t number = 0; // the index in `with` of the next changed curve
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        const Curves& from = changes[c] != 0 ? with : curves;
        const std::int64_t curve = changes[c] != 0 ? number++ : c;
        for (std::int64_t at = from.first[curve]; at < from.first[curve + 1]; ++at)
            result.point.push_back(from.point[at]);
        result.end(from.closed[curve] != 0);
    }
    return result;
}

Curves clip(const base::Work& work, const Level& level, const implicit::Domain& domain, const Curves& curves) {
    const base::Array<std::uint8_t> holds = find_held(work, domain, curves);
    const auto beyond = [&](const CurvePoint& p) { return domain.beyond(p.position, p.gradient); };
    base::Array<Change> changes(work.memory);
    for_pieces(curves, [&](std::int64_t at, std::int64_t next) {
        if (holds[at] == holds[next]) return;
        const double from = holds[at] != 0 ? -1.0 : 1.0;
        changes.push_back({at, next, Illinois(from, -from, curve_tuning.trusted_steps)});
    });
    std::int64_t evaluations = 0;
    const base::Array<CurvePoint> ends = find_zeros(work, level, curves, changes, beyond, evaluations);
    return held_parts(curves, holds, changes, ends, true);
}

FacingParts facing_parts(const base::Work& work, const Level& level, const View& view, bool by_level,
                         const Curves& curves) {
    const auto facing = [&](const CurvePoint& p) {
        return glm::dot(by_level ? p.level_gradient : p.gradient, view.sight(p.position));
    };
    base::Array<std::uint8_t> outside(work.memory);
    for (const CurvePoint& p : curves.point) outside.push_back(facing(p) < 0.0 ? 1 : 0);
    base::Array<Change> changes(work.memory);
    for_pieces(curves, [&](std::int64_t at, std::int64_t next) {
        if (outside[at] == outside[next]) return;
        changes.push_back(
            {at, next, Illinois(facing(curves.point[at]), facing(curves.point[next]), curve_tuning.trusted_steps)});
    });
    std::int64_t evaluations = 0;
    const base::Array<CurvePoint> turns = find_zeros(work, level, curves, changes, facing, evaluations);
    return {held_parts(curves, outside, changes, turns, true), held_parts(curves, outside, changes, turns, false)};
}

} // namespace hrbfnpr::curves
