// SPDX-License-Identifier: MIT
#include "visibility/invisibility.h"

#include "curves/curve_changes.h"
#include "visibility/probes.h"
#include "visibility/small_swallowtails.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hrbfnpr::visibility {
namespace {

constexpr double finer = 0.1; // tolerance from round to round
// Groups of cusps are seen as one within so many pixels along a line: what adds up first is taken.  The larger ones in
// the last round only: two wrong groups may add up as well.
constexpr std::array<double, 5> swallowtails = {0.25, 0.0, 0.5, 1.0, 2.0};
constexpr std::size_t first_sizes = 2;
// One more ray for so many events of a line, so that no long part of it goes unasked.
constexpr std::int64_t events_a_ray = 8;
constexpr std::int64_t most_rays = 48;
// Where the surface bends less along the line of sight, a ray to the contour is less certain.  In 1 / sides.
constexpr double bent = 0.25;
// A ray ends so far before its place, in sides and for the same bend, and of the depth of a line with cusps: near a
// cusp, and all along a line that has just been born, the sheet that hides it is near.
constexpr double clear_of_bent = 0.25;
constexpr double clear_of_depth = 0.1;
constexpr double least_clear = 3e-4; // in sides: places are off the surface by 1e-6
// Pieces of curves that are made finer: in pixels, and how far from the eye in sides.
constexpr double reach = 1e4;
constexpr double longest_piece = 1e3;
constexpr double from_eye = 2.0;
// Of the image's tolerance: how far curves that are made finer may be off.
constexpr double off_curve = 0.2;
// Of all lines, and at least so many: where more contradict themselves it is not for the curves' tolerance.
constexpr double most_torn = 0.1;
constexpr double least_torn = 50.0;
// Pieces of a curve before and after one with a crossing that are made finer with it.
constexpr std::int64_t beside_crossing = 2;

// A place of a line that a ray is sent to.
struct Candidate {
    double at; // along the line, pixels
    double score;
    Probe probe;
};

// The parts of a line between its events.
base::Array<Interval> parts_of(base::Memory& memory, std::int64_t number, const Line& line, double whole,
                               std::span<const Event> events) {
    base::Array<Interval> parts(memory);
    const auto l = static_cast<std::int32_t>(number);
    const auto first = static_cast<std::int32_t>(line.first_piece);
    const auto last = static_cast<std::int32_t>(line.first_piece + line.pieces - 1);
    const auto is_cusp = [](const Event& e) { return e.near_piece < 0 && e.change != 0; };
    const auto add = [&](const Event& from, const Event& to, double beyond) {
        parts.push_back({l, from.piece, to.piece, from.share, to.share, from.at, to.at + beyond, 0, is_cusp(from),
                         is_cusp(to), from.sine, to.sine});
    };
    const Event begin{first, 0.0, 0, -1, 0.0};
    const Event end{last, 1.0, 0, -1, whole};
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

class Round {
public:
    Round(const base::Runtime& runtime, std::span<const Occluder> occluders, double tolerance, Invisibility& out,
          const base::Progress& progress)
        : runtime_(runtime), subjects_(std::as_const(out.subjects).span()), occluders_(occluders), out_(out),
          progress_(progress), lengths_(start(tolerance)),
          events_(collect_events(runtime.memory, subjects_, out.lines, out.crossings, out.pierced.span(), lengths_)),
          depth_(runtime.memory), chosen_(runtime.memory), first_chosen_(runtime.memory), bad_(runtime.memory) {
        out_.report.cusps = events_.cusps;
        measure_depths();
    }

    // Returns how many lines contradict themselves.
    std::int64_t run(int probes);
    // For the last round: larger groups of cusps, and then each part of lines that contradict themselves still as its
    // own ray says.
    void settle();
    // Makes their curves finer, and those of lines that cross them: off by the tolerance at most, pixels.  After this
    // the round is over.
    void refine(double tolerance);

private:
    [[nodiscard]] Lengths start(double tolerance);
    [[nodiscard]] const Line& line(std::int64_t l) const noexcept { return out_.lines.lines[l]; }
    void measure_depths();
    [[nodiscard]] bool has_cusp(std::int64_t l) const noexcept {
        const std::span<const Event> of = events_.of(l);
        return std::any_of(of.begin(), of.end(), [](const Event& e) { return e.near_piece < 0; });
    }
    [[nodiscard]] double clear_of(std::int64_t l, const Subject& subject, double bend) const noexcept;
    [[nodiscard]] Candidate best_of(const Interval& part) const noexcept;
    void choose_probes(std::int64_t l, std::int64_t most);
    void send();
    [[nodiscard]] bool consistent(std::int64_t l, base::Array<Interval>& parts, std::span<const Event> events) const;
    void find_parts(std::int64_t l, std::span<const double> sizes);
    void find_parts(std::span<const double> sizes);
    [[nodiscard]] bool is_bad(std::int64_t l) const noexcept { return std::binary_search(bad_.begin(), bad_.end(), l); }
    void mark(const base::Array<std::int64_t>& first, base::Array<std::uint8_t>& marked) const;
    [[nodiscard]] bool is_in_reach(const Piece& piece) const noexcept;

    const base::Runtime& runtime_;
    std::span<const Subject> subjects_;
    std::span<const Occluder> occluders_;
    Invisibility& out_;
    const base::Progress& progress_;
    Lengths lengths_;
    Events events_;
    base::Array<double> depth_; // of each line, along a line of sight to it
    base::Array<Candidate> chosen_;
    base::Array<std::int64_t> first_chosen_; // of each line, and the end
    base::Array<std::int64_t> bad_;          // lines that contradict themselves
};

Lengths Round::start(double tolerance) {
    out_.lines = draw_lines(runtime_, subjects_, tolerance);
    out_.pierced = find_pierced(runtime_, subjects_, occluders_, out_.lines, progress_);
    out_.crossings = find_crossings(runtime_, subjects_, out_.lines, out_.report.crossings, progress_);
    return {runtime_.memory, out_.lines};
}

void Round::measure_depths() {
    for (const Line& its : out_.lines.lines) {
        const Subject& subject = subjects_[static_cast<std::size_t>(its.subject)];
        const auto place = [&](std::int64_t k) {
            return subject.curves->point[out_.lines.pieces[its.first_piece + k].a].position;
        };
        const glm::dvec3 sight = glm::normalize(subject.view.sight(place(0)));
        double least = 0.0;
        double most = 0.0;
        for (std::int64_t k = 1; k < its.pieces; ++k) {
            const double at = glm::dot(place(k) - place(0), sight);
            least = std::min(least, at);
            most = std::max(most, at);
        }
        depth_.push_back(most - least);
    }
}

double Round::clear_of(std::int64_t l, const Subject& subject, double bend) const noexcept {
    double clear = std::min(subject.clear, clear_of_bent * subject.side * bend);
    if (has_cusp(l)) clear = std::min(clear, clear_of_depth * depth_[l] / subject.side);
    return subject.side * std::max(clear, least_clear);
}

// The vertex of a part that is farthest from its ends and where the surface bends most along the line of sight; a place
// of a cubic where there is no vertex.
Candidate Round::best_of(const Interval& part) const noexcept {
    const Line& its = line(part.line);
    const Subject& subject = subjects_[static_cast<std::size_t>(its.subject)];
    Candidate best{0.5 * (part.begin_at + part.end_at),
                   -1.0,
                   {its.subject, glm::dvec3(0.0), subject.clear * subject.side, 0, true}};
    const double whole = lengths_.whole(its);
    const bool all = its.closed && part.end_at - part.begin_at >= whole;
    std::int64_t k = part.begin_piece - its.first_piece;
    double beyond = 0.0; // whole, once the line has begun again
    for (std::int64_t step = 0; step < its.pieces; ++step) {
        if (++k == its.pieces) {
            if (!its.closed) break;
            k = 0;
            beyond = whole;
        }
        const std::int64_t piece = its.first_piece + k;
        const double at = lengths_.at(its, piece, 0.0) + beyond;
        if (at >= part.end_at && !all) break;
        const curves::CurvePoint& p = subject.curves->point[out_.lines.pieces[piece].a];
        const glm::dvec3 v = subject.view.sight(p.position);
        const double bend = std::abs(glm::dot(p.level_gradient, v)) / (glm::length(p.gradient) * glm::dot(v, v));
        const double clear = all ? 1.0 : std::min(at - part.begin_at, part.end_at - at);
        const double score = clear * std::min(1.0, subject.side * bend / bent + 0.01);
        if (!(score > best.score)) continue;
        best.score = score;
        best.at = at >= whole && its.closed ? at - whole : at;
        best.probe.place = p.position;
        if (subject.level != nullptr) best.probe.clear = clear_of(part.line, subject, bend);
    }
    if (best.score >= 0.0) return best;
    const bool one = part.begin_piece == part.end_piece && part.begin_share <= part.end_share;
    const double share = 0.5 * (part.begin_share + (one ? part.end_share : 1.0));
    best.at = lengths_.at(its, part.begin_piece, share);
    best.probe.place = cubic(subjects_, out_.lines.pieces[part.begin_piece]).at(share);
    best.score = 1e-3 * (part.end_at - part.begin_at);
    return best;
}

void Round::choose_probes(std::int64_t l, std::int64_t most) {
    base::Array<Event> clear(runtime_.memory);
    SmallSwallowtails(runtime_.memory, line(l), lengths_, swallowtails[0]).keep(events_.of(l), clear);
    base::Array<Candidate> all(runtime_.memory);
    for (const Interval& part : parts_of(runtime_.memory, l, line(l), lengths_.whole(line(l)), clear.span()))
        all.push_back(best_of(part));
    std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
        return a.score != b.score ? a.score > b.score : a.at < b.at;
    });
    for (std::int64_t i = 0; i < std::min(most, all.size()); ++i) chosen_.push_back(all[i]);
}

void Round::send() {
    base::Array<Probe> rays(runtime_.memory);
    for (const Candidate& c : chosen_) rays.push_back(c.probe);
    send_rays(runtime_, subjects_, occluders_, rays, progress_);
    out_.report.rays += rays.size();
    for (std::int64_t i = 0; i < chosen_.size(); ++i) chosen_[i].probe = rays[i];
}

// Counts along the line, and from its rays.  The changes round a closed line must add up to 0, all certain rays must
// agree, and no count may be negative.
bool Round::consistent(std::int64_t l, base::Array<Interval>& parts, std::span<const Event> events) const {
    // The first part of a closed line begins at its first event, that of an open one before it.
    const bool closed = line(l).closed;
    std::int32_t sheets = 0;
    for (std::int64_t i = 0; i < parts.size(); ++i) {
        if (i > 0) sheets += events[static_cast<std::size_t>(closed ? i : i - 1)].change;
        parts[i].sheets = sheets;
    }
    const bool closes = !closed || events.empty() || sheets + events[0].change == 0;
    const double whole = lengths_.whole(line(l));
    const auto counted = [&](double at) {
        for (const Interval& part : parts)
            if ((at >= part.begin_at && at <= part.end_at) || at + whole <= part.end_at) return part.sheets;
        return parts[0].sheets;
    };
    // Where none is certain, all that there are.
    const std::span<const Candidate> rays = std::as_const(chosen_).span().subspan(
        static_cast<std::size_t>(first_chosen_[l]), static_cast<std::size_t>(first_chosen_[l + 1] - first_chosen_[l]));
    const bool all = std::none_of(rays.begin(), rays.end(), [](const Candidate& c) { return c.probe.certain; });
    std::int32_t shift = 0;
    bool known = false;
    bool agree = true;
    for (const Candidate& c : rays) {
        if (!c.probe.certain && !all) continue;
        const std::int32_t here = c.probe.sheets - counted(c.at);
        if (!known) shift = here;
        agree = agree && here == shift;
        known = true;
    }
    bool possible = known;
    for (Interval& part : parts) {
        part.sheets += shift;
        possible = possible && part.sheets >= 0;
    }
    return closes && agree && possible;
}

void Round::find_parts(std::int64_t l, std::span<const double> sizes) {
    base::Array<Interval> taken(runtime_.memory);
    bool right = false;
    for (const double size : sizes) {
        base::Array<Event> events(runtime_.memory);
        SmallSwallowtails(runtime_.memory, line(l), lengths_, size).keep(events_.of(l), events);
        base::Array<Interval> parts = parts_of(runtime_.memory, l, line(l), lengths_.whole(line(l)), events.span());
        right = consistent(l, parts, events.span());
        if (right || taken.empty()) taken = std::move(parts);
        if (right) break;
    }
    if (!right) bad_.push_back(l);
    for (const Interval& part : taken) out_.intervals.push_back(part);
}

void Round::find_parts(std::span<const double> sizes) {
    out_.intervals.clear();
    bad_.clear();
    for (std::int64_t l = 0; l < out_.lines.lines.size(); ++l) find_parts(l, sizes);
}

std::int64_t Round::run(int probes) {
    const std::int64_t lines = out_.lines.lines.size();
    for (std::int64_t l = 0; l < lines; ++l) {
        first_chosen_.push_back(chosen_.size());
        const auto events = static_cast<std::int64_t>(events_.of(l).size());
        choose_probes(l, std::min(most_rays, probes + events / events_a_ray));
    }
    first_chosen_.push_back(chosen_.size());
    send();
    find_parts(std::span<const double>(swallowtails).first(first_sizes));
    return bad_.size();
}

// Beside an eye that is on the surface images have no end.
bool Round::is_in_reach(const Piece& piece) const noexcept {
    const Subject& subject = subjects_[static_cast<std::size_t>(piece.subject)];
    const glm::dvec3 a = subject.curves->point[piece.a].position;
    const glm::dvec3 b = subject.curves->point[piece.b].position;
    const glm::dvec2 image = see(subject.view, a).place;
    return subject.view.eye.w == 0.0 ||
           (std::min(glm::length(subject.view.sight(a)), glm::length(subject.view.sight(b))) >
                from_eye * subject.side &&
            glm::length(image) < reach && glm::distance(image, see(subject.view, b).place) < longest_piece);
}

// Pieces of curves that may be why lines contradict themselves; first: of each subject's points.
void Round::mark(const base::Array<std::int64_t>& first, base::Array<std::uint8_t>& marked) const {
    const auto mark_piece = [&](const Line& its, std::int64_t k) {
        if (subjects_[static_cast<std::size_t>(its.subject)].level == nullptr) return; // it is as fine as can be
        if (its.closed) k = (k + its.pieces) % its.pieces;
        if (k < 0 || k >= its.pieces) return;
        const Piece& piece = out_.lines.pieces[its.first_piece + k];
        if (is_in_reach(piece)) marked[first[its.subject] + piece.a] = 1;
    };
    for (const std::int64_t l : bad_)
        for (std::int64_t k = 0; k < line(l).pieces; ++k) mark_piece(line(l), k);
    for (const Crossing& c : out_.crossings) {
        const std::int32_t far = out_.lines.pieces[c.far_piece].line;
        const std::int32_t near = out_.lines.pieces[c.near_piece].line;
        if (!is_bad(far) && !is_bad(near)) continue;
        for (std::int64_t k = -beside_crossing; k <= beside_crossing; ++k) {
            mark_piece(line(far), c.far_piece - line(far).first_piece + k);
            mark_piece(line(near), c.near_piece - line(near).first_piece + k);
        }
    }
}

void Round::refine(double tolerance) {
    base::Array<std::int64_t> first(runtime_.memory);
    first.push_back(0);
    for (const Subject& subject : out_.subjects) first.push_back(first.back() + subject.curves->point.size());
    base::Array<std::uint8_t> all_marked(runtime_.memory, first.back());
    mark(first, all_marked);
    for (std::int64_t s = 0; s < out_.subjects.size(); ++s) {
        Subject& subject = out_.subjects[s];
        const auto marked =
            std::as_const(all_marked)
                .span()
                .subspan(static_cast<std::size_t>(first[s]), static_cast<std::size_t>(first[s + 1] - first[s]));
        if (std::none_of(marked.begin(), marked.end(), [](std::uint8_t m) { return m != 0; })) continue;
        std::int64_t evaluations = 0;
        auto& made = out_.finer.add(std::make_unique<curves::Curves>(curves::finer_curves(
            runtime_, *subject.level, subject.view, *subject.curves, marked, tolerance, evaluations, progress_)));
        subject.curves = made.get();
    }
}

void Round::settle() {
    find_parts(swallowtails);
    base::Array<Probe> rays(runtime_.memory);
    base::Array<std::int64_t> of(runtime_.memory);
    for (std::int64_t i = 0; i < out_.intervals.size(); ++i) {
        if (!is_bad(out_.intervals[i].line)) continue;
        rays.push_back(best_of(out_.intervals[i]).probe);
        of.push_back(i);
    }
    send_rays(runtime_, subjects_, occluders_, rays, progress_);
    out_.report.rays += rays.size();
    out_.report.settled = bad_.size();
    std::int32_t last = -1;
    for (std::int64_t i = 0; i < of.size(); ++i) {
        Interval& part = out_.intervals[of[i]];
        if (rays[i].certain)
            part.sheets = rays[i].sheets;
        else if (part.end_at - part.begin_at > swallowtails[0] && last != part.line) {
            ++out_.report.contradictions;
            last = part.line;
        }
    }
}

} // namespace

Invisibility find_invisibility(const base::Runtime& runtime, std::span<const Subject> subjects,
                               std::span<const Occluder> occluders, const InvisibilitySettings& settings,
                               const base::Progress& progress) {
    Invisibility out(runtime.memory);
    for (const Subject& subject : subjects) out.subjects.push_back(subject);
    double tolerance = settings.tolerance;
    for (int r = 0; r < settings.rounds; ++r, tolerance *= finer) {
        Round round(runtime, occluders, tolerance, out, progress);
        const std::int64_t bad = round.run(settings.probes);
        out.report.rounds = r;
        if (r == 0) out.report.refined = bad;
        if (bad == 0) break;
        // What is finer does not disentangle lines over one another, nor mend a torn surface.
        const double torn = std::max(least_torn, most_torn * static_cast<double>(out.lines.lines.size()));
        if (r + 1 == settings.rounds || out.report.crossings.tangles > 0 || static_cast<double>(bad) > torn) {
            round.settle();
            break;
        }
        round.refine(off_curve * finer * tolerance);
    }
    out.report.lines = out.lines.lines.size();
    for (const Line& l : out.lines.lines) out.report.closed += l.closed ? 1 : 0;
    return out;
}

} // namespace hrbfnpr::visibility
