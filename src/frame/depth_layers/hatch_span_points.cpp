// SPDX-License-Identifier: MIT
#include "frame/depth_layers/hatch_spans.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// Between marks that are nearer than this a line is straight, pixels: no curve leaves it by more than an eighth of
// that.
constexpr float shortest_curve = 1.0F;

[[nodiscard]] glm::vec2 place(const HatchMark& m) noexcept { return {m.x, m.y}; }

// As wide as HatchStrokes makes it so far from an end.
[[nodiscard]] float narrowed(float from_end, float taper) noexcept {
    return from_end < taper ? std::sqrt(from_end / taper) : 1.0F;
}

} // namespace

// That of a Catmull-Rom curve at a mark, of unit length where marks lie evenly.
glm::vec2 HatchSpans::tangent(std::span<const HatchMark> marks, std::int64_t i) const noexcept {
    const auto count = static_cast<std::int64_t>(marks.size());
    const auto m = [&](std::int64_t k) -> const HatchMark& { return marks[static_cast<std::size_t>(k)]; };
    std::int64_t before = i > 0 ? i - 1 : goes_round_ ? count - 2 : 0;
    std::int64_t after = i + 1 < count ? i + 1 : goes_round_ ? 1 : i;
    if (!m(before).is_valid()) before = i;
    if (!m(after).is_valid()) after = i;
    const float way = (before != i ? m(i).way : 0.0F) + (after != i ? m(after).way : 0.0F);
    return way > 0.0F ? (place(m(after)) - place(m(before))) / way : glm::vec2(0.0F);
}

// Of the line from a place to one that is not before it, widths changing evenly from mark to mark.
float HatchSpans::area(std::span<const HatchMark> marks, const Place& from, const Place& to) const noexcept {
    const auto width = [&](std::int64_t i) { return marks[static_cast<std::size_t>(i)].width; };
    // From a mark on to the share of the way to the next one.
    const auto up_to = [&](std::int64_t i, float share) {
        const float way = length_[i + 1] - length_[i];
        return share * way * (width(i) + 0.5F * share * (width(i + 1) - width(i)));
    };
    float sum = to.share > 0.0F ? up_to(to.mark, to.share) : 0.0F;
    if (from.share > 0.0F) sum -= up_to(from.mark, from.share);
    for (std::int64_t i = from.mark; i < to.mark; ++i)
        sum += 0.5F * (length_[i + 1] - length_[i]) * (width(i) + width(i + 1));
    return sum;
}

void HatchSpans::put(const LayerStyle& style, std::span<const HatchMark> marks, std::int64_t number, HatchPart& part) {
    const Drawn& drawn = drawn_[number];
    const std::int64_t next = number + drawn.joined;
    const Drawn& last = drawn_[next - 1];
    const float length = within(drawn.begin, last.end) - within(drawn.begin, drawn.begin);
    if (!(length > 0.0F && drawn.fade > 0.0F)) return;
    HatchSpan span;
    span.first = part.points.size();
    span.closed = drawn.closed;
    if (drawn.joined == 1) span.fade = drawn.fade;
    if (!drawn.closed) {
        span.taper_begin = taper_begin(style, marks, number);
        span.taper_end = taper_end(style, marks, next - 1);
    }
    const std::int32_t count = 1 + static_cast<std::int32_t>(std::ceil(length / hatch_point_step));
    add_points(marks, number, count, part.points);
    if (drawn.joined > 1) {
        find_dips(style, marks, number);
        fade_joined(marks, number, span.first, part.points);
    }
    span.count = static_cast<std::int32_t>(part.points.size() - span.first);
    part.spans.push_back(span);
}

// The gaps between parts that are joined.
void HatchSpans::find_dips(const LayerStyle& style, std::span<const HatchMark> marks, std::int64_t first) {
    dips_.clear();
    for (std::int64_t i = first; i + 1 < first + drawn_[first].joined; ++i)
        dips_.push_back({at(drawn_[i].end), at(drawn_[i + 1].begin), taper_end(style, marks, i),
                         taper_begin(style, marks, i + 1), drawn_[i + 1].link});
}

// Of parts that are joined: how wide the line is at that length.  dip: the first gap that does not end before it.  A
// line that narrows until it is open in a gap has its tapers there before it is.
float HatchSpans::joined_fade(std::int64_t first, std::int64_t dip, float length) const noexcept {
    const Drawn& own = drawn_[first + dip];
    float fade = own.fade;
    if (dip < dips_.size()) {
        const Dip& next = dips_[dip];
        if (length >= next.begin) return std::min(own.fade, drawn_[first + dip + 1].fade) * next.link;
        fade *= std::lerp(next.link, 1.0F, narrowed(next.begin - length, next.taper_end));
    }
    if (dip > 0) {
        const Dip& last = dips_[dip - 1];
        fade *= std::lerp(last.link, 1.0F, narrowed(length - last.end, last.taper_begin));
    }
    return fade;
}

// To the place so far from the mark before where a part begins, which is not before this place.
void HatchSpans::advance(Place& place, const Place& begin, float wanted) const noexcept {
    const float from = length_[begin.mark];
    while (place.mark < length_.size() - 2 && length_[place.mark + 1] - from < wanted) ++place.mark;
    const float way = length_[place.mark + 1] - length_[place.mark];
    const float left = wanted - (length_[place.mark] - from);
    place.share = way > 0.0F ? std::clamp(left / way, 0.0F, 1.0F) : 0.0F;
}

// At even steps along the chords.  A width is the mean over both steps beside its point: from one mark to the next it
// may change by much, and points stand elsewhere in the next frame.
void HatchSpans::add_points(std::span<const HatchMark> marks, std::int64_t number, std::int32_t count,
                            base::Array<HatchPoint>& points) const {
    const Drawn& drawn = drawn_[number];
    const Place& end = drawn_[number + drawn.joined - 1].end;
    const float begin = within(drawn.begin, drawn.begin);
    const float step = (within(drawn.begin, end) - begin) / static_cast<float>(count - 1);
    const float scale = 0.5F / step;
    points.resize_for_overwrite(points.size() + count);
    HatchPoint* const own = points.end() - count;
    Place last = drawn.begin;
    float area_before = 0.0F;
    own[0] = point(marks, last);
    stray(marks, own[0], last);
    for (std::int32_t i = 1; i < count; ++i) {
        Place place = last;
        if (i + 1 == count)
            place = end;
        else
            advance(place, drawn.begin, begin + step * static_cast<float>(i));
        own[i] = point(marks, place);
        stray(marks, own[i], place);
        const float own_area = area(marks, last, place);
        own[i - 1].width = scale * (i == 1 ? 2.0F * own_area : area_before + own_area);
        area_before = own_area;
        last = place;
    }
    own[count - 1].width = 2.0F * scale * area_before;
    if (drawn.closed) own[0].width = own[count - 1].width = 0.5F * (own[0].width + own[count - 1].width);
}

// The points from `first` on are those of parts that are joined: as wide as the gaps between them let them, and one
// more in the middle of each gap.  That one takes its width from those beside it, so that it is none as the gap closes.
void HatchSpans::fade_joined(std::span<const HatchMark> marks, std::int64_t number, std::int64_t first,
                             base::Array<HatchPoint>& points) const {
    const auto count = points.size() - first;
    const float begin = at(drawn_[number].begin);
    const float step = (at(drawn_[number + drawn_[number].joined - 1].end) - begin) / static_cast<float>(count - 1);
    points.resize_for_overwrite(
        points.size() + std::count_if(dips_.begin(), dips_.end(), [](const Dip& dip) { return dip.link < 1.0F; }));
    HatchPoint* to = points.end();
    float next_width = points[first + count - 1].width; // before it was faded
    std::int64_t dip = dips_.size();                    // the first one that does not end before a point
    std::int64_t middle = dips_.size();                 // the first one whose middle is behind a point
    for (std::int64_t i = count - 1; i >= 0; --i) {
        const float length = begin + step * static_cast<float>(i);
        HatchPoint own = points[first + i];
        for (; middle > 0 && dips_[middle - 1].middle() > length; --middle) {
            const Dip& gap = dips_[middle - 1];
            if (gap.link == 1.0F) continue;
            const Place place = place_at(gap.middle());
            *--to = point(marks, place);
            const float width = std::lerp(own.width, next_width, std::min((gap.middle() - length) / step, 1.0F));
            to->width = width * joined_fade(number, middle - 1, gap.middle());
            stray(marks, *to, place);
        }
        while (dip > 0 && dips_[dip - 1].end >= length) --dip;
        next_width = own.width;
        own.width *= joined_fade(number, dip, length);
        *--to = own;
    }
}

// Across the line, as the hand has it there.
void HatchSpans::stray(std::span<const HatchMark> marks, HatchPoint& point, const Place& place) const noexcept {
    if (!hand_.wobbles()) return;
    const std::int64_t next = std::min(place.mark + 1, length_.size() - 1);
    const glm::vec2 along = (1.0F - place.share) * tangent(marks, place.mark) + place.share * tangent(marks, next);
    const float length = glm::length(along);
    if (!(length > 0.0F)) return;
    const double mark = static_cast<double>(place.mark + turned_) + static_cast<double>(place.share);
    const float aside = hand_.aside(mark) / length;
    point.x -= aside * along.y;
    point.y += aside * along.x;
}

// Hermite's cubic between two marks; the rest changes evenly.
HatchPoint HatchSpans::point(std::span<const HatchMark> marks, const Place& at_place) const noexcept {
    const auto i = static_cast<std::size_t>(at_place.mark);
    const HatchMark& a = marks[i];
    const float t = at_place.share;
    if (t == 0.0F || i + 1 == marks.size()) return {a.x, a.y, a.window, a.depth, a.pixels_per_unit, a.width, a.id};
    const HatchMark& b = marks[i + 1];
    const float way = length_[at_place.mark + 1] - length_[at_place.mark];
    const float u = 1.0F - t;
    const glm::vec2 p =
        way < shortest_curve
            ? u * place(a) + t * place(b)
            : u * u * (1.0F + 2.0F * t) * place(a) + t * t * (3.0F - 2.0F * t) * place(b) +
                  t * u * way * (u * tangent(marks, at_place.mark) - t * tangent(marks, at_place.mark + 1));
    const auto mixed = [t](float from, float to) { return from + t * (to - from); };
    return {p.x,
            p.y,
            mixed(a.window, b.window),
            mixed(a.depth, b.depth),
            mixed(a.pixels_per_unit, b.pixels_per_unit),
            mixed(a.width, b.width),
            t < 0.5F ? a.id : b.id};
}

} // namespace hrbfnpr::frame
