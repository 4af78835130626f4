// SPDX-License-Identifier: MIT
// Counts the sheets before lines. Each round draws the lines and finds their crossings. Events are the places where the
// number of sheets before a line changes (collect_events). The parts between events get sheet counts relative to the
// start of the line (parts_between). A few rays (best_ray, send_rays) give an absolute count, from which the absolute
// counts of all parts of a line follow (set_invisibility). Lines whose changes and rays contradict each other are made
// finer for the next round (refine_curves). In the last round, each part of such a line gets the sheet count of a ray
// to this part (number_by_own_rays). The outline is found in the same way, with rays that come from beyond the surface.
#include "visibility/invisibility.h"

#include "base/assert.h"
#include "curves/curve_changes.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace hrbfnpr::visibility {
namespace {

// The data that all steps of counting read.
struct CountingInput {
    const base::Work& work;
    std::span<const Subject> subjects;
    std::span<const Occluder> occluders;
    const ImageLines& lines;
    const LineLengths& lengths;

    [[nodiscard]] base::Memory& memory() const noexcept { return work.memory; }
    [[nodiscard]] const Line& line(std::int64_t l) const noexcept { return lines.lines[l]; }
};

// A ray to a place on a line. It comes from the eye, or from beyond the surface.
struct Ray {
    std::int32_t line, subject;
    double at;        // position along the line, in pixels
    double score;     // distance to the nearer end of the part, in pixels
    glm::dvec3 place; // in the coordinates of the subject
    // The results of the ray.
    std::int32_t invisibility;
    std::int32_t nearest; // the occluder on the ray that is nearest to the place, or -1
    double distance;      // the distance from the place to that occluder, in world units
    bool certain;
};

double length_of(const Interval& part) noexcept { return part.end_at - part.begin_at; }

std::span<const Ray> rays_of(const base::Array<Ray>& rays, std::int32_t line) noexcept {
    const auto [first, end] = std::equal_range(rays.begin(), rays.end(), Ray{line, 0, 0, 0, {}, 0, 0, 0, false},
                                               [](const Ray& a, const Ray& b) { return a.line < b.line; });
    return {first, end};
}

// Calls f for each range of parts that belong to the same line.
template <class F>
void for_lines(std::span<Interval> parts, const F& f) {
    for (std::size_t first = 0; first < parts.size();) {
        std::size_t end = first;
        while (end < parts.size() && parts[end].line == parts[first].line) ++end;
        f(parts.subspan(first, end - first));
        first = end;
    }
}

// Returns the ray to that vertex of a part that is farthest from the ends of the part. If the part has no vertices,
// returns the ray to the middle of its cubic.
Ray best_ray(const CountingInput& in, const Interval& part) noexcept {
    const Line& its = in.line(part.line);
    const base::Array<curves::CurvePoint>& point = in.subjects[static_cast<std::size_t>(its.subject)].curves->point;
    const double whole = in.lengths.total(its);
    Ray best{part.line, its.subject, 0.0, -1.0, glm::dvec3(0.0), 0, -1, 0.0, true};
    // The length of the complete turns of a closed line before piece p.
    double beyond = its.closed && part.begin_at >= whole ? whole : 0.0;
    const std::int64_t begin = in.lengths.piece_at(its, part.begin_at - beyond);
    const double from = in.lengths.at(its, begin, 0.0) + beyond;
    std::int64_t p = begin;
    for (std::int64_t step = 0; step < its.pieces; ++step) {
        if (++p == its.first_piece + its.pieces) {
            if (!its.closed) break;
            p = its.first_piece;
            beyond += whole;
        }
        const double at = in.lengths.at(its, p, 0.0) + beyond;
        if (at >= part.end_at) break;
        const double clear = std::min(at - part.begin_at, part.end_at - at);
        if (!(clear > best.score)) continue;
        best.score = clear;
        best.at = at;
        best.place = point[in.lines.pieces[p].a].position;
    }
    if (!(best.score > 0.0)) {
        const double length = in.lengths.at(its, begin, 1.0) - in.lengths.at(its, begin, 0.0);
        best.at = 0.5 * (part.begin_at + std::min(part.end_at, from + length));
        const double share = length > 0.0 ? std::clamp((best.at - from) / length, 0.0, 1.0) : 0.5;
        best.place = cubic(in.subjects, in.lines.pieces[begin]).at(share);
        best.score = 1e-3 * length_of(part);
    }
    if (its.closed && best.at >= whole) best.at -= whole;
    return best;
}

// Adds at most `most` rays to parts of a line, those with the best scores.
void add_rays(const CountingInput& in, std::span<const Interval> parts, std::int64_t most, base::Array<Ray>& rays) {
    base::Array<Ray> all(in.memory());
    for (const Interval& part : parts) all.push_back(best_ray(in, part));
    std::sort(all.begin(), all.end(),
              [](const Ray& a, const Ray& b) { return a.score != b.score ? a.score > b.score : a.at < b.at; });
    for (std::int64_t i = 0; i < std::min(most, all.size()); ++i) rays.push_back(all[i]);
}

// Casts rays through all occluders to places on lines, from the eye or from beyond the whole surface.
void send_rays(const CountingInput& in, bool from_beyond, base::Array<Ray>& rays) {
    geometry::VecArray from(in.memory(), rays.size());
    geometry::VecArray to(in.memory(), rays.size());
    base::Array<double> clear(in.memory(), rays.size());
    base::Array<curves::SheetCounter::Result> answers(in.memory());
    for (std::size_t o = 0; o < in.occluders.size(); ++o) {
        const Occluder& occluder = in.occluders[o];
        const glm::dmat4 from_world = glm::inverse(occluder.to_world);
        const glm::dvec3 eye(occluder.eye);
        for (std::int64_t i = 0; i < rays.size(); ++i) {
            const Subject& subject = in.subjects[static_cast<std::size_t>(rays[i].subject)];
            const bool own = static_cast<std::size_t>(subject.item) == o;
            const glm::dvec3 place =
                own ? rays[i].place : glm::dvec3(from_world * (subject.to_world * glm::dvec4(rays[i].place, 1.0)));
            const glm::dvec3 sight = occluder.eye.w != 0.0 ? place - eye : eye;
            const double reach =
                glm::distance(occluder.surface->bounds().centre(), place) + 2.0 * occluder.surface->diagonal();
            const glm::dvec3 way = (from_beyond ? reach : -reach) * glm::normalize(sight);
            from.set(i, !from_beyond && occluder.eye.w != 0.0 ? eye : place + way);
            to.set(i, place);
            const bool is_on = subject.is_on(static_cast<std::int32_t>(o));
            clear[i] = is_on ? subject.clearance * (own ? subject.side : occluder.sheet_counter->mesh().side) : 0.0;
        }
        occluder.sheet_counter->count(in.work, *occluder.surface, from, to, clear, answers);
        HRBFNPR_ASSERT(answers.size() == rays.size());
        for (std::int64_t i = 0; i < rays.size(); ++i) {
            Ray& ray = rays[i];
            ray.invisibility += answers[i].sheets;
            ray.certain = ray.certain && answers[i].certain;
            if (answers[i].sheets <= 0) continue;
            const glm::dvec3 way = glm::dmat3(occluder.to_world) * glm::normalize(from[i] - to[i]);
            const double distance = answers[i].nearest * glm::length(way);
            if (ray.nearest >= 0 && distance >= ray.distance) continue;
            ray.nearest = static_cast<std::int32_t>(o);
            ray.distance = distance;
        }
    }
}

// Converts the sheet counts of a line's parts from counts relative to the start of the line to absolute counts. Certain
// rays decide; without certain rays, all rays decide. Returns false if rays contradict each other, or if a count would
// be negative.
bool set_invisibility(std::span<Interval> parts, std::span<const Ray> rays, double whole) noexcept {
    const auto relative = [&](double at) {
        for (const Interval& part : parts)
            for (const double here : {at, at + whole})
                if (here >= part.begin_at && here <= part.end_at) return part.invisibility;
        return parts[0].invisibility;
    };
    HRBFNPR_ASSERT(!parts.empty());
    const bool all = std::none_of(rays.begin(), rays.end(), [](const Ray& ray) { return ray.certain; });
    bool agree = true;
    bool known = false;
    std::int32_t shift = 0;
    for (const Ray& ray : rays) {
        if (!ray.certain && !all) continue;
        const std::int32_t here = ray.invisibility - relative(ray.at);
        if (!known) shift = here;
        agree = agree && here == shift;
        known = true;
    }
    for (Interval& part : parts) {
        part.invisibility += shift;
        agree = agree && part.invisibility >= 0;
    }
    return known && agree;
}

// Sets the sheet count of each part of the given lines to the result of a ray to this part, if the ray is certain. A
// part too short for a ray gets the sheet count of the part before it. Returns the number of lines with an uncertain
// ray.
std::int64_t number_by_own_rays(const CountingInput& in, bool from_beyond, std::span<const std::int32_t> lines,
                                std::span<Interval> parts, std::int64_t& sent) {
    HRBFNPR_ASSERT(std::is_sorted(lines.begin(), lines.end()));
    base::Array<Ray> rays(in.memory());
    base::Array<Interval*> asked(in.memory());
    const auto is_short = [](const Interval& part) { return length_of(part) <= visibility_tuning.unseen_length; };
    for (Interval& part : parts) {
        if (is_short(part) || !std::binary_search(lines.begin(), lines.end(), part.line)) continue;
        rays.push_back(best_ray(in, part));
        asked.push_back(&part);
    }
    send_rays(in, from_beyond, rays);
    sent += rays.size();
    std::int64_t uncertain = 0;
    std::int32_t last = -1;
    for (std::int64_t i = 0; i < rays.size(); ++i) {
        if (rays[i].certain) {
            asked[i]->invisibility = rays[i].invisibility;
        } else if (last != rays[i].line) {
            ++uncertain;
            last = rays[i].line;
        }
    }
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (is_short(parts[i]) && parts[i].line == parts[i - 1].line &&
            std::binary_search(lines.begin(), lines.end(), parts[i].line))
            parts[i].invisibility = parts[i - 1].invisibility;
    return uncertain;
}

// Returns the parts of a line between its events. The sheet counts of the parts are relative to the start of the line
// or, for a closed line, to its first event.
base::Array<Interval> parts_between(const CountingInput& in, std::int64_t number, std::span<const Event> events) {
    const Line& line = in.line(number);
    base::Array<Interval> parts(in.memory());
    const auto is_cusp = [](const Event& e) { return e.near_piece < 0 && e.change != 0; };
    std::int32_t sheets = 0;
    const auto add = [&](const Event& from, const Event& to, double beyond) {
        if (!parts.empty()) sheets += from.change;
        parts.push_back({static_cast<std::int32_t>(number), from.piece, to.piece, from.share, to.share, from.at,
                         to.at + beyond, sheets, is_cusp(from), is_cusp(to), from.sine, to.sine});
    };
    const double whole = in.lengths.total(line);
    const Event begin{static_cast<std::int32_t>(line.first_piece), 0.0, 0, -1, 0.0};
    const Event end{static_cast<std::int32_t>(line.first_piece + line.pieces - 1), 1.0, 0, -1, whole};
    if (events.empty()) {
        add(begin, end, 0.0);
        return parts;
    }
    if (!line.closed) add(begin, events.front(), 0.0);
    for (std::size_t e = 0; e + 1 < events.size(); ++e) add(events[e], events[e + 1], 0.0);
    if (line.closed)
        add(events.back(), events.front(), whole);
    else
        add(events.back(), end, 0.0);
    return parts;
}

// Counts the sheets before all lines. Returns the lines with contradictory counts. Around a closed line, for example,
// the changes must add up to 0.
base::Array<std::int32_t> count_along_lines(const CountingInput& in, const Events& events, int rays_a_line,
                                            Invisibility& out) {
    const auto lines = static_cast<std::int32_t>(in.lines.lines.size());
    const auto seen_events = [&](std::int32_t l) {
        return without_torn_swallowtails(in.memory(), in.line(l), in.lengths, visibility_tuning.unseen_length,
                                         events.of(l));
    };
    base::Array<Ray> rays(in.memory());
    for (std::int32_t l = 0; l < lines; ++l)
        add_rays(in, parts_between(in, l, seen_events(l).span()).span(), rays_a_line, rays);
    send_rays(in, false, rays);
    out.report.rays += rays.size();
    out.intervals.clear();
    base::Array<std::int32_t> bad(in.memory());
    for (std::int32_t l = 0; l < lines; ++l) {
        const base::Array<Event> seen = seen_events(l);
        base::Array<Interval> parts = parts_between(in, l, seen.span());
        std::int32_t sum = 0;
        for (const Event& e : seen) sum += e.change;
        if (!set_invisibility(parts.span(), rays_of(rays, l), in.lengths.total(in.line(l))) ||
            (sum != 0 && in.line(l).closed))
            bad.push_back(l);
        for (const Interval& part : parts) out.intervals.push_back(part);
    }
    return bad;
}

// Refines the curves of contradictory lines. Near their crossings, the other lines are refined, too. The refined curves
// are at most `tolerance` pixels from the exact curves.
void refine_curves(const CountingInput& in, std::span<const std::int32_t> bad, double tolerance, Invisibility& out) {
    base::Array<std::int64_t> first(in.memory()); // for each subject: the index of its first point
    first.push_back(0);
    for (const Subject& subject : out.subjects) first.push_back(first.back() + subject.curves->point.size());
    base::Array<std::uint8_t> all_marked(in.memory(), first.back());
    const auto mark = [&](const Line& its, std::int64_t k) {
        if (its.closed) k = (k + its.pieces) % its.pieces;
        if (k >= 0 && k < its.pieces) all_marked[first[its.subject] + in.lines.pieces[its.first_piece + k].a] = 1;
    };
    const auto is_bad = [&](std::int32_t l) { return std::binary_search(bad.begin(), bad.end(), l); };
    for (const std::int32_t l : bad)
        for (std::int64_t k = 0; k < in.line(l).pieces; ++k) mark(in.line(l), k);
    for (const Crossing& c : out.crossings) {
        const std::int32_t far = in.lines.pieces[c.far_piece].line;
        const std::int32_t near = in.lines.pieces[c.near_piece].line;
        if (!is_bad(far) && !is_bad(near)) continue;
        for (int k = -visibility_tuning.pieces_beside_crossing; k <= visibility_tuning.pieces_beside_crossing; ++k) {
            mark(in.line(far), c.far_piece - in.line(far).first_piece + k);
            mark(in.line(near), c.near_piece - in.line(near).first_piece + k);
        }
    }
    for (std::int64_t s = 0; s < out.subjects.size(); ++s) {
        Subject& subject = out.subjects[s];
        const auto marked =
            std::as_const(all_marked)
                .span()
                .subspan(static_cast<std::size_t>(first[s]), static_cast<std::size_t>(first[s + 1] - first[s]));
        const bool is_any = std::any_of(marked.begin(), marked.end(), [](std::uint8_t m) { return m != 0; });
        if (subject.level == nullptr || !is_any) continue; // Polylines without a function cannot be made finer.
        std::int64_t evaluations = 0;
        auto& made = out.finer.add(std::make_unique<curves::Curves>(curves::finer_curves(
            in.work, *subject.level, subject.view, *subject.curves, marked, tolerance, evaluations)));
        subject.curves = made.get();
    }
}

// A group of cusps. `begin` and `end` are positions along the line, in pixels. On a closed line, `end` may be beyond
// the end of the line.
struct CuspGroup {
    double begin, end;
    double before, after; // the distances from the group to the cusp before it and to the cusp after it
    bool odd;
    std::size_t last; // the index of the last cusp in the events
};

// Finds the groups of two or more cusps. On a closed line, the search begins at a gap between groups, so that it
// divides no group.
base::Array<CuspGroup> find_groups(base::Memory& memory, std::span<const Event> events, bool closed, double whole,
                                   double size) {
    base::Array<std::size_t> cusps(memory);
    for (std::size_t i = 0; i < events.size(); ++i)
        if (events[i].near_piece < 0) cusps.push_back(i);
    base::Array<CuspGroup> groups(memory);
    const std::int64_t count = cusps.size();
    const auto at = [&](std::int64_t i) { return events[cusps[i % count]].at + (i >= count ? whole : 0.0); };
    const auto joined = [&](std::int64_t i) { return at(i + 1) - at(i) <= size; };
    curves::for_joined(count, closed, joined, [&](std::int64_t i, std::int64_t end, bool) {
        if (end - i < 2) return;
        const double before = i > 0 ? at(i) - at(i - 1) : closed ? at(i) + whole - at(count - 1) : whole;
        const double after = end < count || closed ? at(end) - at(end - 1) : whole;
        groups.push_back({at(i), at(end - 1), before, after, (end - i) % 2 != 0, cusps[(end - 1) % count]});
    });
    return groups;
}

// ---- The outline

// A place where another line crosses, and the change of the number of sheets beside the line there.
struct ChangeBeside {
    std::int32_t line;
    double at; // position along the line, in pixels
    std::int32_t change;
};

// Finds the places where the number of sheets beside a line changes. At a crossing, each of the two lines enters or
// leaves the image of the other line's surface.
base::Array<ChangeBeside> find_changes_beside(const CountingInput& in, const base::Array<Crossing>& crossings,
                                              std::span<const std::uint8_t> wanted) {
    base::Array<ChangeBeside> changes(in.memory());
    const auto add = [&](std::int32_t piece, double share, std::int32_t change) {
        const std::int32_t l = in.lines.pieces[piece].line;
        if (change != 0 && wanted[static_cast<std::size_t>(in.line(l).subject)] != 0)
            changes.push_back({l, in.lengths.at(in.line(l), piece, share), change});
    };
    for (const Crossing& c : crossings) {
        const auto is_turned = [&](std::int32_t number) {
            const Piece& piece = in.lines.pieces[number];
            return subject_of(in.subjects, piece).mirrored != shows_inside(in.subjects, piece);
        };
        add(c.far_piece, c.far_share, c.change);
        const bool left = (c.change > 0) != (is_turned(c.near_piece) != is_turned(c.far_piece));
        const std::int32_t sheets = subject_of(in.subjects, in.lines.pieces[c.far_piece]).sheet_change;
        add(c.near_piece, c.near_share, left ? -sheets : sheets);
    }
    std::sort(changes.begin(), changes.end(), [](const ChangeBeside& a, const ChangeBeside& b) {
        return std::tie(a.line, a.at, a.change) < std::tie(b.line, b.at, b.change);
    });
    return changes;
}

// Divides a visible part at the changes of its line, and adds the resulting parts, with sheet counts relative to the
// start of the line. An interval of a closed line may continue past the end of the line, so the changes are applied a
// second time.
void add_parts_beside(const CountingInput& in, const Interval& part, std::span<const ChangeBeside> changes,
                      base::Array<Interval>& stretches) {
    const Line& its = in.line(part.line);
    const double whole = in.lengths.total(its);
    Interval stretch = part;
    stretch.invisibility = 0;
    const auto add = [&](double end) {
        stretch.end_at = end;
        stretches.push_back(stretch);
        stretch.begin_at = end;
    };
    for (const double beyond : {0.0, whole}) {
        for (const ChangeBeside& c : changes) {
            if (c.at + beyond >= part.end_at) break;
            if (c.at + beyond > stretch.begin_at) add(c.at + beyond);
            stretch.invisibility += c.change;
        }
        if (!its.closed) break;
    }
    add(part.end_at);
}

} // namespace

Events collect_events(base::Memory& memory, std::span<const Subject> subjects, const ImageLines& lines,
                      const base::Array<Crossing>& crossings, std::span<const Piercing> pierced,
                      const LineLengths& lengths) {
    Events events(memory);
    std::int64_t c = 0;
    std::size_t next = 0;
    for (const Line& line : lines.lines) {
        events.first.push_back(events.event.size());
        const Subject& subject = subjects[static_cast<std::size_t>(line.subject)];
        const curves::Curves& curves = *subject.curves;
        for (std::int64_t k = 0; k < line.pieces; ++k) {
            const auto piece = static_cast<std::int32_t>(line.first_piece + k);
            const std::int64_t a = lines.pieces[piece].a;
            if (const curves::CurvePoint& p = curves.point[a]; p.is_cusp != 0 && (k > 0 || line.closed)) {
                const bool away = glm::dot(p.direction(), subject.view.sight(p.position)) > 0.0;
                events.event.push_back({piece, 0.0, away ? 1 : -1, -1, lengths.at(line, piece, 0.0), 0.0F});
                ++events.cusps;
            }
            const auto add_piercing = [&](double up_to) {
                for (; next < pierced.size() && pierced[next].piece == piece && pierced[next].share < up_to; ++next)
                    events.event.push_back({piece, pierced[next].share, pierced[next].change, no_line,
                                            lengths.at(line, piece, pierced[next].share), 0.0F});
            };
            for (; c < crossings.size() && crossings[c].far_piece == piece; ++c) {
                add_piercing(crossings[c].far_share);
                events.event.push_back({piece, crossings[c].far_share, crossings[c].change, crossings[c].near_piece,
                                        lengths.at(line, piece, crossings[c].far_share),
                                        static_cast<float>(crossings[c].sine), crossings[c].near_share});
            }
            add_piercing(2.0);
        }
    }
    // The assertion fails if crossings or piercings are not sorted.
    HRBFNPR_ASSERT(c == crossings.size() && next == pierced.size());
    events.first.push_back(events.event.size());
    return events;
}

base::Array<Event> without_torn_swallowtails(base::Memory& memory, const Line& line, const LineLengths& lengths,
                                             double size, std::span<const Event> events) {
    HRBFNPR_ASSERT(size > 0.0);
    HRBFNPR_ASSERT(std::is_sorted(events.begin(), events.end(), [](const Event& a, const Event& b) {
        return a.piece < b.piece || (a.piece == b.piece && a.share < b.share);
    }));
    const double whole = lengths.total(line);
    const auto is_cusp_of = [&](const CuspGroup& group, const Event& e) {
        const double low = group.begin - 1e-9 * size;
        const double high = group.end + 1e-9 * size;
        return e.near_piece < 0 && ((e.at >= low && e.at <= high) || (line.closed && e.at + whole <= high));
    };
    // Returns the distance along the line from the start of a group, the shorter way round on a closed line.
    const auto from_begin = [&](const CuspGroup& group, double at) {
        const double way = at - group.begin;
        return line.closed ? way - whole * std::round(way / whole) : way;
    };
    // Returns whether an event is a crossing of two branches of one group: a branch before the group, and a branch
    // after it or inside it. The loop of the crossing has only cusps of this group.
    const auto is_crossing_of = [&](const CuspGroup& group, const Event& e) {
        if (e.near_piece < line.first_piece || e.near_piece >= line.first_piece + line.pieces) return false;
        const double far = from_begin(group, e.at);
        const double near = from_begin(group, lengths.at(line, e.near_piece, e.near_share));
        const double length = group.end - group.begin;
        const double branch = visibility_tuning.branch_reach * size;
        const double first = std::min(far, near);
        const double last = std::max(far, near);
        return first > -std::min(group.before, branch) && first < length && last > 0.0 &&
               last < length + std::min(group.after, branch);
    };
    base::Array<CuspGroup> groups = find_groups(memory, events, line.closed, whole, size);
    // Returns whether the changes of a group are consistent: their sum must be 0, as on a smooth contour, or the change
    // of one cusp.
    const auto adds_up = [&](const CuspGroup& group) {
        std::int32_t change = group.odd ? -events[group.last].change : 0;
        for (const Event& e : events)
            if (is_cusp_of(group, e) || is_crossing_of(group, e)) change += e.change;
        return change == 0;
    };
    groups.resize(std::remove_if(groups.begin(), groups.end(), adds_up) - groups.begin());
    base::Array<Event> kept(memory);
    for (const Event& e : events) {
        const bool is_dropped = std::any_of(groups.begin(), groups.end(), [&](const CuspGroup& group) {
            return is_crossing_of(group, e) || (is_cusp_of(group, e) && !(group.odd && &events[group.last] == &e));
        });
        if (!is_dropped) kept.push_back(e);
    }
    return kept;
}

Invisibility find_invisibility(const base::Work& work, std::span<const Subject> subjects,
                               std::span<const Occluder> occluders, const InvisibilitySettings& settings) {
    HRBFNPR_ASSERT(settings.rounds > 0 && settings.probes > 0 && settings.tolerance > 0.0);
    Invisibility out(work.memory);
    for (const Subject& subject : subjects) out.subjects.push_back(subject);
    double tolerance = settings.tolerance;
    for (int r = 0; r < settings.rounds; ++r, tolerance *= visibility_tuning.round_factor) {
        const std::span<const Subject> now = std::as_const(out.subjects).span();
        out.lines = draw_lines(work, now, tolerance);
        out.piercings = find_piercings(work, now, occluders, out.lines);
        out.crossings = find_crossings(work, now, out.lines, out.report.crossings);
        const LineLengths lengths(work.memory, out.lines);
        const Events events = collect_events(work.memory, now, out.lines, out.crossings, out.piercings.span(), lengths);
        const CountingInput in{work, now, occluders, out.lines, lengths};
        const base::Array<std::int32_t> bad = count_along_lines(in, events, settings.probes, out);
        out.report.rounds = r;
        out.report.cusps = events.cusps;
        if (r == 0) out.report.refined = bad.size();
        if (bad.empty()) break;
        // Finer curves do not help where lines run over one another, or where a surface is torn.
        if (r + 1 == settings.rounds || out.report.crossings.tangles > 0 ||
            bad.size() > visibility_tuning.most_refined_lines) {
            out.report.contradictions =
                number_by_own_rays(in, false, bad.span(), out.intervals.span(), out.report.rays);
            out.report.settled = bad.size();
            break;
        }
        refine_curves(in, bad.span(),
                      visibility_tuning.refined_tolerance_share * visibility_tuning.round_factor * tolerance, out);
    }
    out.report.lines = out.lines.lines.size();
    for (const Line& l : out.lines.lines) out.report.closed += l.closed ? 1 : 0;
    return out;
}

void find_hidden_by(const base::Work& work, std::span<const Subject> subjects, std::span<const Occluder> occluders,
                    Invisibility& found) {
    const LineLengths lengths(work.memory, found.lines);
    const CountingInput in{work, subjects, occluders, found.lines, lengths};
    base::Array<Ray> rays(work.memory);
    base::Array<Interval*> asked(work.memory);
    for (Interval& part : found.intervals) {
        part.hidden_by =
            part.invisibility > 0 ? subjects[static_cast<std::size_t>(in.line(part.line).subject)].item : -1;
        if (part.invisibility <= 0 || occluders.size() < 2) continue;
        rays.push_back(best_ray(in, part));
        asked.push_back(&part);
    }
    if (rays.empty()) return;
    send_rays(in, false, rays);
    for (std::int64_t i = 0; i < rays.size(); ++i)
        if (rays[i].nearest >= 0) asked[i]->hidden_by = rays[i].nearest;
}

Outline find_outline(const base::Work& work, std::span<const Subject> subjects, std::span<const Occluder> occluders,
                     const Invisibility& found, const LineLengths& lengths, std::span<const std::uint8_t> wanted) {
    HRBFNPR_ASSERT(wanted.size() == subjects.size());
    const CountingInput in{work, subjects, occluders, found.lines, lengths};
    const base::Array<ChangeBeside> changes = find_changes_beside(in, found.crossings, wanted);
    const auto changes_of = [&](std::int32_t line) {
        const auto less = [](const ChangeBeside& a, const ChangeBeside& b) { return a.line < b.line; };
        const auto [first, end] = std::equal_range(changes.begin(), changes.end(), ChangeBeside{line, 0.0, 0}, less);
        return std::span<const ChangeBeside>(first, end);
    };
    base::Array<Interval> stretches(work.memory);
    for (const Interval& part : found.intervals)
        if (part.invisibility <= 0 && wanted[static_cast<std::size_t>(in.line(part.line).subject)] != 0)
            add_parts_beside(in, part, changes_of(part.line), stretches);
    base::Array<Ray> rays(work.memory);
    for_lines(stretches.span(),
              [&](std::span<Interval> of_line) { add_rays(in, of_line, visibility_tuning.outline_rays, rays); });
    send_rays(in, true, rays);
    base::Array<std::int32_t> bad(work.memory);
    for_lines(stretches.span(), [&](std::span<Interval> of_line) {
        const std::int32_t l = of_line[0].line;
        std::int32_t sum = 0;
        for (const ChangeBeside& c : changes_of(l)) sum += c.change;
        if (!set_invisibility(of_line, rays_of(rays, l), lengths.total(in.line(l))) || (sum != 0 && in.line(l).closed))
            bad.push_back(l);
    });
    Outline out(work.memory);
    out.rays = rays.size();
    out.settled = bad.size();
    number_by_own_rays(in, true, bad.span(), stretches.span(), out.rays);
    for (const Interval& s : stretches) {
        if (s.invisibility != 0) continue;
        OutlinePart* const last = out.parts.empty() ? nullptr : &out.parts.back();
        if (last != nullptr && last->line == s.line && last->end_at == s.begin_at)
            last->end_at = s.end_at;
        else
            out.parts.push_back({s.line, s.begin_at, s.end_at});
    }
    return out;
}

} // namespace hrbfnpr::visibility
