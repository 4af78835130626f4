// SPDX-License-Identifier: MIT
// Counting has four steps, each for all segments at once:
//
//   line_of         computes the part of a segment in the mesh's region, as a line from the segment's end `to`
//   find_spans      finds spans of a line that may contain the surface, and its crossings with triangles there
//   count_roots     counts the roots of f in each span, from f and its slope along the line
//   drop_roots      removes roots beyond the surface's end
#include "curves/sheet_count.h"

#include "base/list.h"
#include "curves/curves.h"
#include "curves/tuning.h"
#include "geometry/tangent_frame.h"
#include "implicit/evaluate_all.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t segments_a_task = 16;

// ---- Lines

// The part of a segment inside the region of the mesh: origin + s direction, for low <= s <= high. The origin is the
// segment's end `to`, so places near this end are exact, however far away the other end is.
struct Line {
    geometry::Bounds region;
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0};      // unit vector
    glm::dvec3 right{0.0}, up{0.0}; // unit vectors, perpendicular to the direction and to each other
    double low = 0.0, high = -1.0;
    // True if the line ends where the segment ends, false if it ends at the boundary of the region.
    bool low_is_end = false, high_is_end = false;

    // Returns the projection along the line of a point relative to the origin.
    [[nodiscard]] glm::dvec2 seen(const glm::dvec3& p) const noexcept { return {glm::dot(p, right), glm::dot(p, up)}; }
    [[nodiscard]] glm::dvec3 at(double s) const noexcept {
        // Clamping corrects rounding, which may lead out of the region.
        return glm::clamp(origin + s * direction, region.min, region.max);
    }
};

Line line_of(const geometry::Bounds& region, const glm::dvec3& from, const glm::dvec3& to, double clear) noexcept {
    Line line;
    line.region = region;
    line.origin = to;
    const double length = glm::distance(from, to);
    if (!(length > 0.0) || !std::isfinite(length)) return line;
    line.direction = (from - to) / length;
    const geometry::TangentFrame frame = geometry::combing_frame(line.direction);
    line.right = frame.u;
    line.up = frame.r;
    line.low = clear;
    line.high = length;
    for (int axis = 0; axis < 3; ++axis) {
        const double first = region.min[axis] - to[axis];
        const double last = region.max[axis] - to[axis];
        if (line.direction[axis] == 0.0) {
            if (!(first <= 0.0 && last >= 0.0)) line.high = -1.0;
            continue;
        }
        const double a = first / line.direction[axis];
        const double b = last / line.direction[axis];
        line.low = std::max(line.low, std::min(a, b));
        line.high = std::min(line.high, std::max(a, b));
    }
    line.low_is_end = line.low == clear;
    line.high_is_end = line.high == length;
    return line;
}

// ---- Spans

// A part of a line in which f is evaluated.
struct Span {
    double begin, end;
    std::int64_t line;
    std::int64_t places;    // the number of places at which f is evaluated first; they are in order from begin to end
    std::int32_t crossings; // the number of times that the line crosses triangles in the span
    bool line_begins, line_ends;
};

struct Spans {
    explicit Spans(base::Memory& memory) noexcept : span(memory), place(memory) {}

    base::Array<Span> span;
    base::Array<double> place; // the places of all spans
};

// A part of a line, close to a triangle.
struct Range {
    double low, high;

    // Reduces the range to the part in which at_zero + slope s <= 0.
    void keep(double at_zero, double slope) noexcept {
        if (slope == 0.0) {
            if (at_zero > 0.0) high = low - 1.0;
        } else if (slope > 0.0) {
            high = std::min(high, -at_zero / slope);
        } else {
            low = std::max(low, -at_zero / slope);
        }
    }
};

struct TriangleCrossing {
    double at;
    bool rising; // true if f increases along the line at the crossing
};

// Returns a bound for the distance of the surface from a triangle. An arc that meets its chord of length h at an angle
// a is at most h a / 4 away from it. The bound is twice that, for arcs that are not circles.
double bulge_of(const SurfaceMesh& mesh, std::int64_t triangle) noexcept {
    const std::array<glm::dvec3, 3> p = corners_of(mesh, triangle);
    const double longest = std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    double sine = 0.0;
    for (std::int64_t k = 0; k < 3; ++k) {
        const glm::dvec3 gradient = mesh.gradient[mesh.corner[3 * triangle + k]];
        const double scale = glm::length(gradient) * glm::length(area);
        const bool faces = glm::dot(gradient, area) > 0.0;
        sine = std::max(sine, faces ? glm::length(glm::cross(gradient, area)) / scale : 1.0);
    }
    return curve_tuning.least_bulge * mesh.side + 0.5 * longest * std::min(sine, 1.0);
}

// Finds the range of a line inside a prism that contains the triangle and all places within its bulge, and the place
// where the line crosses the triangle.
void add_triangle_range(const std::array<glm::dvec3, 3>& corner, double bulge, const Line& line,
                        base::Array<Range>& ranges, base::Array<TriangleCrossing>& crossings) {
    const std::array<glm::dvec3, 3> p{corner[0] - line.origin, corner[1] - line.origin, corner[2] - line.origin};
    Range range{line.low, line.high};
    // Keeps the part in which out . (x - origin) <= most + bulge.
    const auto keep = [&](const glm::dvec3& out, double most) {
        range.keep(-most - bulge, glm::dot(out, line.direction));
    };
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 out(0.0);
        out[axis] = 1.0;
        keep(out, std::max({p[0][axis], p[1][axis], p[2][axis]}));
        keep(-out, -std::min({p[0][axis], p[1][axis], p[2][axis]}));
    }
    if (!(range.low <= range.high)) return;
    const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    if (const double twice = glm::length(area); twice > 0.0) {
        const glm::dvec3 normal = area / twice;
        keep(normal, glm::dot(normal, p[0]));
        keep(-normal, -glm::dot(normal, p[0]));
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 out = glm::normalize(glm::cross(p[(k + 1) % 3] - p[k], normal));
            keep(out, glm::dot(out, p[k]));
        }
    }
    if (!(range.low <= range.high)) return;
    ranges.push_back(range);
    // Three signs tell on which side of the triangle's edges the line passes. All triangles at a corner project it to
    // the same place, and the two triangles at an edge compute exactly opposite numbers. So no line can pass between
    // triangles.
    const std::array<glm::dvec2, 3> q{line.seen(p[0]), line.seen(p[1]), line.seen(p[2])};
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    const glm::dvec3 side(cross(q[1], q[2]), cross(q[2], q[0]), cross(q[0], q[1]));
    const double sum = side.x + side.y + side.z;
    const bool rising = glm::all(glm::greaterThanEqual(side, glm::dvec3(0.0)));
    const bool falling = glm::all(glm::lessThanEqual(side, glm::dvec3(0.0)));
    if (rising == falling || sum == 0.0) return;
    const double at = glm::dot(line.direction, (side.x * p[0] + side.y * p[1] + side.z * p[2]) / sum);
    if (at >= line.low && at <= line.high) crossings.push_back({at, rising});
}

// Sorts ranges, and merges ranges that overlap or nearly touch.
void merge_ranges(double gap, base::Array<Range>& ranges) noexcept {
    std::sort(ranges.begin(), ranges.end(),
              [](const Range& a, const Range& b) { return a.low < b.low || (a.low == b.low && a.high < b.high); });
    std::int64_t kept = 0;
    for (const Range& range : ranges) {
        if (kept > 0 && range.low <= ranges[kept - 1].high + gap)
            ranges[kept - 1].high = std::max(ranges[kept - 1].high, range.high);
        else
            ranges[kept++] = range;
    }
    ranges.resize(kept);
}

// Sorts crossings. A crossing through an edge or corner is found once for each triangle there, and only one of these is
// kept.
void merge_crossings(double same, base::Array<TriangleCrossing>& crossings) noexcept {
    std::sort(crossings.begin(), crossings.end(), [](const TriangleCrossing& a, const TriangleCrossing& b) {
        return a.at < b.at || (a.at == b.at && a.rising < b.rising);
    });
    std::int64_t kept = 0;
    for (const TriangleCrossing& crossing : crossings) {
        bool known = false;
        for (std::int64_t i = kept; i-- > 0 && crossing.at - crossings[i].at <= same;)
            known = known || crossings[i].rising == crossing.rising;
        if (!known) crossings[kept++] = crossing;
    }
    crossings.resize(kept);
}

// Adds the spans of the line with the index `number`. Between any two crossings there is a place where f is evaluated.
// So each crossing lies in a piece of its own.
void find_spans(const SurfaceMesh& mesh, const geometry::BoxTree& tree, const base::Array<double>& bulge,
                const Line& line, std::int64_t number, Spans& found) {
    if (!(line.low < line.high)) return;
    HRBFNPR_ASSERT(std::abs(glm::length(line.direction) - 1.0) < 1e-9);
    base::Array<Range> ranges(bulge.memory());
    base::Array<TriangleCrossing> crossings(bulge.memory());
    glm::dvec3 inverse(0.0);
    for (int axis = 0; axis < 3; ++axis)
        inverse[axis] = line.direction[axis] != 0.0 ? 1.0 / line.direction[axis] : 1e300;
    const auto meets = [&](const geometry::Bounds& box) {
        const glm::dvec3 a = (box.min - line.origin) * inverse;
        const glm::dvec3 b = (box.max - line.origin) * inverse;
        const glm::dvec3 low = glm::min(a, b);
        const glm::dvec3 high = glm::max(a, b);
        return std::max({low.x, low.y, low.z, line.low}) <= std::min({high.x, high.y, high.z, line.high});
    };
    tree.visit(meets,
               [&](std::int64_t t) { add_triangle_range(corners_of(mesh, t), bulge[t], line, ranges, crossings); });
    merge_ranges(curve_tuning.span_gap * mesh.side, ranges);
    merge_crossings(curve_tuning.exact * mesh.side, crossings);
    for (const Range& range : ranges) {
        if (!(range.low < range.high)) continue;
        const std::int64_t first = found.place.size();
        const double parts = std::ceil((range.high - range.low) / (curve_tuning.place_spacing * mesh.side));
        for (double k = 0.0; k < parts; ++k) found.place.push_back(range.low + (k / parts) * (range.high - range.low));
        found.place.push_back(range.high);
        std::int32_t count = 0;
        double before = 0.0;
        for (const TriangleCrossing& crossing : crossings) {
            if (crossing.at < range.low || crossing.at > range.high) continue;
            if (count++ > 0 && crossing.at - before > curve_tuning.close * mesh.side)
                found.place.push_back(0.5 * (before + crossing.at));
            before = crossing.at;
        }
        std::sort(found.place.data() + first, found.place.end());
        found.span.push_back({range.low, range.high, number, found.place.size() - first, count,
                              line.low_is_end && range.low == line.low, line.high_is_end && range.high == line.high});
    }
}

// ---- Roots

struct RootCount {
    std::int32_t roots = 0;
    bool certain = true; // False if f touches 0, or if it is NaN or infinite somewhere.
};

// A range of a line, within one span, that contains exactly one root of f.
struct Root {
    std::int64_t span;
    double low, high;
    double at; // the approximate position of the root
    Illinois search;
};

// A place on a line: f, the slope of f along the line, and |grad f|.
struct Place {
    double at, value, slope, gradient;

    [[nodiscard]] bool finite() const noexcept {
        return std::isfinite(value) && std::isfinite(slope) && std::isfinite(gradient);
    }
    [[nodiscard]] bool negative() const noexcept { return value < 0.0; }
};

// A part of a span between two places. It will be split at `at`.
struct Piece {
    Place low, high;
    std::int64_t span;
    int depth;
    double at;
};

// f and its gradient at a batch of places.
struct Field {
    Field(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& point)
        : value(work.memory, point.size()), gradient(work.memory, point.size()) {
        implicit::evaluate_all(work.without_progress(), implicit, point,
                               {value.data(), {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}});
    }
    [[nodiscard]] Place place(std::int64_t i, const Line& line, double at) const noexcept {
        return {at, value[i], glm::dot(gradient[i], line.direction), glm::length(gradient[i])};
    }

    base::Array<double> value;
    geometry::VecArray gradient;
};

// Examines the values and slopes at the ends of a piece. Returns NaN if the piece has no root, -1 if it has one root,
// else the place where it must be split.
double split_of(const Place& a, const Place& b) noexcept {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const double length = b.at - a.at;
    if (a.negative() != b.negative()) {
        // The cubic with these values and slopes is monotone, so there is one root. [Fritsch & Carlson 1980]
        const double rise = b.value - a.value;
        const double first = length * a.slope / rise;
        const double last = length * b.slope / rise;
        return first >= 0.0 && first <= 3.0 && last >= 0.0 && last <= 3.0 ? -1.0 : 0.5;
    }
    const double sign = a.negative() ? -1.0 : 1.0;
    const double d0 = sign * length * a.slope;
    const double d1 = sign * length * b.slope;
    // The cubic is never below its least control value, so it has no root.
    if (sign * a.value + d0 / 3.0 > 0.0 && sign * b.value - d1 / 3.0 > 0.0) return none;
    // Otherwise the piece is split at the minimum of the cubic, unless this is clearly above 0.
    const double f0 = sign * a.value;
    const double f1 = sign * b.value;
    const double third = 2.0 * (f0 - f1) + d0 + d1;
    const double second = 3.0 * (f1 - f0) - 2.0 * d0 - d1;
    // A quarter of the discriminant of the cubic's derivative d0 + 2 second t + 3 third t^2.
    const double root = second * second - 3.0 * third * d0;
    if (!(root >= 0.0)) return none;
    // The derivative increases at this root t, so the cubic has its minimum there. Two formulas give the same root; the
    // one without cancellation is used.
    const double t = second > 0.0 ? -d0 / (second + std::sqrt(root)) : (std::sqrt(root) - second) / (3.0 * third);
    if (!(t > 0.0 && t < 1.0) || f0 + t * (d0 + t * (second + t * third)) > 0.5 * std::min(f0, f1)) return none;
    return std::clamp(t, 0.05, 0.95);
}

// Counts the roots in each span, and lists the brackets of single roots. Pieces are split, all in parallel, until the
// values and slopes at their ends decide the number of roots.
void count_roots(const base::Work& work, const implicit::Implicit& implicit, const base::Array<Line>& lines,
                 const Spans& spans, base::Array<RootCount>& counts, base::Array<Root>& roots) {
    const double noise = curve_tuning.root_noise * implicit.diagonal();
    counts.resize(spans.span.size());
    std::fill(counts.begin(), counts.end(), RootCount{});
    base::Array<Piece> pieces(work.memory); // the pieces to split next
    geometry::VecArray point(work.memory);  // the places to split them at
    const auto touches = [&](const Place& at) {
        return std::abs(at.value) <= curve_tuning.touching * implicit.diagonal() * at.gradient &&
               std::abs(at.slope) <= curve_tuning.along_surface * at.gradient;
    };
    // If the segment ends on the surface, f is 0 there, and the slope of f gives its sign just inside the segment.
    const auto settle_end = [&](RootCount& count, Place& end, double way) {
        if (!(std::abs(end.value) <= noise * end.gradient)) return;
        if (!(std::abs(end.slope) > curve_tuning.leaves_surface * end.gradient)) count.certain = false;
        end.value = std::copysign(std::numeric_limits<double>::min(), way * end.slope);
    };
    const auto judge = [&](const Place& a, const Place& b, std::int64_t span, int depth) {
        RootCount& count = counts[span];
        if (!a.finite() || !b.finite()) {
            count.certain = false;
            return;
        }
        const double share = split_of(a, b);
        if (std::isnan(share)) return;
        if (share < 0.0) {
            ++count.roots;
            const double at = a.at + a.value / (a.value - b.value) * (b.at - a.at);
            roots.push_back({span, a.at, b.at, at, Illinois(a.value, b.value)});
            return;
        }
        const double middle = a.at + share * (b.at - a.at);
        if (depth < curve_tuning.most_steps && middle > a.at && middle < b.at) {
            pieces.push_back({a, b, span, depth, middle});
            point.push_back(lines[spans.span[span].line].at(middle));
            return;
        }
        // The piece is too short to split, so the signs at its ends decide the number of roots.
        count.certain = false;
        if (a.negative() != b.negative()) ++count.roots;
    };

    geometry::VecArray first(work.memory);
    std::int64_t at = 0;
    for (const Span& span : spans.span)
        for (std::int64_t k = 0; k < span.places; ++k) first.push_back(lines[span.line].at(spans.place[at++]));
    HRBFNPR_ASSERT(at == spans.place.size());
    const Field field(work, implicit, first);
    at = 0;
    for (std::int64_t i = 0; i < spans.span.size(); ++i) {
        const Span& span = spans.span[i];
        Place before{};
        for (std::int64_t k = 0; k < span.places; ++k, ++at) {
            Place now = field.place(at, lines[span.line], spans.place[at]);
            const bool begins = k == 0 && span.line_begins;
            const bool ends = k + 1 == span.places && span.line_ends;
            if (begins) settle_end(counts[i], now, 1.0);
            if (ends) settle_end(counts[i], now, -1.0);
            if (!begins && !ends && touches(now)) counts[i].certain = false;
            if (k > 0) judge(before, now, i, 0);
            before = now;
        }
    }
    while (!pieces.empty()) {
        work.check();
        const Field middles(work, implicit, point);
        base::Array<Piece> split(work.memory);
        std::swap(split, pieces);
        point.clear();
        for (std::int64_t i = 0; i < split.size(); ++i) {
            const Piece& piece = split[i];
            const Place middle = middles.place(i, lines[spans.span[piece.span].line], piece.at);
            if (middle.finite() && touches(middle)) {
                RootCount& count = counts[piece.span];
                count.certain = false;
                if (piece.low.negative() != middle.negative()) ++count.roots;
                if (piece.high.negative() != middle.negative()) ++count.roots;
                continue;
            }
            judge(piece.low, middle, piece.span, piece.depth + 1);
            judge(middle, piece.high, piece.span, piece.depth + 1);
        }
    }
}

// Removes the roots beyond the end of the surface from the list and from the counts. Roots near the border are computed
// exactly first. If a root is on the border, up to rounding, the count is not certain.
void drop_roots(const base::Work& work, const implicit::Implicit& implicit, const implicit::Domain& domain,
                const base::Array<Line>& lines, const Spans& spans, base::Array<Root>& roots,
                base::Array<RootCount>& counts) {
    const auto line = [&](const Root& root) -> const Line& { return lines[spans.span[root.span].line]; };
    const auto width = [&](const Root& root) {
        return curve_tuning.root_noise * implicit.diagonal() / (root.high - root.low);
    };
    base::Array<double> beyond(work.memory, roots.size());
    std::fill(beyond.begin(), beyond.end(), -1.0);
    base::Array<std::int64_t> left(work.memory); // the roots whose search continues
    for (std::int64_t i = 0; i < roots.size(); ++i)
        if (domain.near_end(line(roots[i]).at(0.5 * (roots[i].low + roots[i].high)))) left.push_back(i);
    geometry::VecArray place(work.memory);
    while (!left.empty()) {
        place.clear();
        for (const std::int64_t i : left)
            place.push_back(line(roots[i]).at(glm::mix(roots[i].low, roots[i].high, roots[i].search.trial)));
        const Field field(work, implicit, place);
        std::int64_t kept = 0;
        for (std::int64_t k = 0; k < left.size(); ++k) {
            const std::int64_t i = left[k];
            Illinois& search = roots[i].search;
            const double before = search.trial;
            search.take(field.value[k]);
            const bool found = search.done(width(roots[i])) || std::abs(search.trial - before) <= width(roots[i]);
            if (!found && search.steps < curve_tuning.most_steps) {
                left[kept++] = i;
                continue;
            }
            beyond[i] = domain.beyond(place[k], field.gradient[k]);
            if (!found || std::abs(beyond[i]) < curve_tuning.on_border) counts[roots[i].span].certain = false;
        }
        left.resize(kept);
    }
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < roots.size(); ++i) {
        if (beyond[i] > 0.0)
            --counts[roots[i].span].roots;
        else
            roots[kept++] = roots[i];
    }
    roots.resize(kept);
}

} // namespace

SheetCounter::SheetCounter(const base::Work& work, const SurfaceMesh& mesh)
    : mesh_(mesh), bulge_(work.memory, mesh.triangles()), tree_(work, mesh.triangles(), [&](std::int64_t t) {
          bulge_[t] = bulge_of(mesh, t);
          geometry::Bounds box;
          for (const glm::dvec3& corner : corners_of(mesh, t)) box.extend(corner);
          return box.grown(bulge_[t]);
      }) {}

void SheetCounter::count(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& from,
                         const geometry::VecArray& to, const base::Array<double>& clear,
                         base::Array<Result>& answer) const {
    const std::int64_t segments = from.size();
    HRBFNPR_ASSERT(to.size() == segments && clear.size() == segments);
    base::Array<Line> lines(work.memory, segments);
    base::List<Spans> found(work.memory);
    found.reserve((segments + segments_a_task - 1) / segments_a_task);
    for (std::int64_t k = 0; k < segments; k += segments_a_task) found.add(work.memory);
    work.for_chunks(segments, segments_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            lines[i] = line_of(mesh_.region, from[i], to[i], clear[i]);
            find_spans(mesh_, tree_, bulge_, lines[i], i, found[begin / segments_a_task]);
        }
    });
    Spans spans(work.memory);
    for (const Spans& some : found) {
        for (const Span& span : some.span) spans.span.push_back(span);
        for (const double place : some.place) spans.place.push_back(place);
    }
    base::Array<RootCount> counts(work.memory);
    base::Array<Root> roots(work.memory);
    const implicit::Domain* const domain = mesh_.domain;
    count_roots(work, implicit, lines, spans, counts, roots);
    if (domain != nullptr) drop_roots(work, implicit, *domain, lines, spans, roots, counts);

    answer.resize(segments);
    std::fill(answer.begin(), answer.end(), Result{});
    for (std::int64_t i = 0; i < spans.span.size(); ++i) {
        const Span& span = spans.span[i];
        Result& its = answer[span.line];
        its.sheets += counts[i].roots;
        const bool beside_end = span.line_begins || span.line_ends;
        if (!counts[i].certain || (!beside_end && counts[i].roots != span.crossings)) its.certain = false;
    }
    base::Array<std::uint8_t> known(work.memory, segments);
    for (const Root& root : roots) {
        const std::int64_t line = spans.span[root.span].line;
        Result& its = answer[line];
        its.nearest = known[line] != 0 ? std::min(its.nearest, root.at) : root.at;
        known[line] = 1;
    }
    work.update(1.0);
}

} // namespace hrbfnpr::curves
