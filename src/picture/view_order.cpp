// SPDX-License-Identifier: MIT
#include "picture/view_order.h"

#include "picture/tuning_views.h"

#include <array>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace hrbfnpr::picture {
namespace {

constexpr const ViewOrderTuning& tuned = view_order_tuning;

// A range of equal flags, from `begin` up to but not including `end`.
struct Run {
    std::size_t begin;
    std::size_t end;
    bool value;
};

Vector<Run> runs_of(const Flags& flags, Pool& pool) {
    Vector<Run> runs(&pool);
    for (std::size_t i = 0; i < flags.size(); ++i) {
        if (runs.empty() || runs.back().value != (flags[i] != 0)) runs.push_back({i, i, flags[i] != 0});
        runs.back().end = i + 1;
    }
    return runs;
}

// ---- Occupied places

// A place on a line that was already drawn.
struct TakenPlace {
    glm::dvec2 place;
    glm::dvec2 direction; // unit vector
    double along;         // length along the curve
    std::size_t curve;    // the index of the curve
    double around;        // the length of a closed curve, else 0
    double reach;
};

// Returns the distance between two places of a curve, measured along the curve.
double apart_along(double a, double b, double around) noexcept {
    const double direct = std::abs(a - b);
    return around > 0.0 ? std::min(direct, around - direct) : direct;
}

class TakenPlaces {
public:
    TakenPlaces(double cell, Pool& pool)
        : cell_(cell), alike_(std::sin(tuned.alike_degrees * (std::numbers::pi / 180.0))), places_(&pool) {
        HRBFNPR_ASSERT(cell > 0.0);
    }

    // Returns whether a drawn line already occupies a place. If the line is the same curve, its places close by along
    // the curve do not count.
    [[nodiscard]] bool has(const TakenPlace& wanted) const {
        const PaperCell middle = cell_of(wanted.place, cell_);
        for (std::int64_t column = middle.column - 1; column <= middle.column + 1; ++column)
            for (std::int64_t row = middle.row - 1; row <= middle.row + 1; ++row) {
                const auto found = places_.find({column, row});
                if (found == places_.end()) continue;
                for (const TakenPlace& taken : found->second)
                    if (is_same(taken, wanted)) return true;
            }
        return false;
    }

    void add(const TakenPlace& place) { places_[cell_of(place.place, cell_)].push_back(place); }

private:
    [[nodiscard]] bool is_same(const TakenPlace& taken, const TakenPlace& wanted) const noexcept {
        const double reach = std::max(taken.reach, wanted.reach);
        const glm::dvec2 away = taken.place - wanted.place;
        if (away.x * away.x + away.y * away.y >= reach * reach) return false;
        if (taken.curve == wanted.curve &&
            apart_along(taken.along, wanted.along, wanted.around) < tuned.own_part * reach)
            return false;
        return std::abs(taken.direction.x * wanted.direction.y - taken.direction.y * wanted.direction.x) < alike_;
    }

    double cell_;
    double alike_; // the sine of the largest angle between directions that count as parallel
    HashMap<PaperCell, Vector<TakenPlace>, PaperCellHash> places_;
};

// ---- The free rest of a part

// A part of a curve, between two lengths along it.
struct CurvePart {
    std::size_t curve;
    int rank;
    double begin;
    double end;
    bool hidden;
};

// Extends the free parts of a line up to the lines that it meets. Just before two lines meet, they run close together,
// for at most the length `joining`, or one of them continues the other.
void run_on(Flags& free, const Vector<double>& at, double reach, double joining, Pool& pool) {
    const Vector<Run> runs = runs_of(free, pool);
    const auto length = [&](std::size_t i) { return at[runs[i].end - 1] - at[runs[i].begin]; };
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].value || runs.size() == 1) continue;
        double most = joining;
        if (i > 0) most = std::min(most, length(i - 1));
        if (i + 1 < runs.size()) most = std::min(most, length(i + 1));
        if (length(i) < std::max(2.0 * reach, most))
            std::fill(free.begin() + static_cast<std::ptrdiff_t>(runs[i].begin),
                      free.begin() + static_cast<std::ptrdiff_t>(runs[i].end), std::uint8_t{1});
    }
    // Just before two lines meet, they are within `reach` of each other, and a place counts as occupied by the other
    // line. So free parts are extended by `reach`.
    const auto more = static_cast<std::size_t>(std::ceil(reach / tuned.step));
    for (const Run& run : runs_of(free, pool)) {
        if (!run.value) continue;
        const std::size_t begin = run.begin - std::min(run.begin, more);
        const std::size_t end = std::min(run.end + more, free.size());
        std::fill(free.begin() + static_cast<std::ptrdiff_t>(begin), free.begin() + static_cast<std::ptrdiff_t>(end),
                  std::uint8_t{1});
    }
}

// Marks the free places of a part as occupied. Returns the free ranges, as lengths along the curve.
Vector<std::pair<double, double>> take_free(const ViewCurve& curve, const Vector<double>& along, const CurvePart& part,
                                            TakenPlaces& taken, Pool& pool) {
    const Vector<double> at = evenly(part.begin, part.end, count_on(part.end - part.begin, tuned.step), pool);
    const bool is_closed = curve.points.front() == curve.points.back();
    Flags free(at.size(), 0, &pool);
    for (std::size_t i = 0; i < at.size(); ++i) {
        const std::size_t piece = std::min(last_not_beyond(along, at[i]), along.size() - 2);
        const glm::dvec2 way = curve.points[piece + 1] - curve.points[piece];
        const TakenPlace place{interpolated<glm::dvec2>(along, curve.points, at[i]),
                               way / std::max(along[piece + 1] - along[piece], 1e-12),
                               at[i],
                               part.curve,
                               is_closed ? along.back() : 0.0,
                               curve.reach};
        if (taken.has(place)) continue;
        free[i] = 1;
        taken.add(place);
    }
    // A hidden line has a gap along a visible one, however short that is [ISO 128-2].
    run_on(free, at, curve.reach, part.hidden ? 0.0 : tuned.joining, pool);
    Vector<std::pair<double, double>> lengths(&pool);
    for (const Run& run : runs_of(free, pool))
        if (run.value && run.end > run.begin + 1) lengths.emplace_back(at[run.begin], at[run.end - 1]);
    return lengths;
}

PaperLine between_lengths(const PaperLine& points, const Vector<double>& along, double begin, double end, Pool& pool) {
    constexpr double nothing = 1e-9; // Shorter lengths count as 0, in mm.
    PaperLine line(&pool);
    line.push_back(interpolated<glm::dvec2>(along, points, begin));
    for (std::size_t i = 0; i < along.size(); ++i)
        if (along[i] > begin + nothing && along[i] < end - nothing) line.push_back(points[i]);
    line.push_back(interpolated<glm::dvec2>(along, points, end));
    return line;
}

// ---- Short gaps

// Returns the direction of a line at its end. If `turned`, returns the direction at the end of the reversed line.
glm::dvec2 direction_at_end(const PaperLine& line, bool turned) noexcept {
    const std::size_t count = line.size();
    const auto point = [&](std::size_t i) { return turned ? line[i] : line[count - 1 - i]; };
    glm::dvec2 begin = point(count - 1);
    double length = 0.0;
    for (std::size_t i = 1; i < count; ++i) {
        const double next = length + glm::length(point(i) - point(i - 1));
        if (next > tuned.end) { // The place at the distance `end` is on this piece.
            const glm::dvec2 slope = (point(i) - point(i - 1)) / (next - length);
            begin = length == tuned.end ? point(i - 1) : slope * (tuned.end - length) + point(i - 1);
            break;
        }
        length = next;
    }
    const glm::dvec2 step = point(0) - begin;
    return step / std::max(glm::length(step), 1e-12);
}

struct NextPiece {
    std::size_t number;
    bool turned; // true if the last point of the piece touches the line
};

// Finds the piece that continues the line at its end. Returns false without such a piece.
bool find_next(const PaperLine& line, const Vector<PaperLine>& rest, std::span<const glm::dvec2> barriers,
               NextPiece& next) noexcept {
    if (line.front() == line.back()) return false;
    const glm::dvec2 way = direction_at_end(line, false);
    for (std::size_t i = 0; i < rest.size(); ++i)
        for (const bool turned : {false, true}) {
            const glm::dvec2 gap = (turned ? rest[i].back() : rest[i].front()) - line.back();
            const double away = glm::length(gap);
            if (!(away > 0.0 && away < tuned.bridged && glm::dot(gap, way) > tuned.straight * away)) continue;
            if (!(glm::dot(-direction_at_end(rest[i], !turned), way) > tuned.straight)) continue;
            const auto is_in_gap = [&](const glm::dvec2& barrier) {
                return glm::length(barrier - (line.back() + 0.5 * gap)) < 0.5 * away;
            };
            if (std::any_of(barriers.begin(), barriers.end(), is_in_gap)) continue;
            next = {i, turned};
            return true;
        }
    return false;
}

// Joins pieces that continue each other across a short gap without a barrier.
Vector<PaperLine> bridged(Vector<PaperLine> rest, std::span<const glm::dvec2> barriers, Pool& pool) {
    Vector<PaperLine> found(&pool);
    while (!rest.empty()) {
        PaperLine line = std::move(rest.front());
        rest.erase(rest.begin());
        for (int turn = 0; turn < 2; ++turn) { // The line is extended at its beginning, then at its end.
            std::reverse(line.begin(), line.end());
            for (NextPiece next{}; find_next(line, rest, barriers, next);) {
                PaperLine& part = rest[next.number];
                if (next.turned) std::reverse(part.begin(), part.end());
                line.insert(line.end(), part.begin(), part.end());
                rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(next.number));
            }
        }
        found.push_back(std::move(line));
    }
    return found;
}

// Returns the middles of short parts that are sure to be hidden, or to be visible. Lines of the other state have true
// gaps there, as before a wire.
Vector<glm::dvec2> short_parts_of(const Vector<ViewCurve>& curves, const Vector<Vector<double>>& along,
                                  const Vector<CurvePart>& parts, bool hidden, Pool& pool) {
    Vector<glm::dvec2> middles(&pool);
    for (const CurvePart& part : parts) {
        const ViewCurve& curve = curves[part.curve];
        if (part.hidden != hidden || curve.sure.empty() || part.end - part.begin > tuned.bridged) continue;
        const double middle = 0.5 * (part.begin + part.end);
        const std::size_t piece = std::min(last_not_beyond(along[part.curve], middle), curve.sure.size() - 1);
        if (curve.sure[piece] != 0)
            middles.push_back(interpolated<glm::dvec2>(along[part.curve], curve.points, middle));
    }
    return middles;
}

} // namespace

Flags steady(const ViewCurve& curve, Pool& pool) {
    HRBFNPR_ASSERT(curve.points.size() > 1 && curve.hidden.size() == curve.points.size() - 1);
    Flags hidden(curve.hidden.begin(), curve.hidden.end(), &pool);
    const Vector<double> along = lengths_along(curve.points, pool);
    const Vector<Run> runs = runs_of(hidden, pool);
    // In a closed curve, the first and last runs have neighbours on both sides, too.
    const bool goes_round = curve.points.front() == curve.points.back() && hidden.front() != hidden.back();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (!goes_round && (i == 0 || i + 1 == runs.size())) continue;
        const Run& run = runs[i];
        const double length = along[run.end] - along[run.begin];
        if (!curve.sure.empty() && curve.sure[run.begin] != 0) continue;
        if (length < tuned.flicker &&
            glm::length(curve.points[run.end] - curve.points[run.begin]) > tuned.onward * length)
            std::fill(hidden.begin() + static_cast<std::ptrdiff_t>(run.begin),
                      hidden.begin() + static_cast<std::ptrdiff_t>(run.end), static_cast<std::uint8_t>(!run.value));
    }
    return hidden;
}

ShownLines draw_in_order(const Vector<ViewCurve>& curves, bool with_hidden, Pool& pool) {
    Vector<Vector<double>> along(&pool);
    Vector<CurvePart> parts(&pool);
    double cell = 0.0;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const ViewCurve& curve = curves[i];
        along.push_back(lengths_along(curve.points, pool));
        if (curve.points.size() < 2) continue;
        HRBFNPR_ASSERT(curve.reach > 0.0);
        cell = std::max(cell, curve.reach);
        for (const Run& run : runs_of(steady(curve, pool), pool))
            parts.push_back({i, curve.rank, along[i][run.begin], along[i][run.end], run.value});
    }
    ShownLines shown(pool);
    if (parts.empty()) return shown;
    // Long parts come first. Otherwise a line would be extended over short lines beside it, which would then be drawn
    // twice.
    std::stable_sort(parts.begin(), parts.end(), [](const CurvePart& a, const CurvePart& b) {
        return std::pair(a.rank, a.begin - a.end) < std::pair(b.rank, b.begin - b.end);
    });
    TakenPlaces taken(cell, pool);
    const auto draw = [&](Vector<PaperLine>& found, bool hidden, ViewClass of_class, double shortest) {
        for (const CurvePart& part : parts) {
            const ViewCurve& curve = curves[part.curve];
            if (part.hidden != hidden || curve.of_class != of_class || part.end - part.begin < shortest) continue;
            for (const auto& [begin, end] : take_free(curve, along[part.curve], part, taken, pool))
                if (end - begin >= tuned.shortest_rest)
                    found.push_back(between_lengths(curve.points, along[part.curve], begin, end, pool));
        }
        found = bridged(std::move(found), short_parts_of(curves, along, parts, !hidden, pool), pool);
    };
    draw(shown.outlines, false, ViewClass::edge, tuned.shortest_outline);
    draw(shown.tangent, false, ViewClass::tangent, tuned.shortest_outline);
    if (with_hidden) draw(shown.hidden, true, ViewClass::edge, tuned.shortest_hidden);
    draw(shown.smooth, false, ViewClass::smooth, tuned.shortest_smooth);
    return shown;
}

Vector<PaperLine> shortened(const Vector<PaperLine>& lines, double gap, Pool& pool) {
    HRBFNPR_ASSERT(gap >= 0.0);
    Vector<PaperLine> made(&pool);
    for (const PaperLine& line : lines) {
        const Vector<double> along = lengths_along(line, pool);
        const double less = line.front() == line.back() ? 0.0 : std::min(gap, 0.25 * along.back());
        made.push_back(between_lengths(line, along, less, along.back() - less, pool));
    }
    return made;
}

} // namespace hrbfnpr::picture
