// SPDX-License-Identifier: MIT
#include "frame/depth_layers/hatch_spans.h"

#include "base/scratch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::frame {
namespace {

constexpr float point_step = 2.5F; // pixels
// Gaps of fewer widths are closed.
constexpr float least_gap = 2.0F;
// Short parts fade while a gap beside them grows by so much, in the length of the shortest.
constexpr float fading_gap = 0.25F;
// A line's end where its stroke or its level ends is this much as long as where its tone ends ...
constexpr float blunt = 0.35F;
// Where the surface turns away a line that crosses the contour by at least the first of these sines runs on under it,
// and one that hardly does, by the second, narrows before it.
constexpr float crosses = 0.5F;
constexpr float runs_along = 0.25F;
// Of the tone, and of n . v: where so much of them is left at an end, it is its level's alone.
constexpr float by_level_alone = 0.1F;
constexpr float beyond_all = 1000.0F; // a gap longer than any taper, pixels
constexpr float rim_part = 0.5F;      // of a taper: so much of the line is looked at

struct Crossing {
    float share; // of the way from the mark that is drawn to the one that is not
    HatchEnd end;
};

// Where the first margin runs out, of those from one on, margins changing evenly.
[[nodiscard]] Crossing crossing(const HatchMark& drawn, const HatchMark& other,
                                HatchEnd from = HatchEnd::tone) noexcept {
    if (!other.valid) return {0.0F, HatchEnd::picture};
    Crossing first{1.0F, HatchEnd::picture};
    for (auto k = static_cast<std::size_t>(from); k < hatch_margins; ++k) {
        if (other.margin[k] >= 0.0F) continue;
        const float share = drawn.margin[k] / (drawn.margin[k] - other.margin[k]);
        if (share <= first.share) first = {share, static_cast<HatchEnd>(k)};
    }
    return first;
}

[[nodiscard]] glm::vec2 place(const HatchMark& m) noexcept { return {m.x, m.y}; }

[[nodiscard]] float firmness(const HatchMark& m) noexcept { return hatch_firmness(m.margin[0], m.margin[1]); }

[[nodiscard]] float smooth(float x) noexcept {
    const float at = std::clamp(x, 0.0F, 1.0F);
    return at * at * (3.0F - 2.0F * at);
}

} // namespace

void HatchSpans::add(const LayerStyle& style, std::int64_t stroke, std::span<HatchMark> marks, bool closed,
                     HatchPart& part) {
    const auto is_drawn = [](const HatchMark& m) { return m.is_drawn(); };
    const auto hidden = std::find_if_not(marks.begin(), marks.end(), is_drawn);
    if (std::none_of(hidden, marks.end(), is_drawn) && hidden == marks.begin()) return;
    const bool whole = hidden == marks.end();
    turned_ = closed && !whole ? hidden - marks.begin() : 0;
    if (closed && !whole) { // begin where nothing is drawn
        std::rotate(marks.begin(), hidden, marks.end() - 1);
        marks.back() = marks.front();
    }
    measure(marks);
    find(marks, closed && whole);
    const std::int64_t steps = length_.size() - 1;
    hand_ = HatchHand(style, stroke, closed ? steps : 0, length_[steps] / static_cast<float>(steps));
    if (hand_.overshoots()) overshoot(marks);
    join(style, marks);
    for (std::int64_t i = 0; i < drawn_.size(); i += drawn_[i].joined) put(style, marks, i, part);
}

// Lengths of chords.
void HatchSpans::measure(std::span<const HatchMark> marks) {
    const auto count = static_cast<std::int64_t>(marks.size());
    base::resize_scratch(length_, count);
    length_[0] = 0.0F;
    for (std::int64_t i = 1; i < count; ++i) length_[i] = length_[i - 1] + marks[static_cast<std::size_t>(i)].way;
    const HatchMark& first = marks.front();
    const HatchMark& last = marks.back();
    goes_round_ = first.valid && last.valid && place(first) == place(last);
}

// That of a Catmull-Rom curve at a mark, of unit length where marks lie evenly.
glm::vec2 HatchSpans::tangent(std::span<const HatchMark> marks, std::int64_t i) const noexcept {
    const auto count = static_cast<std::int64_t>(marks.size());
    const auto m = [&](std::int64_t k) -> const HatchMark& { return marks[static_cast<std::size_t>(k)]; };
    std::int64_t before = i > 0 ? i - 1 : goes_round_ ? count - 2 : 0;
    std::int64_t after = i + 1 < count ? i + 1 : goes_round_ ? 1 : i;
    if (!m(before).valid) before = i;
    if (!m(after).valid) after = i;
    const float way = (before != i ? m(i).way : 0.0F) + (after != i ? m(after).way : 0.0F);
    return way > 0.0F ? (place(m(after)) - place(m(before))) / way : glm::vec2(0.0F);
}

HatchSpans::ByLevel HatchSpans::by_level(const HatchMark& drawn, const HatchMark& other, HatchEnd end,
                                         float share) noexcept {
    if (end != HatchEnd::level) return {};
    const auto margin = [&](HatchEnd of) {
        const auto k = static_cast<std::size_t>(of);
        return drawn.margin[k] + share * (other.margin[k] - drawn.margin[k]);
    };
    const float tone = margin(HatchEnd::tone);
    const float rim = margin(HatchEnd::rim);
    return {std::clamp(std::min(tone, rim) / by_level_alone, 0.0F, 1.0F), tone < rim ? HatchEnd::tone : HatchEnd::rim};
}

void HatchSpans::find(std::span<const HatchMark> marks, bool closed) {
    drawn_.clear();
    const auto count = static_cast<std::int64_t>(marks.size());
    const auto m = [&](std::int64_t i) -> const HatchMark& { return marks[static_cast<std::size_t>(i)]; };
    float open = 0.0F;
    for (std::int64_t i = 0; i < count; ++i) {
        if (!m(i).is_drawn()) {
            open = std::max({open, m(i).openness(), m(i).passed});
            continue;
        }
        Drawn drawn;
        drawn.open = std::exchange(open, 0.0F);
        drawn.begin = {i, 0.0F};
        if (i > 0) {
            const Crossing begin = crossing(m(i), m(i - 1));
            if (begin.share > 0.0F) drawn.begin = {i - 1, 1.0F - begin.share};
            drawn.begins = begin.end;
            drawn.begins_by = by_level(m(i), m(i - 1), begin.end, begin.share);
        }
        const std::int64_t first = i;
        while (i + 1 < count && m(i + 1).is_drawn()) ++i;
        drawn.firm = firmness(m((first + i) / 2)); // of most parts that is enough
        for (std::int64_t k = first; k <= i && drawn.firm < 1.0F; ++k)
            drawn.firm = std::max(drawn.firm, firmness(m(k)));
        drawn.end = {i, 0.0F};
        if (i + 1 < count) {
            const Crossing end = crossing(m(i), m(i + 1));
            drawn.end = {i, end.share};
            drawn.ends = end.end;
            drawn.ends_by = by_level(m(i), m(i + 1), end.end, end.share);
        }
        drawn.closed = closed;
        drawn_.push_back(drawn);
    }
}

float HatchSpans::at(const Place& place) const noexcept {
    const std::int64_t next = std::min(place.mark + 1, length_.size() - 1);
    return length_[place.mark] + place.share * (length_[next] - length_[place.mark]);
}

HatchSpans::Place HatchSpans::place_at(float length) const noexcept {
    const float* const next = std::upper_bound(length_.begin() + 1, length_.end() - 1, length);
    const std::int64_t mark = next - length_.begin() - 1;
    const float way = *next - length_[mark];
    return {mark, way > 0.0F ? std::clamp((length - length_[mark]) / way, 0.0F, 1.0F) : 0.0F};
}

// From where a line ends by its tone on, backwards (way -1) or forwards (1), until it ends for another reason.
HatchSpans::Place HatchSpans::run_on(std::span<const HatchMark> marks, const Place& from, int way,
                                     HatchEnd& end) const noexcept {
    const auto all = static_cast<std::int64_t>(marks.size());
    const float first = at(from);
    const float farthest = hand_.beyond(static_cast<double>(from.mark + turned_) + static_cast<double>(from.share));
    std::int64_t next = way > 0 || from.share == 0.0F ? from.mark + way : from.mark;
    for (; next >= 0 && next < all; next += way) {
        const auto i = static_cast<std::size_t>(next);
        const HatchMark& last = marks[static_cast<std::size_t>(next - way)];
        const Crossing other = crossing(last, marks[i], HatchEnd::level);
        const bool ends = !marks[i].valid || marks[i].margin[static_cast<std::size_t>(other.end)] < 0.0F;
        const float here = length_[next - way] + (ends ? other.share : 1.0F) * (length_[next] - length_[next - way]);
        if (std::abs(here - first) >= farthest) return place_at(first + static_cast<float>(way) * farthest);
        if (!ends) continue;
        end = other.end;
        return place_at(here);
    }
    return {next < 0 ? 0 : all - 1, 0.0F};
}

// As a quick hand does.
void HatchSpans::overshoot(std::span<const HatchMark> marks) {
    for (Drawn& drawn : drawn_) {
        if (drawn.begins == HatchEnd::tone) drawn.begin = run_on(marks, drawn.begin, -1, drawn.begins);
        if (drawn.ends == HatchEnd::tone) drawn.end = run_on(marks, drawn.end, 1, drawn.ends);
    }
}

HatchSpans::Gap HatchSpans::gap_before(std::int64_t number) const noexcept {
    Gap gap{0.0F, 0.0F};
    float weight = 1.0F;
    for (std::int64_t i = number; weight > 0.0F; weight *= 1.0F - drawn_[--i].firm) {
        if (i == 0) return {gap.length + weight * beyond_all, std::max(gap.open, weight)};
        const float from = i == number ? at(drawn_[i].begin) : at(drawn_[i].end);
        gap.length += weight * (from - at(drawn_[i - 1].end));
        gap.open = std::max(gap.open, weight * drawn_[i].open);
    }
    return gap;
}

HatchSpans::Gap HatchSpans::gap_after(std::int64_t number) const noexcept {
    Gap gap{0.0F, 0.0F};
    float weight = 1.0F;
    for (std::int64_t i = number; weight > 0.0F; weight *= 1.0F - drawn_[++i].firm) {
        if (i + 1 == drawn_.size()) return {gap.length + weight * beyond_all, std::max(gap.open, weight)};
        const float from = i == number ? at(drawn_[i].end) : at(drawn_[i].begin);
        gap.length += weight * (at(drawn_[i + 1].begin) - from);
        gap.open = std::max(gap.open, weight * drawn_[i + 1].open);
    }
    return gap;
}

// Gaps that are no longer than they are wide look like mistakes.  They open little by little: up to half of that they
// are closed, then the line is the thinner there the longer they are.
void HatchSpans::join(const LayerStyle& style, std::span<const HatchMark> marks) {
    const auto width = [&](const Place& place) { return point(marks, place).width; };
    const auto may = [](HatchEnd end) { return end == HatchEnd::tone || end == HatchEnd::level; };
    for (std::int64_t i = 1; i < drawn_.size(); ++i) {
        const Drawn& last = drawn_[i - 1];
        Drawn& next = drawn_[i];
        if (!may(last.ends) || !may(next.begins)) {
            next.open = 1.0F;
            next.closes = least_gap * width(may(last.ends) ? last.end : next.begin);
            continue;
        }
        const float longest = 0.5F * least_gap * (width(last.end) + width(next.begin));
        const float gap = at(next.begin) - at(last.end);
        next.closes = longest;
        if (gap < longest) next.link = std::min(2.0F * (1.0F - gap / longest), 1.0F);
        const float range = 0.5F * longest + fading_gap * style.hatch_shortest;
        next.near = std::clamp(std::max((longest + range - gap) / range, 1.0F - next.open), 0.0F, 1.0F);
    }
    for (std::int64_t i = 0; i < drawn_.size(); ++i) drawn_[i].fade = fade_of(i, style.hatch_shortest);
    for (std::int64_t i = drawn_.size() - 2; i >= 0; --i)
        if (drawn_[i + 1].link > 0.0F && drawn_[i].fade > 0.0F && drawn_[i + 1].fade > 0.0F)
            drawn_[i].joined = 1 + drawn_[i + 1].joined;
}

// Short parts are thin, and shorter ones are left out, but those that were one with a longer one before a gap opened
// between them: they fade while it grows.
float HatchSpans::fade_of(std::int64_t number, float shortest) const noexcept {
    if (!(shortest > 0.0F)) return 1.0F;
    float most = 0.0F;
    float before = 1.0F;
    for (std::int64_t first = number; first >= 0 && before > most; before = std::min(before, drawn_[first--].near)) {
        float near = before;
        for (std::int64_t last = number; last < drawn_.size(); ++last) {
            if (last > number) near = std::min(near, drawn_[last].near);
            if (!(near > most)) break;
            const float length = at(drawn_[last].end) - at(drawn_[first].begin);
            const float fills = std::min(drawn_[first].begins_by.alone, drawn_[last].ends_by.alone);
            const float least = std::lerp(1.0F, shortest_filling, fills) * shortest;
            if (length >= least) most = std::max(most, near * smooth(length / least - 1.0F));
        }
    }
    return most;
}

// next: the part behind the gap that the end is at.  A taper is shorter beside a gap that is about to be closed.
float HatchSpans::taper(const LayerStyle& style, HatchEnd end, std::int64_t next, const Gap& gap) const noexcept {
    const float longest = end == HatchEnd::tone ? style.hatch_taper : blunt * style.hatch_taper;
    switch (end) {
    case HatchEnd::picture: return 0.0F;
    case HatchEnd::line: return longest;
    case HatchEnd::rim: return longest;
    default: break;
    }
    const float closes = next == 0 || next == drawn_.size() ? 0.0F : drawn_[next].closes;
    return std::clamp(gap.length - closes, 0.0F, longest * gap.open);
}

// 1 where the line goes along the contour that it ends at, 0 where it goes across.  The contour's image is normal to
// that of the surface's normal.  All lines touch it in the end [Koenderink 1984], so a longer part of the line tells.
float HatchSpans::along_rim(const LayerStyle& style, std::span<const HatchMark> marks, const Place& place,
                            std::int64_t inward) const noexcept {
    std::int64_t i = place.mark + (inward > 0 ? 1 : 0);
    const float from = at(place);
    while (i + inward >= 0 && i + inward < length_.size() && marks[static_cast<std::size_t>(i + inward)].is_drawn() &&
           std::abs(length_[i] - from) < rim_part * style.hatch_taper)
        i += inward;
    const HatchPoint end = point(marks, place);
    const HatchMark& mark = marks[static_cast<std::size_t>(place.mark)];
    const glm::vec2 chord(marks[static_cast<std::size_t>(i)].x - end.x, marks[static_cast<std::size_t>(i)].y - end.y);
    const glm::vec2 normal(mark.side_x, -mark.side_y);
    const float lengths = glm::length(chord) * glm::length(normal);
    const float sine = lengths > 0.0F ? std::abs(glm::dot(chord, normal)) / lengths : 0.0F;
    return std::clamp((crosses - sine) / (crosses - runs_along), 0.0F, 1.0F);
}

// Where a line ends by its level and another margin runs out, too, it ends as by that: which of them is the first
// changes with the view.
float HatchSpans::taper_begin(const LayerStyle& style, std::span<const HatchMark> marks,
                              std::int64_t number) const noexcept {
    const Drawn& drawn = drawn_[number];
    const auto as = [&](HatchEnd end) {
        const float along = end == HatchEnd::rim ? along_rim(style, marks, drawn.begin, 1) : 1.0F;
        return along * taper(style, end, number, gap_before(number));
    };
    if (drawn.begins != HatchEnd::level || drawn.begins_by.alone == 1.0F) return as(drawn.begins);
    return std::lerp(as(drawn.begins_by.other), as(HatchEnd::level), drawn.begins_by.alone);
}

float HatchSpans::taper_end(const LayerStyle& style, std::span<const HatchMark> marks,
                            std::int64_t number) const noexcept {
    const Drawn& drawn = drawn_[number];
    const auto as = [&](HatchEnd end) {
        const float along = end == HatchEnd::rim ? along_rim(style, marks, drawn.end, -1) : 1.0F;
        return along * taper(style, end, number + 1, gap_after(number));
    };
    if (drawn.ends != HatchEnd::level || drawn.ends_by.alone == 1.0F) return as(drawn.ends);
    return std::lerp(as(drawn.ends_by.other), as(HatchEnd::level), drawn.ends_by.alone);
}

void HatchSpans::put(const LayerStyle& style, std::span<const HatchMark> marks, std::int64_t number, HatchPart& part) {
    const Drawn& drawn = drawn_[number];
    const std::int64_t next = number + drawn.joined;
    const Drawn& last = drawn_[next - 1];
    const float begin = at(drawn.begin);
    const float length = at(last.end) - begin;
    if (!(length > 0.0F && drawn.fade > 0.0F)) return;
    HatchSpan span;
    span.first = part.points.size();
    span.count = 1 + static_cast<std::int32_t>(std::ceil(length / point_step));
    span.closed = drawn.closed;
    if (drawn.joined == 1) span.fade = drawn.fade;
    if (!drawn.closed) {
        span.taper_begin = taper_begin(style, marks, number);
        span.taper_end = taper_end(style, marks, next - 1);
    }
    add_points(marks, number, span.count, part.points);
    part.spans.push_back(span);
}

// Of parts that are joined: how wide the line is at that length, where it is in the one of that number or behind it.
float HatchSpans::joined_fade(std::int64_t first, std::int64_t& part, float length) const noexcept {
    const std::int64_t last = first + drawn_[first].joined - 1;
    while (part < last && length >= at(drawn_[part + 1].begin)) ++part;
    const Drawn& own = drawn_[part];
    if (part == last || length <= at(own.end)) return own.fade;
    return std::min(own.fade, drawn_[part + 1].fade) * drawn_[part + 1].link;
}

// At even steps along the chords.
void HatchSpans::add_points(std::span<const HatchMark> marks, std::int64_t number, std::int32_t count,
                            base::Array<HatchPoint>& points) const {
    const Drawn& drawn = drawn_[number];
    const Place& end = drawn_[number + drawn.joined - 1].end;
    const float begin = at(drawn.begin);
    const float step = (at(end) - begin) / static_cast<float>(count - 1);
    const std::int64_t last = length_.size() - 2;
    std::int64_t part = number;
    const auto put = [&](const Place& place, float length) {
        points.push_back(point(marks, place));
        if (drawn.joined > 1) points.back().width *= joined_fade(number, part, length);
        stray(marks, points.back(), place);
    };
    Place place = drawn.begin;
    for (std::int32_t i = 0; i + 1 < count; ++i) {
        const float wanted = begin + step * static_cast<float>(i);
        while (place.mark < last && length_[place.mark + 1] < wanted) ++place.mark;
        const float way = length_[place.mark + 1] - length_[place.mark];
        place.share = way > 0.0F ? std::clamp((wanted - length_[place.mark]) / way, 0.0F, 1.0F) : 0.0F;
        put(place, wanted);
    }
    put(end, at(end));
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
    const glm::vec2 p = u * u * (1.0F + 2.0F * t) * place(a) + t * t * (3.0F - 2.0F * t) * place(b) +
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
