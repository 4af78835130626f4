// SPDX-License-Identifier: MIT
#include "visibility/outline.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hrbfnpr::visibility {
namespace {

constexpr std::int64_t rays_a_line = 3;
// Shorter stretches are not asked for by rays of their own, pixels: they are as what comes before them.
constexpr double unseen = 0.25;

// Where another line crosses: how many sheets more there are beside the line from there on.
struct Change {
    std::int32_t line;
    double at; // pixels along it
    std::int32_t change;
};

// A visible part of a line that no other line crosses.
struct Stretch {
    std::int32_t line;
    double begin_at, end_at;
    std::int32_t beside; // sheets: relative to the line's begin, then in all
    double score;        // how good a place for a ray it has
    std::int32_t subject;
    glm::dvec3 place; // for the ray, in the subject's coordinates
    bool asked, certain;
    std::int32_t behind; // as the ray says
};

class OutlineFinder {
public:
    OutlineFinder(const base::Runtime& runtime, std::span<const Subject> subjects, std::span<const Occluder> occluders,
                  const Invisibility& found, const Lengths& lengths, std::span<const std::uint8_t> wanted,
                  const base::Progress& progress)
        : runtime_(runtime), subjects_(subjects), occluders_(occluders), found_(found), lengths_(lengths),
          wanted_(wanted), progress_(progress), changes_(runtime.memory), stretches_(runtime.memory),
          doubtful_(runtime.memory) {}

    void run(Outline& out);

private:
    [[nodiscard]] const Piece& piece(std::int32_t number) const noexcept { return found_.lines.pieces[number]; }
    [[nodiscard]] const Subject& subject_of(const Piece& p) const noexcept {
        return subjects_[static_cast<std::size_t>(p.subject)];
    }
    [[nodiscard]] const Line& line(std::int32_t number) const noexcept { return found_.lines.lines[number]; }
    [[nodiscard]] bool is_wanted(const Line& l) const noexcept {
        return wanted_[static_cast<std::size_t>(l.subject)] != 0;
    }
    void add_change(std::int32_t number, double share, std::int32_t change);
    void collect_changes();
    void add_stretches(const Interval& part);
    [[nodiscard]] std::int64_t piece_at(const Line& its, double at) const noexcept;
    void find_place(Stretch& stretch) const;
    template <class F>
    void for_lines(const F& f);
    void send(const base::Array<std::int64_t>& asked, Outline& out);
    void send_to(const Occluder& occluder, std::int32_t number, const base::Array<std::int64_t>& asked);
    void ask_best(Outline& out);
    [[nodiscard]] bool count(std::span<Stretch> stretches) noexcept;
    [[nodiscard]] const Change* changes_of(std::int32_t number) const noexcept;
    [[nodiscard]] bool closes(std::int32_t number) const noexcept;
    void settle(Outline& out);

    const base::Runtime& runtime_;
    std::span<const Subject> subjects_;
    std::span<const Occluder> occluders_;
    const Invisibility& found_;
    const Lengths& lengths_;
    std::span<const std::uint8_t> wanted_;
    const base::Progress& progress_;
    base::Array<Change> changes_;        // line by line, along it
    base::Array<Stretch> stretches_;     // the same
    base::Array<std::int64_t> doubtful_; // lines that contradict themselves
};

void OutlineFinder::add_change(std::int32_t number, double share, std::int32_t change) {
    const std::int32_t l = piece(number).line;
    if (change != 0 && is_wanted(line(l))) changes_.push_back({l, lengths_.at(line(l), number, share), change});
}

// Both lines that cross pass from what the other's surface does not reach to what it does, or back.
void OutlineFinder::collect_changes() {
    for (const Crossing& c : found_.crossings) {
        const Piece& near = piece(c.near_piece);
        const Piece& far = piece(c.far_piece);
        add_change(c.far_piece, c.far_share, c.change);
        const bool turns = (c.change > 0) != (subject_of(near).mirrored != shows_inside(subjects_, near));
        const bool left = !turns != (subject_of(far).mirrored != shows_inside(subjects_, far));
        add_change(c.near_piece, c.near_share, (left ? 1 : -1) * subject_of(far).sheets);
    }
    std::sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
        return std::tie(a.line, a.at, a.change) < std::tie(b.line, b.at, b.change);
    });
}

const Change* OutlineFinder::changes_of(std::int32_t number) const noexcept {
    const auto less = [](const Change& c, std::int32_t l) { return c.line < l; };
    return std::lower_bound(changes_.begin(), changes_.end(), number, less);
}

// Of a closed line an interval may go round its end: the changes before that come again.
void OutlineFinder::add_stretches(const Interval& part) {
    const Line& its = line(part.line);
    const double whole = lengths_.whole(its);
    const Change* const first = changes_of(part.line);
    std::int32_t beside = 0;
    double begin = part.begin_at;
    const auto add = [&](double end) {
        stretches_.push_back({part.line, begin, end, beside, -1.0, its.subject, glm::dvec3(0.0), false, false, 0});
        begin = end;
    };
    for (const bool again : {false, true}) {
        for (const Change* c = first; c != changes_.end() && c->line == part.line; ++c) {
            const double at = c->at + (again ? whole : 0.0);
            if (at >= part.end_at) break;
            if (at > begin) add(at);
            beside += c->change;
        }
        if (!its.closed) break;
    }
    add(part.end_at);
}

// The line's last piece that begins at or before a place.
std::int64_t OutlineFinder::piece_at(const Line& its, double at) const noexcept {
    std::int64_t low = 0;
    std::int64_t high = its.pieces;
    while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (lengths_.at(its, its.first_piece + middle, 0.0) <= at ? low : high) = middle;
    }
    return its.first_piece + low;
}

// The vertex that is farthest from the ends; where there is none, the middle.
void OutlineFinder::find_place(Stretch& stretch) const {
    const Line& its = line(stretch.line);
    const double whole = lengths_.whole(its);
    const Subject& subject = subjects_[static_cast<std::size_t>(its.subject)];
    double beyond = its.closed && stretch.begin_at >= whole ? whole : 0.0;
    const std::int64_t begin = piece_at(its, stretch.begin_at - beyond);
    const double from = lengths_.at(its, begin, 0.0) + beyond;
    std::int64_t p = begin;
    for (std::int64_t step = 0; step < its.pieces; ++step) {
        if (++p == its.first_piece + its.pieces) {
            if (!its.closed) break;
            p = its.first_piece;
            beyond += whole;
        }
        const double at = lengths_.at(its, p, 0.0) + beyond;
        if (at >= stretch.end_at) break;
        const double clear = std::min(at - stretch.begin_at, stretch.end_at - at);
        if (!(clear > stretch.score)) continue;
        stretch.score = clear;
        stretch.place = subject.curves->point[found_.lines.pieces[p].a].position;
    }
    if (stretch.score > 0.0) return;
    const double length = lengths_.at(its, begin, 1.0) - lengths_.at(its, begin, 0.0);
    const double middle = 0.5 * (stretch.begin_at + std::min(stretch.end_at, from + length)) - from;
    const double share = length > 0.0 ? std::clamp(middle / length, 0.0, 1.0) : 0.5;
    stretch.place = cubic(subjects_, found_.lines.pieces[begin]).at(share);
    stretch.score = 1e-3 * (stretch.end_at - stretch.begin_at);
}

template <class F>
void OutlineFinder::for_lines(const F& f) {
    for (std::int64_t first = 0; first < stretches_.size();) {
        std::int64_t end = first;
        while (end < stretches_.size() && stretches_[end].line == stretches_[first].line) ++end;
        f(first, end);
        first = end;
    }
}

// From behind all of the surface, as far as the eye is before it.
void OutlineFinder::send_to(const Occluder& occluder, std::int32_t number, const base::Array<std::int64_t>& asked) {
    const std::int64_t rays = asked.size();
    geometry::VecArray from(runtime_.memory, rays);
    geometry::VecArray to(runtime_.memory, rays);
    base::Array<double> clear(runtime_.memory, rays);
    base::Array<curves::SheetCounter::Answer> answers(runtime_.memory);
    const glm::dmat4 from_world = glm::inverse(occluder.to_world);
    for (std::int64_t i = 0; i < rays; ++i) {
        const Stretch& stretch = stretches_[asked[i]];
        const Subject& subject = subjects_[static_cast<std::size_t>(stretch.subject)];
        const bool own = subject.item == number;
        const glm::dvec3 place =
            own ? stretch.place : glm::dvec3(from_world * (subject.to_world * glm::dvec4(stretch.place, 1.0)));
        const glm::dvec3 sight = occluder.eye.w != 0.0 ? place - glm::dvec3(occluder.eye) : glm::dvec3(occluder.eye);
        const double reach =
            glm::distance(occluder.surface->bounds().centre(), place) + 2.0 * occluder.surface->diagonal();
        from.set(i, place + reach * glm::normalize(sight));
        to.set(i, place);
        clear[i] = own ? subject.clear * subject.side : 0.0;
    }
    occluder.sheets->count(runtime_, *occluder.surface, from, to, clear, answers, progress_);
    for (std::int64_t i = 0; i < rays; ++i) {
        Stretch& stretch = stretches_[asked[i]];
        stretch.behind += answers[i].sheets;
        stretch.certain = stretch.certain && answers[i].certain;
    }
}

void OutlineFinder::send(const base::Array<std::int64_t>& asked, Outline& out) {
    for (const std::int64_t s : asked) {
        stretches_[s].behind = 0;
        stretches_[s].asked = stretches_[s].certain = true;
    }
    for (std::size_t o = 0; o < occluders_.size(); ++o) send_to(occluders_[o], static_cast<std::int32_t>(o), asked);
    out.rays += asked.size();
}

void OutlineFinder::ask_best(Outline& out) {
    base::Array<std::int64_t> asked(runtime_.memory);
    base::Array<std::int64_t> best(runtime_.memory);
    for_lines([&](std::int64_t first, std::int64_t end) {
        best.clear();
        for (std::int64_t s = first; s < end; ++s) best.push_back(s);
        std::sort(best.begin(), best.end(), [&](std::int64_t a, std::int64_t b) {
            return stretches_[a].score != stretches_[b].score ? stretches_[a].score > stretches_[b].score : a < b;
        });
        for (std::int64_t i = 0; i < std::min(rays_a_line, best.size()); ++i) asked.push_back(best[i]);
    });
    send(asked, out);
}

// All changes round a closed line add up to 0.
bool OutlineFinder::closes(std::int32_t number) const noexcept {
    std::int32_t sum = 0;
    for (const Change* c = changes_of(number); c != changes_.end() && c->line == number; ++c) sum += c->change;
    return sum == 0 || !line(number).closed;
}

// From relative numbers to all; false: rays or signs contradict them.
bool OutlineFinder::count(std::span<Stretch> stretches) noexcept {
    std::int32_t shift = 0;
    bool known = false;
    bool agree = true;
    for (const Stretch& s : stretches) {
        if (!s.asked || !s.certain) continue;
        const std::int32_t here = s.behind - s.beside;
        if (!known) shift = here;
        agree = agree && here == shift;
        known = true;
    }
    for (Stretch& s : stretches) {
        s.beside += shift;
        agree = agree && s.beside >= 0;
    }
    return known && agree && closes(stretches[0].line);
}

// What is too short to be asked is as the stretch before it.
void OutlineFinder::settle(Outline& out) {
    const auto is_doubtful = [&](const Stretch& s) {
        return std::binary_search(doubtful_.begin(), doubtful_.end(), std::int64_t{s.line});
    };
    base::Array<std::int64_t> asked(runtime_.memory);
    for (std::int64_t s = 0; s < stretches_.size(); ++s)
        if (is_doubtful(stretches_[s]) && stretches_[s].end_at - stretches_[s].begin_at > unseen) asked.push_back(s);
    out.settled = doubtful_.size();
    if (asked.empty()) return;
    send(asked, out);
    for (const std::int64_t s : asked)
        if (stretches_[s].certain) stretches_[s].beside = stretches_[s].behind;
    for (std::int64_t s = 1; s < stretches_.size(); ++s)
        if (is_doubtful(stretches_[s]) && stretches_[s].end_at - stretches_[s].begin_at <= unseen &&
            stretches_[s - 1].line == stretches_[s].line)
            stretches_[s].beside = stretches_[s - 1].beside;
}

void OutlineFinder::run(Outline& out) {
    collect_changes();
    for (const Interval& part : found_.intervals)
        if (part.sheets <= 0 && is_wanted(line(part.line))) add_stretches(part);
    for (Stretch& stretch : stretches_) find_place(stretch);
    ask_best(out);
    for_lines([&](std::int64_t first, std::int64_t end) {
        const auto from = static_cast<std::size_t>(first);
        if (!count(stretches_.span().subspan(from, static_cast<std::size_t>(end) - from)))
            doubtful_.push_back(stretches_[first].line);
    });
    settle(out);
    for (const Stretch& s : stretches_) {
        if (s.beside != 0) continue;
        OutlinePart* const last = out.parts.empty() ? nullptr : &out.parts.back();
        if (last != nullptr && last->line == s.line && last->end_at == s.begin_at)
            last->end_at = s.end_at;
        else
            out.parts.push_back({s.line, s.begin_at, s.end_at});
    }
}

} // namespace

Outline find_outline(const base::Runtime& runtime, std::span<const Subject> subjects,
                     std::span<const Occluder> occluders, const Invisibility& found, const Lengths& lengths,
                     std::span<const std::uint8_t> wanted, const base::Progress& progress) {
    Outline out(runtime.memory);
    OutlineFinder(runtime, subjects, occluders, found, lengths, wanted, progress).run(out);
    return out;
}

} // namespace hrbfnpr::visibility
