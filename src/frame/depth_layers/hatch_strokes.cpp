// SPDX-License-Identifier: MIT
#include "frame/depth_layers/hatch_strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::frame {

using drawing::Stroke;
using drawing::StrokePoint;

namespace {

// A line narrows over so many pixels where something hides it.
constexpr float hidden_taper = 2.0F;
// Hidden parts of fewer widths are drawn.
constexpr float least_stroke_gap = 2.0F;
// What hides a line has a halo on either side.  A part that is no longer than one halo is none of it: it is where a
// contour and its halo run out.  Up to the second of these, in halos, it is thinner.
constexpr float halo_alone = 1.0F;
constexpr float halo_and_more = 1.5F;
// A part that is seen between two hidden ones is so many times as long at least: what runs along a contour is in its
// halo, whose rim is not even.
constexpr float between_hidden = 3.0F;
// Near a tip points lie closer, since the width changes like a root there; pixels from it.
constexpr std::array<float, 2> tip_points = {0.3F, 1.25F};
// At the first of these it is no wider than this, pens, however wide the line: what lies farther from the end gets no
// thinner there when the line does.
constexpr float widest_tip = 0.1F;

// Points that differ by less than this from what lies between those beside them are left out, pixels.
constexpr float straight = 0.05F;
constexpr float even_radius = 0.006F;
constexpr std::int64_t most_left_out = 6; // one after the other

// The directions from a point in which its line may go on: those that pass by all points since nearly enough.
class Passage {
public:
    explicit Passage(const StrokePoint& from) noexcept
        : x_at_(from.x), y_at_(from.y), radius_at_(from.radius), length_(from.length), opacity_(from.opacity) {}

    // Whether the points taken lie between the first one and this one, if its opacity is theirs.
    [[nodiscard]] bool reaches(const StrokePoint& to) const noexcept {
        const float way = to.length - length_;
        return way > 0.0F && to.opacity == opacity_ && holds(to.x - x_at_, way, x_) && holds(to.y - y_at_, way, y_) &&
               holds(to.radius - radius_at_, way, radius_);
    }
    void take(const StrokePoint& p) noexcept {
        const float way = p.length - length_;
        if (!(way > 0.0F)) return;
        const float scale = 1.0F / way;
        narrow(p.x - x_at_, straight, scale, x_);
        narrow(p.y - y_at_, straight, scale, y_);
        narrow(p.radius - radius_at_, even_radius, scale, radius_);
    }

private:
    struct Slopes {
        float least = -std::numeric_limits<float>::infinity(), most = std::numeric_limits<float>::infinity();
    };
    static bool holds(float rise, float way, const Slopes& slopes) noexcept {
        return rise > slopes.least * way && rise < slopes.most * way;
    }
    static void narrow(float rise, float by, float scale, Slopes& slopes) noexcept {
        slopes.least = std::max(slopes.least, (rise - by) * scale);
        slopes.most = std::min(slopes.most, (rise + by) * scale);
    }

    float x_at_, y_at_, radius_at_, length_, opacity_; // of the first point
    Slopes x_, y_, radius_;
};

// An ellipse's quarter would be blunter.
[[nodiscard]] float narrowed_end(float from_end, float taper) noexcept {
    return from_end < taper ? std::sqrt(std::max(from_end, 0.0F) / taper) : 1.0F;
}

// The strokes of one span.
class HatchPieces {
public:
    HatchPieces(HatchStrokePart& part, const HatchSpan& span, std::span<Dot> dots, const LayerStyle& style, float halo,
                const Hiding& hiding) noexcept
        : part_(part), span_(span), dots_(dots), hiding_(hiding), shortest_(style.hatch_shortest), halo_(halo),
          tip_radius_(0.5F * widest_tip * style.hatch_pen) {}

    void operator()() {
        if (span_.closed) begin_hidden();
        measure();
        find_cuts();
        const std::int64_t count = size();
        for (std::int64_t i = 0; i < count; ++i) {
            if (!seen(i)) continue;
            const std::int64_t first = i;
            while (i + 1 < count && (seen(i + 1) || closes(i + 1))) ++i;
            while (!seen(i)) --i; // a gap at the end is none
            put(first, i);
        }
    }

private:
    [[nodiscard]] std::int64_t size() const noexcept { return static_cast<std::int64_t>(dots_.size()); }
    [[nodiscard]] const Dot& dot(std::int64_t i) const noexcept { return dots_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] bool seen(std::int64_t i) const noexcept { return dot(i).opacity > 0.0F; }

    // A closed line begins where it is hidden, if it is anywhere.
    void begin_hidden() noexcept {
        const auto hidden = std::find_if(dots_.begin(), dots_.end(), [](const Dot& d) { return !(d.opacity > 0.0F); });
        if (hidden == dots_.end()) return;
        std::rotate(dots_.begin(), hidden, dots_.end() - 1);
        dots_.back() = dots_.front();
    }

    void measure() {
        part_.length.clear();
        float length = 0.0F;
        for (std::int64_t i = 0; i < size(); ++i) {
            if (i > 0) {
                const glm::vec2 leg(dot(i).x - dot(i - 1).x, dot(i).y - dot(i - 1).y);
                length += glm::length(leg);
            }
            part_.length.push_back(length);
        }
    }

    void find_cuts() {
        part_.cuts.clear();
        if (!hiding_.edges.empty()) HatchCuts(hiding_, halo_, dots_, part_.length, part_.cuts).find();
    }

    // How wide the line is in the hidden part that i lies in, where it is so short that the line goes on; else 0.
    [[nodiscard]] float bridge(std::int64_t i) const noexcept {
        std::int64_t first = i;
        while (first > 0 && !seen(first - 1)) --first;
        std::int64_t end = i;
        while (end < size() && !seen(end)) ++end;
        if (first == 0 || end == size()) return 0.0F;
        const float gap = turn(end - 1) - turn(first - 1);
        if (gap < least_stroke_gap * (dot(first - 1).radius + dot(end).radius)) return 1.0F;
        return halo_ > 0.0F ? std::clamp((halo_and_more - gap / halo_) / (halo_and_more - halo_alone), 0.0F, 1.0F)
                            : 0.0F;
    }
    [[nodiscard]] bool closes(std::int64_t i) const noexcept { return bridge(i) > 0.0F; }
    // Where the line begins or ends to be hidden between a point and the next one: half way, if nothing tells.
    [[nodiscard]] float turn(std::int64_t i) const noexcept {
        for (const HatchCut& cut : part_.cuts)
            if (cut.before == i) return cut.at;
        return 0.5F * (part_.length[i] + part_.length[i + 1]);
    }

    // From the point `first` to the point `last`, which are seen, and on to where it is hidden.
    void put(std::int64_t first, std::int64_t last) {
        begin_ = first > 0 ? turn(first - 1) : 0.0F;
        end_ = last + 1 < size() ? turn(last) : part_.length[size() - 1];
        begin_taper_ = first > 0 ? hidden_taper : 0.0F;
        end_taper_ = last + 1 < size() ? hidden_taper : 0.0F;
        begins_narrow_ = std::max(span_.taper_begin, begin_ + begin_taper_);
        ends_narrow_ = std::min(part_.length[size() - 1] - span_.taper_end, end_ - end_taper_);
        first_ = first;
        last_ = last;
        const bool whole = first == 0 && last + 1 == size();
        const float length = end_ - begin_;
        const float shortest = first > 0 && last + 1 < size() ? between_hidden * shortest_ : shortest_;
        if (!whole && !(length > 0.5F * shortest)) return;
        fade_ = span_.fade;
        if (!whole && shortest > 0.0F) fade_ *= std::clamp(2.0F * length / shortest - 1.0F, 0.0F, 1.0F);
        Stroke stroke;
        stroke.first = part_.made.points.size();
        stroke.layer = dot(first).layer;
        stroke.closed = span_.closed && whole;
        add_points();
        stroke.count = static_cast<std::int32_t>(part_.made.points.size() - stroke.first);
        stroke.depth = part_.made.points[stroke.first + stroke.count / 2].depth;
        part_.made.strokes.push_back(stroke);
    }

    void add_points() {
        const bool tip = begin_taper_ > 0.0F || span_.taper_begin > 0.0F;
        const bool end_tip = end_taper_ > 0.0F || span_.taper_end > 0.0F;
        const float reach = 2.0F * tip_points.back();
        const bool tips = end_ - begin_ > 2.0F * reach;
        start_ = begin_;
        from_ = std::max<std::int64_t>(first_ - 1, 0);
        std::int64_t first = part_.made.points.size();
        add(begin_);
        if (tip && tips) {
            for (const float at : tip_points) add(begin_ + at);
            narrow_tip(++first);
        }
        const float low = begin_ + (tip && tips ? reach : 0.5F);
        const float high = end_ - (end_tip && tips ? reach : 0.5F);
        for (std::int64_t i = first_; i <= last_; ++i)
            if (part_.length[i] > low && part_.length[i] < high) add_dot(i);
        if (end_tip && tips) {
            for (std::size_t k = tip_points.size(); k-- > 0;) add(end_ - tip_points[k]);
            narrow_tip(part_.made.points.size() - 1);
        }
        add(end_);
        leave_out(first, part_.made.points.size() - (end_tip && tips ? 2 : 1));
    }

    void narrow_tip(std::int64_t point) noexcept {
        float& radius = part_.made.points[point].radius;
        radius = std::min(radius, tip_radius_);
    }

    // Fewer points make fewer edges to draw: some of those between two.
    void leave_out(std::int64_t first, std::int64_t last) {
        base::Array<StrokePoint>& points = part_.made.points;
        std::int64_t kept = first;
        std::int64_t from = first; // the point that was kept last
        Passage passage(points[first]);
        for (std::int64_t i = first + 1; i < points.size(); ++i) {
            passage.take(points[i]);
            if (i < last && i - from <= most_left_out && points[i].opacity == points[kept].opacity &&
                passage.reaches(points[i + 1]))
                continue;
            if (++kept != i) points[kept] = points[i];
            from = i;
            passage = Passage(points[kept]);
        }
        points.resize(kept + 1);
    }

    // A point of the line; they come in their order.
    void add(float at) {
        while (from_ + 2 < size() && part_.length[from_ + 1] < at) ++from_;
        const Dot& a = dot(from_);
        const Dot& b = dot(from_ + 1);
        const float way = part_.length[from_ + 1] - part_.length[from_];
        const float t = way > 0.0F ? std::clamp((at - part_.length[from_]) / way, 0.0F, 1.0F) : 0.0F;
        const auto mixed = [t](float from, float to) { return from + t * (to - from); };
        StrokePoint p{};
        p.x = mixed(a.x, b.x);
        p.y = mixed(a.y, b.y);
        p.radius = mixed(shown_radius(from_), shown_radius(from_ + 1)) * fade_ * profile(at);
        // Where the line goes on over what is hidden, it does so as before.
        p.opacity = seen(from_) && seen(from_ + 1) ? mixed(a.opacity, b.opacity) : std::max(a.opacity, b.opacity);
        if (!(p.opacity > 0.0F)) p.opacity = part_.made.points.back().opacity;
        p.depth = mixed(a.depth, b.depth);
        p.window = mixed(a.window, b.window);
        p.pixels_per_unit = mixed(a.pixels_per_unit, b.pixels_per_unit);
        p.length = at - start_;
        p.id = t < 0.5F ? a.id : b.id;
        p.radius = within_edges(p, glm::vec2(b.x - a.x, b.y - a.y));
        part_.made.points.push_back(p);
    }

    // The point of a dot, which is none of the first.
    void add_dot(std::int64_t i) {
        const Dot& own = dot(i);
        const float at = part_.length[i];
        float opacity = seen(i) ? own.opacity : dot(i - 1).opacity;
        if (!(opacity > 0.0F)) opacity = part_.made.points.back().opacity;
        part_.made.points.push_back({own.x, own.y, shown_radius(i) * fade_ * profile(at), opacity, own.depth,
                                     own.window, own.pixels_per_unit, at - start_, own.id});
        StrokePoint& p = part_.made.points.back();
        const Dot& next = dot(std::min(i + 1, size() - 1));
        p.radius = within_edges(p, glm::vec2(next.x - dot(i - 1).x, next.y - dot(i - 1).y));
    }

    // How wide it is, so that it does not go over an edge that it runs along.
    [[nodiscard]] float within_edges(const StrokePoint& p, const glm::vec2& along) const noexcept {
        return hiding_.edges.empty() ? p.radius : hiding_.edges.room(p, along, p.radius, std::min(halo_, widest_halo));
    }

    // What is not seen is a gap at an end, or one that the line goes on over.
    [[nodiscard]] float shown_radius(std::int64_t i) const noexcept {
        const bool inner = i >= first_ && i <= last_;
        return dot(i).radius * (seen(i) || !inner ? 1.0F : bridge(i));
    }

    [[nodiscard]] float profile(float at) const noexcept {
        const float whole = part_.length[size() - 1];
        if (at >= begins_narrow_ && at <= ends_narrow_) return 1.0F;
        return std::min({narrowed_end(at, span_.taper_begin), narrowed_end(whole - at, span_.taper_end),
                         narrowed_end(at - begin_, begin_taper_), narrowed_end(end_ - at, end_taper_)});
    }

    HatchStrokePart& part_;
    const HatchSpan& span_;
    std::span<Dot> dots_;
    const Hiding& hiding_;
    float shortest_, halo_, tip_radius_;
    std::int64_t first_ = 0, last_ = 0, from_ = 0;
    float begin_ = 0.0F, end_ = 0.0F, begin_taper_ = 0.0F, end_taper_ = 0.0F, start_ = 0.0F, fade_ = 1.0F;
    float begins_narrow_ = 0.0F, ends_narrow_ = 0.0F; // between them it is as wide as its points
};

// Calls f for each element whose number differs from that of the one before.
template <class Range, class F>
void for_each_mark(const Range& range, const F& f) {
    std::uint32_t last = 0;
    for (const auto& element : range)
        if (std::exchange(last, element.id) != element.id) f(element);
}

void make_strokes(const LayerStyle& style, float halo, const Hiding& hiding, const HatchPart& from, std::span<Dot> dots,
                  HatchStrokePart& part) {
    part.made.strokes.clear();
    part.made.points.clear();
    part.seen = part.shown = part.hidden = 0;
    for (const HatchSpan& span : from.spans) {
        const std::span<Dot> own =
            dots.subspan(static_cast<std::size_t>(span.first), static_cast<std::size_t>(span.count));
        for_each_mark(own, [&](const Dot& dot) { part.hidden += dot.opacity > 0.0F ? 0 : 1; });
        for (const Dot& dot : own) part.seen += dot.opacity > 0.0F ? 1 : 0;
        HatchPieces(part, span, own, style, halo, hiding)();
    }
    for (Dot& dot : dots) dot.opacity = 0.0F;
    for_each_mark(part.made.points, [&](const StrokePoint&) { ++part.shown; });
}

} // namespace

std::span<const HatchStrokePart> HatchStrokes::run(const Scene& scene, const HatchPoints& points, const Hiding& hiding,
                                                   drawing::Drawing& drawing) {
    const std::span<const HatchPoints::Batch> batches = points.batches();
    const auto count = static_cast<std::int64_t>(batches.size());
    while (parts_.size() < count) parts_.add(runtime_.memory);
    runtime_.parallel.for_each(count, [&](std::int64_t i) {
        const HatchPoints::Batch& batch = batches[static_cast<std::size_t>(i)];
        const std::span<Dot> dots(drawing.dots.data() + batch.first_dot,
                                  static_cast<std::size_t>(batch.part.points.size()));
        const Run& own = scene.runs[batch.run];
        make_strokes(*own.style, scene.item_of(own).style.halo_width, hiding, batch.part, dots, parts_[i]);
    });
    for (std::int64_t i = 0; i < count; ++i) {
        const HatchStrokePart& part = parts_[i];
        const std::int64_t dots = batches[static_cast<std::size_t>(i)].part.points.size();
        drawing.dot_count -= part.seen;
        drawing.counts.shown += part.shown - part.seen;
        drawing.counts.dropped_hidden += part.hidden - (dots - part.seen);
    }
    return {parts_.begin(), batches.size()};
}

std::int64_t HatchStrokes::bytes() const noexcept {
    std::int64_t sum = parts_.bytes();
    for (const HatchStrokePart& part : parts_) sum += part.bytes();
    return sum;
}

} // namespace hrbfnpr::frame
