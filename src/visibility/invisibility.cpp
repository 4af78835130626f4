// SPDX-License-Identifier: MIT
#include "visibility/invisibility.h"

#include "visibility/probes.h"
#include "visibility/small_swallowtails.h"

#include <algorithm>
#pragma GCC diagnostic ignored "-Wold-style-cast"
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace hrbfnpr::visibility {
namespace {

constexpr double finer = 0.1;
constexpr double smallest_swallowtail = 0.25; // pixels along the line
constexpr double clear_sides = 0.02;          // beside a point of a contour the line of sight is tangent to the surface

// The events of all lines, line by line, along each.
struct Events {
    explicit Events(base::Memory& memory) noexcept : first(memory), event(memory) {}
    base::Array<std::int64_t> first; // of each line, and the end
    base::Array<Event> event;
};

class Round {
public:
    Round(const base::Runtime& runtime, std::span<const Subject> subjects, std::span<const Occluder> occluders,
          Invisibility& out)
        : runtime_(runtime), subjects_(subjects), occluders_(occluders), out_(out), events_(runtime.memory),
          length_(runtime.memory) {}

    // Returns how many lines contradict themselves.
    std::int64_t run(double tolerance, double swallowtail, int probes, const base::Progress& progress);
    // Each part of these lines as its own ray says.
    void settle(const base::Progress& progress);

private:
    // A vertex of a line, and the interval of it that it is in.
    struct Candidate {
        std::int64_t interval;
        double score;
        Probe probe;
    };

    [[nodiscard]] const Line& line(std::int64_t l) const noexcept { return out_.lines.lines[l]; }
    [[nodiscard]] const curves::Curves& curves_of(const Line& line) const noexcept {
        return *subjects_[static_cast<std::size_t>(line.subject)].curves;
    }
    void collect_events();
    void drop_small_swallowtails(double size);
    void make_intervals(std::int64_t l);
    void measure();
    [[nodiscard]] double length_at(std::int64_t piece, double share) const noexcept {
        return length_[piece] + share * (length_[piece + 1] - length_[piece]);
    }
    [[nodiscard]] Candidate best_of(std::int64_t interval) const noexcept;
    void add_probes(std::int64_t l, int most, base::Array<Candidate>& chosen) const;
    [[nodiscard]] bool propagate(std::int64_t l, std::span<const Candidate> probes);

    const base::Runtime& runtime_;
    std::span<const Subject> subjects_;
    std::span<const Occluder> occluders_;
    Invisibility& out_;
    Events events_;
    base::Array<double> length_; // of the image up to each piece, pixels; over all lines
    base::Array<std::int64_t> first_interval_{runtime_.memory};
    base::Array<std::uint8_t> contradicts_{runtime_.memory}; // of each line
};

void Round::measure() {
    length_.resize(out_.lines.pieces.size() + 1);
    std::fill(length_.begin(), length_.end(), 0.0);
    for (const Line& l : out_.lines.lines)
        for (std::int64_t p = l.first_point; p + 1 < l.first_point + l.points; ++p)
            length_[out_.lines.points[p].piece + 1] +=
                glm::distance(out_.lines.points[p].place, out_.lines.points[p + 1].place);
    for (std::int64_t i = 0; i + 1 < length_.size(); ++i) length_[i + 1] += length_[i];
}

void Round::collect_events() {
    events_.first.clear();
    events_.event.clear();
    out_.report.cusps = 0;
    std::int64_t c = 0;
    for (const Line& l : out_.lines.lines) {
        events_.first.push_back(events_.event.size());
        const curves::Curves& curves = curves_of(l);
        const curves::View& view = subjects_[static_cast<std::size_t>(l.subject)].view;
        for (std::int64_t k = 0; k < l.pieces; ++k) {
            const auto piece = static_cast<std::int32_t>(l.first_piece + k);
            const std::int64_t a = out_.lines.pieces[piece].a;
            if (!curves.cusp.empty() && curves.cusp[a] != 0 && (k > 0 || l.closed)) {
                const curves::CurvePoint& p = curves.point[a];
                const bool away = glm::dot(p.direction(), view.sight(p.position)) > 0.0;
                events_.event.push_back({piece, 0.0, away ? 1 : -1, -1});
                ++out_.report.cusps;
            }
            for (; c < out_.crossings.size() && out_.crossings[c].far_piece == piece; ++c) {
                const Crossing& crossing = out_.crossings[c];
                events_.event.push_back({piece, crossing.far_share, crossing.change, crossing.near_piece});
            }
        }
    }
    events_.first.push_back(events_.event.size());
}

// Swallowtails that are smaller than can be seen, and so small that the crossing of their branches may not have been
// found: together, two cusps and that crossing change nothing.  [Arnold 1986]
void Round::drop_small_swallowtails(double size) {
    Events kept(runtime_.memory);
    for (std::int64_t l = 0; l < out_.lines.lines.size(); ++l) {
        kept.first.push_back(kept.event.size());
        const std::span<const Event> all =
            events_.event.span().subspan(static_cast<std::size_t>(events_.first[l]),
                                         static_cast<std::size_t>(events_.first[l + 1] - events_.first[l]));
        SmallSwallowtails(runtime_.memory, line(l), length_, size).keep(all, kept.event);
    }
    kept.first.push_back(kept.event.size());
    events_ = std::move(kept);
}

// Of a closed line the last interval goes on to its first event.
void Round::make_intervals(std::int64_t l) {
    const Line& its = line(l);
    const std::int64_t begin = events_.first[l];
    const std::int64_t end = events_.first[l + 1];
    const auto number = static_cast<std::int32_t>(l);
    const auto first = static_cast<std::int32_t>(its.first_piece);
    const auto last = static_cast<std::int32_t>(its.first_piece + its.pieces - 1);
    Interval interval{number, first, last, 0.0, 1.0, 0};
    if (begin == end) {
        out_.intervals.push_back(interval);
        return;
    }
    const auto between = [&](const Event& a, const Event& b) {
        return Interval{number, a.piece, b.piece, a.share, b.share, 0};
    };
    if (!its.closed) {
        const Event& e = events_.event[begin];
        out_.intervals.push_back({number, first, e.piece, 0.0, e.share, 0});
    }
    for (std::int64_t e = begin; e + 1 < end; ++e)
        out_.intervals.push_back(between(events_.event[e], events_.event[e + 1]));
    const Event& e = events_.event[end - 1];
    if (its.closed)
        out_.intervals.push_back(between(e, events_.event[begin]));
    else
        out_.intervals.push_back({number, e.piece, last, e.share, 1.0, 0});
}

// The vertex of an interval that is farthest from its ends and where the surface bends most along the line of sight; a
// place of a cubic where there is no vertex.
Round::Candidate Round::best_of(std::int64_t number) const noexcept {
    const Interval& interval = out_.intervals[number];
    const Line& its = line(interval.line);
    const Subject& subject = subjects_[static_cast<std::size_t>(its.subject)];
    const curves::Curves& curves = *subject.curves;
    const double whole = length_[its.first_piece + its.pieces] - length_[its.first_piece];
    const double begin = length_at(interval.begin_piece, interval.begin_share);
    double size = length_at(interval.end_piece, interval.end_share) - begin;
    const bool round = its.closed && (size < 0.0 || events_.first[interval.line] == events_.first[interval.line + 1]);
    if (size < 0.0) size += whole;
    if (round && events_.first[interval.line] + 1 == events_.first[interval.line + 1]) size = whole;
    const bool all = events_.first[interval.line] == events_.first[interval.line + 1];
    Candidate best{number, -1.0, {its.subject, glm::dvec3(0.0), clear_sides * subject.side, 0, true}};
    const std::int64_t pieces = its.pieces;
    std::int64_t k = interval.begin_piece - its.first_piece;
    double at = begin;
    for (std::int64_t step = 0; step <= pieces; ++step) {
        at += length_[its.first_piece + k + 1] - (step == 0 ? begin : length_[its.first_piece + k]);
        k = (k + 1) % pieces;
        if (at - begin >= size && !all) break;
        if (!its.closed && k == 0) break;
        const curves::CurvePoint& p = curves.point[out_.lines.pieces[its.first_piece + k].a];
        const glm::dvec3 v = subject.view.sight(p.position);
        const double bend = std::abs(glm::dot(p.level_gradient, v)) / (glm::length(p.gradient) * glm::dot(v, v));
        const double clear = all ? 1.0 : std::min(at - begin, size - (at - begin));
        const double score = clear * std::min(1.0, 4.0 * subject.side * bend + 0.01);
        if (score > best.score) {
            best.score = score;
            best.probe.place = p.position;
        }
    }
    if (best.score < 0.0) {
        const bool same = interval.begin_piece == interval.end_piece && interval.begin_share <= interval.end_share;
        const double share =
            same ? 0.5 * (interval.begin_share + interval.end_share) : 0.5 * (interval.begin_share + 1.0);
        best.probe.place = cubic(subjects_, out_.lines.pieces[interval.begin_piece]).at(share);
        best.score = 1e-3 * size;
    }
    return best;
}

void Round::add_probes(std::int64_t l, int most, base::Array<Candidate>& chosen) const {
    base::Array<Candidate> all(runtime_.memory);
    for (std::int64_t i = first_interval_[l]; i < first_interval_[l + 1]; ++i) all.push_back(best_of(i));
    std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
        return a.score != b.score ? a.score > b.score : a.interval < b.interval;
    });
    for (std::int64_t i = 0; i < std::min<std::int64_t>(most, all.size()); ++i) chosen.push_back(all[i]);
}

// From the first probe that is certain along the line; the other certain ones, and the way round, must agree.
bool Round::propagate(std::int64_t l, std::span<const Candidate> probes) {
    const std::int64_t first = first_interval_[l];
    const std::int64_t count = first_interval_[l + 1] - first;
    const std::int64_t begin = events_.first[l];
    // An open line has an interval before its first event.
    const auto change_before = [&](std::int64_t i) {
        const std::int64_t e = begin + i - (line(l).closed ? 0 : 1);
        return e >= begin && e < events_.first[l + 1] ? events_.event[e].change : 0;
    };
    std::int32_t sheets = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        if (i > 0) sheets += change_before(i);
        out_.intervals[first + i].sheets = sheets;
    }
    const bool closes = !line(l).closed || sheets + change_before(0) == 0 || count == 0;
    std::int32_t shift = 0;
    bool known = false;
    bool agree = true;
    for (const Candidate& c : probes) {
        if (!c.probe.certain) continue;
        const std::int32_t here = c.probe.sheets - out_.intervals[c.interval].sheets;
        if (!known) shift = here;
        agree = agree && (!known || here == shift);
        known = true;
    }
    if (!known && !probes.empty()) shift = probes[0].probe.sheets - out_.intervals[probes[0].interval].sheets;
    bool possible = true;
    for (std::int64_t i = 0; i < count; ++i) {
        out_.intervals[first + i].sheets += shift;
        possible = possible && out_.intervals[first + i].sheets >= 0;
    }
    if (getenv("VDBG") && !(closes && agree && possible)) {
        fprintf(stderr,
                "  line %ld closed %d pieces %ld length %.2f events %ld closes %d(%d) agree %d possible %d probes:",
                (long)l, line(l).closed, (long)line(l).pieces,
                length_[line(l).first_piece + line(l).pieces] - length_[line(l).first_piece],
                (long)(events_.first[l + 1] - begin), closes, sheets + change_before(0), agree, possible);
        for (const Candidate& c : probes)
            fprintf(stderr, " [ray %d got %d %s score %.2f]", c.probe.sheets, out_.intervals[c.interval].sheets,
                    c.probe.certain ? "ok" : "unc", c.score);
        fprintf(stderr, "\n");
    }
    return closes && agree && possible;
}

std::int64_t Round::run(double tolerance, double swallowtail, int probes, const base::Progress& progress) {
    out_.lines = draw_lines(runtime_, subjects_, tolerance);
    out_.crossings = find_crossings(runtime_, subjects_, out_.lines, out_.report.crossings, progress);
    measure();
    collect_events();
    drop_small_swallowtails(swallowtail);
    out_.intervals.clear();
    first_interval_.clear();
    const std::int64_t lines = out_.lines.lines.size();
    for (std::int64_t l = 0; l < lines; ++l) {
        first_interval_.push_back(out_.intervals.size());
        make_intervals(l);
    }
    first_interval_.push_back(out_.intervals.size());
    base::Array<Candidate> chosen(runtime_.memory);
    base::Array<std::int64_t> first_probe(runtime_.memory);
    for (std::int64_t l = 0; l < lines; ++l) {
        first_probe.push_back(chosen.size());
        add_probes(l, probes, chosen);
    }
    first_probe.push_back(chosen.size());
    base::Array<Probe> rays(runtime_.memory);
    for (const Candidate& c : chosen) rays.push_back(c.probe);
    send_rays(runtime_, subjects_, occluders_, rays, progress);
    out_.report.rays += rays.size();
    for (std::int64_t i = 0; i < chosen.size(); ++i) chosen[i].probe = rays[i];
    contradicts_.resize(lines);
    std::int64_t bad = 0;
    for (std::int64_t l = 0; l < lines; ++l) {
        const std::int64_t from = first_probe[l];
        const std::span<const Candidate> its =
            chosen.span().subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(first_probe[l + 1] - from));
        contradicts_[l] = propagate(l, its) ? 0 : 1;
        bad += contradicts_[l];
    }
    return bad;
}

void Round::settle(const base::Progress& progress) {
    base::Array<Probe> rays(runtime_.memory);
    base::Array<std::int64_t> of(runtime_.memory);
    for (std::int64_t i = 0; i < out_.intervals.size(); ++i) {
        if (contradicts_[out_.intervals[i].line] == 0) continue;
        rays.push_back(best_of(i).probe);
        of.push_back(i);
    }
    send_rays(runtime_, subjects_, occluders_, rays, progress);
    out_.report.rays += rays.size();
    for (std::int64_t i = 0; i < of.size(); ++i) {
        if (getenv("VDBG")) {
            const Interval& iv = out_.intervals[of[i]];
            const Event* e = nullptr;
            for (std::int64_t k = events_.first[iv.line]; k < events_.first[iv.line + 1]; ++k)
                if (events_.event[k].piece == iv.begin_piece && events_.event[k].share == iv.begin_share)
                    e = &events_.event[k];
            const auto pl =
                see(subjects_[0].view, cubic(subjects_, out_.lines.pieces[iv.begin_piece]).at(iv.begin_share)).place;
            fprintf(stderr,
                    "    line %d from %d+%.4f at %.2f %.2f  event %d near %d  propagated %d ray %d %s score %.3f\n",
                    iv.line, iv.begin_piece, iv.begin_share, pl.x, pl.y, e ? e->change : 0, e ? e->near_piece : -9,
                    iv.sheets, rays[i].sheets, rays[i].certain ? "" : "unc", best_of(of[i]).score);
        }
        out_.intervals[of[i]].sheets = rays[i].sheets;
    }
}

} // namespace

Invisibility find_invisibility(const base::Runtime& runtime, std::span<const Subject> subjects,
                               std::span<const Occluder> occluders, const InvisibilitySettings& settings,
                               const base::Progress& progress) {
    Invisibility out(runtime.memory);
    Round round(runtime, subjects, occluders, out);
    std::int64_t bad = 0;
    double tolerance = settings.tolerance;
    double swallowtail = smallest_swallowtail;
    for (int r = 0; r < settings.rounds; ++r, tolerance *= finer, swallowtail *= 2.0) {
        bad = round.run(tolerance, swallowtail, settings.probes, progress);
        if (r == 0) out.report.refined = bad;
        out.report.rounds = r;
        if (bad == 0) break;
    }
    if (bad > 0) round.settle(progress);
    out.report.contradictions = bad;
    out.report.lines = out.lines.lines.size();
    for (const Line& l : out.lines.lines) out.report.closed += l.closed ? 1 : 0;
    return out;
}

} // namespace hrbfnpr::visibility
