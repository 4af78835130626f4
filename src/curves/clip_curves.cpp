// SPDX-License-Identifier: MIT
#include "curves/clip_curves.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// Of its piece: an end is known so well, and one nearer to a point is that point.
constexpr double known = 1e-9;
constexpr double smallest = 1e-6;
constexpr int most_steps = 40;

// A piece that passes the border: from a point where the surface is to one where it is not.
struct Cut {
    std::int64_t piece;           // by its first point
    std::int64_t held, lost;      // its points
    double low = 0.0, high = 1.0; // shares, from the one that is held
    CurvePoint end;
};

class Clipper {
public:
    Clipper(const base::Runtime& runtime, const Level& level, const SurfaceEnd& end, const Curves& curves)
        : runtime_(runtime), level_(level), end_(end), curves_(curves), holds_(runtime.memory, curves.point.size()),
          cuts_(runtime.memory), result_(runtime.memory) {
        result_.first.push_back(0);
    }

    Curves run(const base::Progress& progress);

private:
    void find_held();
    void find_cuts();
    [[nodiscard]] double farthest_of(const Cut& cut) const noexcept;
    void refine(const base::Progress& progress);
    void add_curve(std::int64_t curve);
    void put_end(std::int64_t piece);
    void finish(bool closed);

    const base::Runtime& runtime_;
    const Level& level_;
    const SurfaceEnd& end_;
    const Curves& curves_;
    static constexpr std::uint8_t unknown = 2;
    base::Array<std::uint8_t> holds_; // of each point: 1 where the surface is there, 0 beyond its border
    base::Array<Cut> cuts_;           // along the curves
    Curves result_;
};

// Far from the border a curve is where it was when it last came near it.
void Clipper::find_held() {
    runtime_.parallel.for_chunks(holds_.size(), 256, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const CurvePoint& p = curves_.point[i];
            const bool near = end_.near_border(p.position);
            holds_[i] = !near ? unknown : end_.beyond(p.position, p.gradient) <= 0.0 ? 1 : 0;
        }
    });
    for (std::int64_t c = 0; c < curves_.count(); ++c) {
        const std::int64_t first = curves_.first[c];
        const std::int64_t count = curves_.size_of(c);
        std::int64_t begin = 0;
        while (begin < count && holds_[first + begin] == unknown) ++begin;
        // Without a border the whole curve is there.
        std::uint8_t last = begin < count ? holds_[first + begin] : 1;
        for (std::int64_t k = 0; k < count; ++k) {
            std::uint8_t& held = holds_[first + (begin + k) % count];
            if (curves_.closed[c] == 0 && begin + k == count) last = holds_[first + begin];
            held = last = held == unknown ? last : held;
        }
    }
}

void Clipper::find_cuts() {
    find_held();
    for (std::int64_t c = 0; c < curves_.count(); ++c)
        for (std::int64_t k = 0; k < curves_.pieces_of(c); ++k) {
            const std::int64_t a = curves_.first[c] + k;
            const std::int64_t b = curves_.next(c, a);
            if (holds_[a] != holds_[b])
                cuts_.push_back({a, holds_[a] != 0 ? a : b, holds_[a] != 0 ? b : a, 0.0, 1.0, {}});
        }
}

// The square of half the piece's chord: a longer step of Newton's leads to another curve.
double Clipper::farthest_of(const Cut& cut) const noexcept {
    const glm::dvec3 way = curves_.point[cut.held].position - curves_.point[cut.lost].position;
    return 0.25 * glm::dot(way, way);
}

// By halving the piece's cubic, whose points two of Newton's steps bring onto the curve.
void Clipper::refine(const base::Progress& progress) {
    base::Array<CurvePoint> points(runtime_.memory, cuts_.size());
    for (Cut& cut : cuts_) cut.end = curves_.point[cut.held];
    for (int step = 0; step < most_steps && !cuts_.empty(); ++step) {
        for (std::int64_t i = 0; i < cuts_.size(); ++i) {
            const Cut& cut = cuts_[i];
            const CurvePoint& a = curves_.point[cut.held];
            const CurvePoint& b = curves_.point[cut.lost];
            const double share = 0.5 * (cut.low + cut.high);
            points[i].position = cut.held == cut.piece ? CubicPiece(a, b).at(share) : CubicPiece(b, a).at(1.0 - share);
        }
        for (int correction = 0; correction < 2; ++correction) {
            evaluate(runtime_, level_, points, progress);
            for (std::int64_t i = 0; i < cuts_.size(); ++i) {
                const glm::dvec3 way = points[i].newton_step();
                if (glm::dot(way, way) <= farthest_of(cuts_[i])) points[i].position += way;
            }
        }
        bool all = true;
        for (std::int64_t i = 0; i < cuts_.size(); ++i) {
            Cut& cut = cuts_[i];
            const bool held = end_.beyond(points[i].position, points[i].gradient) <= 0.0;
            (held ? cut.low : cut.high) = 0.5 * (cut.low + cut.high);
            if (held) cut.end = points[i];
            all = all && cut.high - cut.low <= known;
        }
        if (all) break;
    }
}

void Clipper::finish(bool closed) {
    const std::int64_t first = result_.first[result_.first.size() - 1];
    if (result_.point.size() - first < 2) {
        result_.point.resize(first);
        return;
    }
    result_.first.push_back(result_.point.size());
    result_.closed.push_back(closed ? 1 : 0);
}

// A closed curve that is cut is gone through from a point where there is no surface.
void Clipper::add_curve(std::int64_t curve) {
    const std::int64_t first = curves_.first[curve];
    const std::int64_t count = curves_.size_of(curve);
    const bool closed = curves_.closed[curve] != 0;
    std::int64_t begin = 0;
    while (closed && begin < count && holds_[first + begin] != 0) ++begin;
    if (begin == count) {
        for (std::int64_t i = 0; i < count; ++i) result_.point.push_back(curves_.point[first + i]);
        return finish(true);
    }
    std::int64_t at = first + begin;
    if (holds_[at] != 0) result_.point.push_back(curves_.point[at]);
    for (std::int64_t k = 0; k < curves_.pieces_of(curve); ++k) {
        const std::int64_t after = curves_.next(curve, at);
        if (holds_[at] != holds_[after]) put_end(at);
        if (holds_[at] != 0 && holds_[after] == 0) finish(false);
        if (holds_[after] != 0) result_.point.push_back(curves_.point[after]);
        at = after;
    }
    finish(false);
}

// Of the piece after a point, unless the border passes through the piece's own end.
void Clipper::put_end(std::int64_t piece) {
    const Cut& cut = *std::lower_bound(cuts_.begin(), cuts_.end(), piece,
                                       [](const Cut& c, std::int64_t wanted) { return c.piece < wanted; });
    if (cut.low > smallest) result_.point.push_back(cut.end);
}

Curves Clipper::run(const base::Progress& progress) {
    find_cuts();
    refine(progress);
    for (std::int64_t c = 0; c < curves_.count(); ++c) add_curve(c);
    return std::move(result_);
}

} // namespace

Curves clip(const base::Runtime& runtime, const Level& level, const SurfaceEnd& end, const Curves& curves,
            const base::Progress& progress) {
    return Clipper(runtime, level, end, curves).run(progress);
}

} // namespace hrbfnpr::curves
