// SPDX-License-Identifier: MIT
// Proves which parts of lines are visible. Rays go from the eye to several places of each part (places_to_look_at,
// visibility::look_at). A part agrees if all decided rays show what it is drawn as. Where rays show something else, the
// part is divided between the places at which the rays differ (find_turns), and its pieces are drawn as the rays show
// them (repaired). Divided parts are looked at again.
#include "base/assert.h"
#include "frame/lines/lines.h"
#include "frame/lines/tuning.h"
#include "visibility/sight.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

using visibility::Seen;
using visibility::Sighting;
using visibility::SightPlace;

// A place along a part that a ray goes to.
struct LookedAt {
    std::int64_t part;
    double at; // the distance along the line, in pixels
};

bool is_hidden(const LinePart& part) noexcept { return part.layers > 0; }

// Returns a place for a ray. Its margin is a distance in the image, as a length at the place.
SightPlace sight_place(const LineInput& in, std::int32_t line, double at) {
    const StrokePlace place = place_along(in, line, at);
    const visibility::Piece& piece = in.piece(place.piece);
    const visibility::Subject& subject = in.found.subjects[piece.subject];
    const glm::dvec3 p = visibility::cubic(in.found.subjects.span(), piece).at(place.share);
    // The number of pixels of a unit, across the line of sight.
    const glm::dvec4 q = subject.view.to_window * glm::dvec4(p, 1.0);
    double pixels = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec2 change =
            (glm::dvec2(subject.view.to_window[axis]) - subject.view.to_window[axis].w * glm::dvec2(q) / q.w) / q.w;
        pixels = std::max(pixels, glm::length(change));
    }
    const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(subject.to_world))));
    SightPlace found;
    found.place = glm::dvec3(subject.to_world * glm::dvec4(p, 1.0));
    found.item = subject.other_item < 0 ? subject.item : visibility::any_item;
    found.margin = pixels > 0.0 ? scale * line_tuning.verified_margin / pixels : 0.0;
    found.lift = std::max(found.margin, scale * subject.clearance * subject.side);
    return found;
}

base::Array<Sighting> look(const base::Work& work, const LineInput& in, const base::Array<LinePart>& parts,
                           const base::Array<LookedAt>& places) {
    base::Array<SightPlace> rays(work.memory, places.size());
    for (std::int64_t i = 0; i < places.size(); ++i)
        rays[i] = sight_place(in, parts[places[i].part].interval.line, places[i].at);
    base::Array<Sighting> seen = visibility::look_at(work, in.traced.occluders.span(), std::as_const(rays).span());
    for (std::int64_t i = 0; i < places.size(); ++i)
        if (is_hidden(parts[places[i].part]) && seen[i].grazes && seen[i].seen == Seen::visible)
            seen[i].seen = Seen::undecided;
    return seen;
}

// Adds the places of a part, in order and away from its ends. A part shorter than the distances from both ends has one
// place, in its middle.
void add_places(const LinePart& part, std::int64_t number, base::Array<LookedAt>& places) {
    const visibility::Interval& its = part.interval;
    const double begin = its.begin_at + line_tuning.verified_from_end;
    const double end = its.end_at - line_tuning.verified_from_end;
    if (!(end > begin)) {
        places.push_back({number, 0.5 * (its.begin_at + its.end_at)});
        return;
    }
    const double steps =
        std::clamp(std::ceil((end - begin) / line_tuning.verified_step), 2.0, line_tuning.verified_most);
    for (double k = 0.0; k <= steps; k += 1.0) places.push_back({number, glm::mix(begin, end, k / steps)});
}

// A place along a part from which on rays show something else.
struct Turn {
    std::int64_t part;
    double at;
    Sighting from; // the sighting from there on
};

// Finds the turns of parts, each between two places that differ. Halving the way between them makes them exact.
base::Array<Turn> find_turns(const base::Work& work, const LineInput& in, const base::Array<LinePart>& parts,
                             const base::Array<LookedAt>& places, const base::Array<Sighting>& seen) {
    base::Array<Turn> turns(work.memory);
    base::Array<LookedAt> low(work.memory);
    base::Array<LookedAt> high(work.memory);
    base::Array<Seen> seen_low(work.memory);
    std::int64_t last = -1;
    for (std::int64_t i = 0; i < places.size(); ++i) {
        if (seen[i].seen == Seen::undecided) continue;
        if (last >= 0 && places[last].part == places[i].part && seen[last].seen != seen[i].seen) {
            turns.push_back({places[i].part, places[i].at, seen[i]});
            low.push_back(places[last]);
            high.push_back(places[i]);
            seen_low.push_back(seen[last].seen);
        }
        last = i;
    }
    for (int k = 0; k < line_tuning.verified_halvings && !turns.empty(); ++k) {
        base::Array<LookedAt> middle(work.memory);
        for (std::int64_t i = 0; i < turns.size(); ++i) middle.push_back({low[i].part, 0.5 * (low[i].at + high[i].at)});
        const base::Array<Sighting> found = look(work, in, parts, middle);
        for (std::int64_t i = 0; i < turns.size(); ++i) (found[i].seen == seen_low[i] ? low : high)[i] = middle[i];
    }
    for (std::int64_t i = 0; i < turns.size(); ++i) turns[i].at = 0.5 * (low[i].at + high[i].at);
    return turns;
}

// Draws a part as it is seen.
void draw_as(LinePart& part, const Sighting& sighting) noexcept {
    if ((sighting.seen == Seen::hidden) == is_hidden(part)) return;
    part.layers = sighting.seen == Seen::hidden ? 1 : 0;
    part.interval.hidden_by = sighting.hidden_by;
}

// Adds a part to the parts of its line. It continues the part before it if both look the same.
void add_part(const LinePart& part, base::Array<LinePart>& parts) {
    if (!parts.empty()) {
        LinePart& last = parts.back();
        const visibility::Interval& its = part.interval;
        if (last.interval.line == its.line && last.layers == part.layers && last.interval.hidden_by == its.hidden_by &&
            last.interval.end_at == its.begin_at) {
            last.interval.end_piece = its.end_piece;
            last.interval.end_share = its.end_share;
            last.interval.end_at = its.end_at;
            last.interval.end_sine = its.end_sine;
            last.free_end = part.free_end;
            return;
        }
    }
    parts.push_back(part);
}

// Returns the parts, divided at their turns, as they are seen. `first_seen` has for each part a decided sighting at its
// beginning; it is undecided if none of the part's places is decided.
base::Array<LinePart> repaired(const LineInput& in, const base::Array<LinePart>& parts,
                               const base::Array<Sighting>& first_seen, const base::Array<Turn>& turns) {
    base::Array<LinePart> made(parts.memory());
    std::int64_t next = 0;
    for (std::int64_t i = 0; i < parts.size(); ++i) {
        LinePart rest = parts[i];
        if (first_seen[i].seen != Seen::undecided) draw_as(rest, first_seen[i]);
        for (; next < turns.size() && turns[next].part == i; ++next) {
            const StrokePlace place = place_along(in, rest.interval.line, turns[next].at);
            LinePart piece = rest;
            piece.interval.end_piece = rest.interval.begin_piece = place.piece;
            piece.interval.end_share = rest.interval.begin_share = place.share;
            piece.interval.end_at = rest.interval.begin_at = turns[next].at;
            piece.interval.end_sine = rest.interval.begin_sine = 0.0F;
            piece.free_end = rest.free_begin = false;
            add_part(piece, made);
            draw_as(rest, turns[next].from);
        }
        add_part(rest, made);
    }
    return made;
}

} // namespace

StrokePlace place_along(const LineInput& in, std::int32_t number, double at) noexcept {
    const visibility::Line& line = in.line(number);
    const double whole = in.total(number);
    const double here = line.closed && at > whole ? at - whole : at;
    std::int64_t low = line.first_point;
    std::int64_t high = line.first_point + line.points - 1;
    while (high - low > 1) {
        const std::int64_t middle = (low + high) / 2;
        (in.lengths.at_point(middle) <= here ? low : high) = middle;
    }
    const visibility::ImagePoint& a = in.found.lines.points[low];
    const visibility::ImagePoint& b = in.found.lines.points[high];
    const double chord = in.lengths.at_point(high) - in.lengths.at_point(low);
    const double share = chord > 0.0 ? std::clamp((here - in.lengths.at_point(low)) / chord, 0.0, 1.0) : 0.0;
    // A point at the end of a piece may be the beginning of the next piece.
    return {at, a.piece, glm::mix(a.share, b.piece == a.piece ? b.share : 1.0, share)};
}

base::Array<LinePart> verify_parts(const base::Work& work, const LineInput& in, base::Array<LinePart> parts,
                                   std::span<const std::uint8_t> wanted, drawing::LineCounts& counts) {
    HRBFNPR_ASSERT(wanted.size() == static_cast<std::size_t>(in.found.subjects.size()));
    const auto is_wanted = [&](const LinePart& part) {
        return wanted[static_cast<std::size_t>(in.line(part.interval.line).subject)] != 0;
    };
    for (int round = 0;; ++round) {
        base::Array<LookedAt> places(work.memory);
        for (std::int64_t i = 0; i < parts.size(); ++i)
            if (is_wanted(parts[i])) add_places(parts[i], i, places);
        const base::Array<Sighting> seen = look(work, in, parts, places);
        base::Array<Sighting> first_seen(work.memory, parts.size());
        base::Array<std::uint8_t> wrong(work.memory, parts.size());
        for (Sighting& sighting : first_seen) sighting.seen = Seen::undecided;
        for (std::int64_t i = 0; i < places.size(); ++i) {
            const std::int64_t part = places[i].part;
            if (seen[i].seen != Seen::undecided && first_seen[part].seen == Seen::undecided) first_seen[part] = seen[i];
            if (seen[i].seen != Seen::undecided && (seen[i].seen == Seen::hidden) != is_hidden(parts[part]))
                wrong[part] = 1;
        }
        const std::int64_t all_wrong = std::count(wrong.begin(), wrong.end(), std::uint8_t{1});
        if (all_wrong == 0 || round == line_tuning.verified_rounds) {
            for (std::int64_t i = 0; i < parts.size(); ++i) {
                if (!is_wanted(parts[i])) continue;
                ++counts.pieces;
                if (first_seen[i].seen == Seen::undecided)
                    ++counts.undecided;
                else if (wrong[i] == 0)
                    ++counts.agreeing;
            }
            return parts;
        }
        counts.repaired += all_wrong;
        parts = repaired(in, parts, first_seen, find_turns(work, in, parts, places, seen));
    }
}

} // namespace hrbfnpr::frame
