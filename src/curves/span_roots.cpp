// SPDX-License-Identifier: MIT
#include "curves/span_roots.h"

#include "implicit/evaluate_all.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::curves {
namespace {

// In diagonals: a place that is nearer to the surface is on it as far as f can be trusted, at an end of the segment;
// and elsewhere the segment touches the surface there if it runs along it.  Prepared values are off by some 1e-9.
constexpr double noise = 1e-9;
constexpr double touch = 2e-8;
// The sine of the angle to the surface below which a segment runs along it; and of one that tells, at an end on the
// surface, on which side the segment is.
constexpr double along_surface = 0.02;
constexpr double leaves_surface = 1e-4;
constexpr int deepest_span = 40;

// A place on a line: f, its slope along the line, and the length of its gradient.
struct Place {
    double at, value, slope, gradient;

    [[nodiscard]] bool finite() const noexcept {
        return std::isfinite(value) && std::isfinite(slope) && std::isfinite(gradient);
    }
    [[nodiscard]] bool negative() const noexcept { return value < 0.0; }
};

// Between two places of a span.
struct Piece {
    Place low, high;
    std::int64_t span;
    int depth;
};

// The least value of the cubic with the ends' values and slopes, for values that are positive there.
struct Least {
    double at; // in (0, 1); else it is at an end
    double value;
};

Least least_of_cubic(double f0, double d0, double f1, double d1) noexcept {
    const double third = 2.0 * (f0 - f1) + d0 + d1;
    const double second = 3.0 * (f1 - f0) - 2.0 * d0 - d1;
    const double root = second * second - 3.0 * third * d0; // of the derivative d0 + 2 second t + 3 third t^2
    if (!(root >= 0.0)) return {0.0, f0};
    // The root at which the derivative rises, written so that nothing cancels.
    const double t = second > 0.0 ? -d0 / (second + std::sqrt(root)) : (std::sqrt(root) - second) / (3.0 * third);
    if (!(t > 0.0 && t < 1.0)) return {0.0, f0};
    return {t, f0 + t * (d0 + t * (second + t * third))};
}

class Counter {
public:
    Counter(const base::Runtime& runtime, const implicit::Implicit& implicit, const base::Array<Line>& lines,
            const Spans& spans, base::Array<RootCount>& count, base::Array<Root>* roots)
        : runtime_(runtime), implicit_(implicit), lines_(lines), spans_(spans), count_(count), roots_(roots),
          piece_(runtime.memory), next_(runtime.memory), place_(runtime.memory), point_(runtime.memory),
          value_(runtime.memory), gradient_(runtime.memory) {}

    void run(const base::Progress& progress);

private:
    void start(const base::Progress& progress);
    void go_on(const base::Progress& progress);
    void evaluate(const base::Progress& progress);
    [[nodiscard]] Place place(std::int64_t i, const Line& line, double at) const noexcept;
    void settle_end(std::int64_t span, Place& end, double way) noexcept;
    void judge(const Piece& piece);
    void add_root(const Piece& piece);
    void split(const Piece& piece, double at);
    void take(const Piece& piece, const Place& middle);
    [[nodiscard]] bool touches(const Place& at) const noexcept {
        return std::abs(at.value) <= touch * implicit_.diagonal() * at.gradient &&
               std::abs(at.slope) <= along_surface * at.gradient;
    }

    const base::Runtime& runtime_;
    const implicit::Implicit& implicit_;
    const base::Array<Line>& lines_;
    const Spans& spans_;
    base::Array<RootCount>& count_;
    base::Array<Root>* roots_;
    base::Array<Piece> piece_, next_; // to be split
    base::Array<double> place_;       // where
    geometry::VecArray point_;
    base::Array<double> value_;
    geometry::VecArray gradient_;
};

void Counter::evaluate(const base::Progress& progress) {
    value_.resize(point_.size());
    gradient_.resize(point_.size());
    implicit::evaluate_all(runtime_, implicit_, point_,
                           {value_.data(), {gradient_.x.data(), gradient_.y.data(), gradient_.z.data()}, {}},
                           progress.part(0.0, 0.0));
}

Place Counter::place(std::int64_t i, const Line& line, double at) const noexcept {
    const glm::dvec3 gradient = gradient_[i];
    return {at, value_[i], glm::dot(gradient, line.direction), glm::length(gradient)};
}

// Where the segment ends on the surface, what counts is f just before: its slope tells.
void Counter::settle_end(std::int64_t span, Place& end, double way) noexcept {
    if (!(std::abs(end.value) <= noise * implicit_.diagonal() * end.gradient)) return;
    if (!(std::abs(end.slope) > leaves_surface * end.gradient)) count_[span].certain = false;
    end.value = std::copysign(std::numeric_limits<double>::min(), way * end.slope);
}

void Counter::judge(const Piece& piece) {
    const Place& a = piece.low;
    const Place& b = piece.high;
    RootCount& count = count_[piece.span];
    if (!a.finite() || !b.finite()) {
        count.certain = false;
        return;
    }
    const double length = b.at - a.at;
    if (a.negative() != b.negative()) {
        // The cubic with these values and slopes is monotone: one root.  [Fritsch & Carlson 1980]
        const double rise = b.value - a.value;
        const double first = length * a.slope / rise;
        const double last = length * b.slope / rise;
        if (first >= 0.0 && first <= 3.0 && last >= 0.0 && last <= 3.0)
            add_root(piece);
        else
            split(piece, 0.5);
        return;
    }
    const double sign = a.negative() ? -1.0 : 1.0;
    const double d0 = sign * length * a.slope;
    const double d1 = sign * length * b.slope;
    // The control values of the cubic: it is above the least of them.
    if (sign * a.value + d0 / 3.0 > 0.0 && sign * b.value - d1 / 3.0 > 0.0) return;
    const Least least = least_of_cubic(sign * a.value, d0, sign * b.value, d1);
    if (least.value > 0.5 * std::min(sign * a.value, sign * b.value)) return;
    split(piece, std::clamp(least.at, 0.05, 0.95));
}

void Counter::add_root(const Piece& piece) {
    ++count_[piece.span].roots;
    if (roots_ == nullptr) return;
    const double share = piece.low.value / (piece.low.value - piece.high.value);
    roots_->push_back({piece.span, piece.low.at, piece.high.at, piece.low.at + share * (piece.high.at - piece.low.at),
                       piece.low.negative()});
}

// A piece that has become too short is left with the roots that its ends tell.
void Counter::split(const Piece& piece, double at) {
    if (piece.depth < deepest_span) {
        const double middle = piece.low.at + at * (piece.high.at - piece.low.at);
        if (middle > piece.low.at && middle < piece.high.at) {
            next_.push_back(piece);
            place_.push_back(middle);
            point_.push_back(lines_[spans_.span[piece.span].line].at(middle));
            return;
        }
    }
    count_[piece.span].certain = false;
    if (piece.low.negative() != piece.high.negative()) ++count_[piece.span].roots;
}

void Counter::take(const Piece& piece, const Place& middle) {
    if (middle.finite() && touches(middle)) {
        RootCount& count = count_[piece.span];
        count.certain = false;
        if (piece.low.negative() != middle.negative()) ++count.roots;
        if (piece.high.negative() != middle.negative()) ++count.roots;
        return;
    }
    judge({piece.low, middle, piece.span, piece.depth + 1});
    judge({middle, piece.high, piece.span, piece.depth + 1});
}

void Counter::start(const base::Progress& progress) {
    std::int64_t at = 0;
    for (const Span& span : spans_.span)
        for (std::int64_t k = 0; k < span.places; ++k) point_.push_back(lines_[span.line].at(spans_.place[at++]));
    evaluate(progress);
    point_.clear();
    at = 0;
    for (std::int64_t i = 0; i < spans_.span.size(); ++i) {
        const Span& span = spans_.span[i];
        const Line& line = lines_[span.line];
        Place before{};
        for (std::int64_t k = 0; k < span.places; ++k, ++at) {
            Place now = place(at, line, spans_.place[at]);
            const bool begins = k == 0 && span.line_begins;
            const bool ends = k + 1 == span.places && span.line_ends;
            if (begins) settle_end(i, now, 1.0);
            if (ends) settle_end(i, now, -1.0);
            if (!begins && !ends && touches(now)) count_[i].certain = false;
            if (k == 0) count_[i].negative_at_begin = now.negative();
            if (k > 0) judge({before, now, i, 0});
            before = now;
        }
        count_[i].negative_at_end = before.negative();
    }
}

void Counter::go_on(const base::Progress& progress) {
    evaluate(progress);
    base::Array<double> place_before(runtime_.memory);
    std::swap(place_before, place_);
    std::swap(piece_, next_);
    next_.clear();
    point_.clear();
    for (std::int64_t i = 0; i < piece_.size(); ++i)
        take(piece_[i], place(i, lines_[spans_.span[piece_[i].span].line], place_before[i]));
}

void Counter::run(const base::Progress& progress) {
    start(progress);
    while (!next_.empty()) {
        progress.check();
        go_on(progress);
    }
}

} // namespace

void count_roots(const base::Runtime& runtime, const implicit::Implicit& implicit, const base::Array<Line>& lines,
                 const Spans& spans, base::Array<RootCount>& count, base::Array<Root>* roots,
                 const base::Progress& progress) {
    count.resize(spans.span.size());
    std::fill(count.begin(), count.end(), RootCount{});
    Counter(runtime, implicit, lines, spans, count, roots).run(progress);
}

} // namespace hrbfnpr::curves
