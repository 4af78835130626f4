// SPDX-License-Identifier: MIT
#include "frame/depth_layers/hatch_spans.h"

#include "base/scratch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// Gaps of fewer widths are closed.
constexpr float least_gap = 2.0F;
// Short parts fade while a gap beside them grows by so much, in the length of the shortest.
constexpr float fading_gap = 0.25F;
// A line's end where its stroke or its level ends is this much as long as where its tone ends ...
constexpr float blunt = 0.35F;
// ... and where its stroke ends at a crease it only rounds off, over so many widths: the face is dark up to its edge.
constexpr float round_tip = 0.5F;
// Where the surface turns away a line that crosses the contour by at least the first of these sines runs on under it,
// and one that hardly does, by the second, narrows before it.
constexpr float crosses = 0.5F;
constexpr float runs_along = 0.25F;
// Where a stroke ends and its level has so much room left, in pens, that has nothing to do with the end.
constexpr float level_left = 0.4F;
constexpr float length_steps = 1024.0F; // of a pixel
constexpr float beyond_all = 1000.0F;   // a gap longer than any taper, pixels
constexpr float rim_part = 0.5F;        // of a taper: so much of the line is looked at
// A line that ends beside a gap narrows over at least this, pixels: a shorter taper would lie between two points.
constexpr float least_taper = hatch_point_step;
// A gap that is no longer than this is as open as its marks say, pixels; one of twice that is open.
constexpr float hardly_gap = 5.0F;

struct Crossing {
    float share; // of the way from the mark that is drawn to the one that is not
    HatchEnd end;
};

// Where the first margin runs out, of those from one on, margins changing evenly.
[[nodiscard]] Crossing crossing(const HatchMark& drawn, const HatchMark& other,
                                HatchEnd from = HatchEnd::tone) noexcept {
    if (!other.is_valid()) return {0.0F, HatchEnd::picture};
    Crossing first{1.0F, HatchEnd::picture};
    for (auto k = static_cast<std::size_t>(from); k < hatch_margins; ++k) {
        if (other.margin[k] >= 0.0F) continue;
        const float share = drawn.margin[k] / (drawn.margin[k] - other.margin[k]);
        if (share <= first.share) first = {share, static_cast<HatchEnd>(k)};
    }
    return first;
}

[[nodiscard]] float blunt_taper(const LayerStyle& style) noexcept { return blunt * style.hatch_taper; }

[[nodiscard]] glm::vec2 place_of(const HatchMark& m) noexcept { return {m.x, m.y}; }

[[nodiscard]] float firmness(const HatchMark& m) noexcept { return hatch_firmness(m.margin[0], m.margin[1]); }

// 0 where a part beside a gap is about to vanish, 1 where the gap is about to close.
[[nodiscard]] float lasting(float firm, float open) noexcept {
    return firm < 1.0F && open > 0.0F ? firm / (firm + open) : 1.0F;
}

// A mark in the gap of a closed line that is the least likely to be closed: there it begins.  Gaps count by how open
// they are, and up to so many pixels by their length.
[[nodiscard]] std::int64_t widest_gap(std::span<const HatchMark> marks) noexcept {
    constexpr float longest = 50.0F;
    const std::size_t count = marks.size() - 1; // the last one is the first
    const auto m = [&](std::size_t i) -> const HatchMark& { return marks[i % count]; };
    std::size_t first = 0; // from a part on, so that no gap is cut
    while (!m(first).is_drawn()) ++first;
    std::size_t widest = first;
    float most = -1.0F;
    float length = 0.0F;
    float open = 0.0F;
    for (std::size_t i = first; i <= first + count; ++i) {
        length += m(i).way;
        open = std::max(open, m(i).passed);
        if (!m(i).is_drawn()) {
            open = std::max(open, m(i).openness());
            continue;
        }
        const float score = open * (1.0F + std::min(length, longest));
        if (!m(i + count - 1).is_drawn() && score > most) {
            most = score;
            widest = i + count - 1;
        }
        length = open = 0.0F;
    }
    return static_cast<std::int64_t>(widest % count);
}

[[nodiscard]] float smooth(float x) noexcept {
    const float at = std::clamp(x, 0.0F, 1.0F);
    return at * at * (3.0F - 2.0F * at);
}

} // namespace

void HatchSpans::add(const LayerStyle& style, std::int64_t number, HatchStroke& stroke, HatchPart& part) {
    const std::span<HatchMark> marks = stroke.mark.span();
    const bool closed = stroke.closed;
    const auto is_drawn = [](const HatchMark& m) { return m.is_drawn(); };
    if (std::none_of(marks.begin(), marks.end(), is_drawn)) return;
    const bool whole = std::all_of(marks.begin(), marks.end(), is_drawn);
    turned_ = closed && !whole ? widest_gap(marks) : 0;
    if (closed && !whole) {
        std::rotate(marks.begin(), marks.begin() + turned_, marks.end() - 1);
        marks.back() = marks.front();
    }
    measure(marks);
    find(stroke, closed && whole);
    const std::int64_t steps = length_.size() - 1;
    hand_ = HatchHand(style, number, closed ? steps : 0, length_[steps] / static_cast<float>(steps));
    if (hand_.overshoots()) overshoot(marks);
    join(style, marks);
    for (std::int64_t i = 0; i < drawn_.size(); i += drawn_[i].joined) put(style, marks, i, part);
}

// Lengths of chords, in steps that sum up exactly: parts have the same points whatever lies before them.
void HatchSpans::measure(std::span<const HatchMark> marks) {
    const auto count = static_cast<std::int64_t>(marks.size());
    base::resize_scratch(length_, count);
    length_[0] = 0.0F;
    for (std::int64_t i = 1; i < count; ++i) {
        const float way = marks[static_cast<std::size_t>(i)].way;
        length_[i] = length_[i - 1] + std::trunc(way * length_steps + 0.5F) / length_steps;
    }
    const HatchMark& first = marks.front();
    const HatchMark& last = marks.back();
    goes_round_ = first.is_valid() && last.is_valid() && place_of(first) == place_of(last);
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
    return {hatch_level_alone(tone, rim), tone < rim ? HatchEnd::tone : HatchEnd::rim, 1.0F};
}

// Where a stroke ends, and its level may soon end the line just before.
HatchSpans::ByLevel HatchSpans::by_level(const HatchMark& last) noexcept {
    ByLevel by = by_level(last, last, HatchEnd::level, 0.0F);
    const float left = last.margin[static_cast<std::size_t>(HatchEnd::level)];
    by.near = smooth(1.0F - left / level_left);
    return by;
}

void HatchSpans::find(const HatchStroke& stroke, bool closed) {
    drawn_.clear();
    const std::int64_t count = stroke.mark.size();
    const auto m = [&](std::int64_t i) -> const HatchMark& { return stroke.mark[i]; };
    float open = 0.0F;
    float alone = 1.0F;
    for (std::int64_t i = 0; i < count; ++i) {
        if (!m(i).is_drawn()) {
            open = std::max({open, m(i).openness(), m(i).passed});
            alone = std::min({alone, hatch_level_alone(m(i).margin[0], m(i).margin[2]), m(i).passed_alone});
            continue;
        }
        Drawn drawn;
        drawn.open = std::exchange(open, 0.0F);
        drawn.level_gap = std::exchange(alone, 1.0F);
        drawn.begin = {i, 0.0F};
        if (i == 0) {
            drawn.begins = stroke.begins;
            drawn.begins_by = by_level(m(i));
        } else {
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
        if (i + 1 == count) {
            drawn.ends = stroke.ends;
            drawn.ends_by = by_level(m(i));
        } else {
            const Crossing end = crossing(m(i), m(i + 1));
            drawn.end = {i, end.share};
            drawn.ends = end.end;
            drawn.ends_by = by_level(m(i), m(i + 1), end.end, end.share);
        }
        drawn.closed = closed;
        drawn_.push_back(drawn);
    }
}

// A part's length is that of as much ink of its greatest width: so a hairline that joins it, or leaves it, changes
// little, and one that is a hairline all along is long enough as soon as it appears.  From half a pen on all widths
// count alike.
void HatchSpans::weigh(const LayerStyle& style, std::span<const HatchMark> marks, Drawn& drawn) const noexcept {
    const float full_width = 0.5F * style.hatch_pen;
    const float most = 2.0F * style.hatch_shortest * full_width;
    const auto weight = [&](float width, float level) {
        drawn.widest = std::max(drawn.widest, width);
        return width * (1.0F / shortest_filling + (1.0F - 1.0F / shortest_filling) * std::clamp(level, 0.0F, 1.0F));
    };
    const auto width_of = [&](const HatchMark& mark) { return std::min(mark.width, full_width); };
    constexpr auto level = static_cast<std::size_t>(HatchEnd::level);
    const auto at_place = [&](const Place& place_of) {
        const auto i = static_cast<std::size_t>(place_of.mark);
        const HatchMark& a = marks[i];
        if (place_of.share == 0.0F) return weight(width_of(a), a.margin[level]);
        const HatchMark& b = marks[i + 1];
        return weight(std::lerp(width_of(a), width_of(b), place_of.share),
                      std::lerp(a.margin[level], b.margin[level], place_of.share));
    };
    float from = at(drawn.begin);
    float before = at_place(drawn.begin);
    for (std::int64_t i = drawn.begin.mark + 1; i <= drawn.end.mark && drawn.area < most; ++i) {
        const HatchMark& mark = marks[static_cast<std::size_t>(i)];
        const float own = weight(width_of(mark), mark.margin[level]);
        drawn.area += 0.5F * (length_[i] - from) * (before + own);
        before = own;
        from = length_[i];
    }
    if (drawn.area < most) drawn.area += 0.5F * (at(drawn.end) - from) * (before + at_place(drawn.end));
}

float HatchSpans::at(const Place& place_of) const noexcept {
    const std::int64_t next = std::min(place_of.mark + 1, length_.size() - 1);
    return length_[place_of.mark] + place_of.share * (length_[next] - length_[place_of.mark]);
}

// Of a part, as it is drawn there: the mean over the step from one point to the next.
float HatchSpans::width_at_begin(std::span<const HatchMark> marks, const Drawn& drawn) const noexcept {
    const float begin = at(drawn.begin);
    const float step = std::min(at(drawn.end) - begin, hatch_point_step);
    return step > 0.0F ? area(marks, drawn.begin, place_at(begin + step)) / step : 0.0F;
}

float HatchSpans::width_at_end(std::span<const HatchMark> marks, const Drawn& drawn) const noexcept {
    const float end = at(drawn.end);
    const float step = std::min(end - at(drawn.begin), hatch_point_step);
    return step > 0.0F ? area(marks, place_at(end - step), drawn.end) / step : 0.0F;
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
        const bool ends = !marks[i].is_valid() || marks[i].margin[static_cast<std::size_t>(other.end)] < 0.0F;
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
    const auto may = [](HatchEnd end) { return end == HatchEnd::tone || end == HatchEnd::level; };
    for (std::int64_t i = 1; i < drawn_.size(); ++i) {
        const Drawn& last = drawn_[i - 1];
        Drawn& next = drawn_[i];
        if (!may(last.ends) || !may(next.begins)) {
            next.open = 1.0F;
            next.closes = least_gap * (may(last.ends) ? width_at_end(marks, last) : width_at_begin(marks, next));
            continue;
        }
        const float longest = 0.5F * least_gap * (width_at_end(marks, last) + width_at_begin(marks, next));
        const float gap = at(next.begin) - at(last.end);
        next.closes = longest;
        // One of a tone grows as the picture does, and what was drawn in it would go.
        const float stays = next.level_gap * lasting(std::min(last.firm, next.firm), next.open);
        const float hardly = (1.0F - next.open) * stays * std::clamp(2.0F - gap / hardly_gap, 0.0F, 1.0F);
        next.link = std::clamp(std::max(2.0F * (1.0F - gap / longest), hardly), 0.0F, 1.0F);
        const float range = 0.5F * longest + fading_gap * style.hatch_shortest;
        next.near = std::clamp(std::max((longest + range - gap) / range, 1.0F - next.open), 0.0F, 1.0F);
    }
    for (Drawn& drawn : drawn_) weigh(style, marks, drawn);
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
    float before = 1.0F; // how much the parts from `first` to this one are one
    float area_before = 0.0F;
    float widest_before = 0.0F;
    for (std::int64_t first = number; first >= 0 && before > most; before = std::min(before, drawn_[first--].near)) {
        area_before += drawn_[first].area;
        widest_before = std::max(widest_before, drawn_[first].widest);
        float near = before;
        float area = area_before;
        float widest = widest_before;
        for (std::int64_t last = number; last < drawn_.size(); ++last) {
            if (last > number) {
                near = std::min(near, drawn_[last].near);
                area += drawn_[last].area;
                widest = std::max(widest, drawn_[last].widest);
            }
            if (!(near > most)) break;
            if (area > shortest * widest) most = std::max(most, near * smooth(area / (shortest * widest) - 1.0F));
        }
    }
    return most;
}

// next: the part behind the gap that the end is at.  A taper is shorter beside a gap that is about to be closed.
float HatchSpans::taper(const LayerStyle& style, HatchEnd end, std::int64_t next, const Gap& gap) const noexcept {
    const float longest = end == HatchEnd::tone ? style.hatch_taper : blunt_taper(style);
    switch (end) {
    case HatchEnd::picture: return 0.0F;
    case HatchEnd::line: return longest;
    case HatchEnd::rim: return longest;
    default: break;
    }
    const float closes = next == 0 || next == drawn_.size() ? 0.0F : drawn_[next].closes;
    return std::max(std::clamp(gap.length - closes, 0.0F, longest * gap.open), least_taper);
}

// 1 where the line goes along the contour that it ends at, 0 where it goes across.  The contour's image is normal to
// that of the surface's normal.  All lines touch it in the end [Koenderink 1984], so a longer part of the line tells.
float HatchSpans::along_rim(const LayerStyle& style, std::span<const HatchMark> marks, const Place& place_of,
                            std::int64_t inward) const noexcept {
    std::int64_t i = place_of.mark + (inward > 0 ? 1 : 0);
    const float from = at(place_of);
    while (i + inward >= 0 && i + inward < length_.size() && marks[static_cast<std::size_t>(i + inward)].is_drawn() &&
           std::abs(length_[i] - from) < rim_part * style.hatch_taper)
        i += inward;
    const HatchPoint end = point(marks, place_of);
    const HatchMark& mark = marks[static_cast<std::size_t>(place_of.mark)];
    const glm::vec2 chord(marks[static_cast<std::size_t>(i)].x - end.x, marks[static_cast<std::size_t>(i)].y - end.y);
    const glm::vec2 normal(mark.side_x, -mark.side_y);
    const float lengths = glm::length(chord) * glm::length(normal);
    const float sine = lengths > 0.0F ? std::abs(glm::dot(chord, normal)) / lengths : 0.0F;
    return std::clamp((crosses - sine) / (crosses - runs_along), 0.0F, 1.0F);
}

// Where a line ends by its level and another margin runs out, too, it ends as by that: which of them is the first
// changes with the view.  So does whether its stroke ends first.
template <class As>
float HatchSpans::mixed_taper(HatchEnd end, const ByLevel& by, const As& as) noexcept {
    if (by.near == 0.0F) return as(end);
    const float level = by.alone == 1.0F ? as(HatchEnd::level) : std::lerp(as(by.other), as(HatchEnd::level), by.alone);
    return by.near == 1.0F ? level : std::lerp(as(end), level, by.near);
}

float HatchSpans::taper_begin(const LayerStyle& style, std::span<const HatchMark> marks,
                              std::int64_t number) const noexcept {
    const Drawn& drawn = drawn_[number];
    const auto as = [&](HatchEnd end) {
        if (end == HatchEnd::crease) return std::min(round_tip * width_at_begin(marks, drawn), blunt_taper(style));
        const float along = end == HatchEnd::rim ? along_rim(style, marks, drawn.begin, 1) : 1.0F;
        return along * taper(style, end, number, gap_before(number));
    };
    return mixed_taper(drawn.begins, drawn.begins_by, as);
}

float HatchSpans::taper_end(const LayerStyle& style, std::span<const HatchMark> marks,
                            std::int64_t number) const noexcept {
    const Drawn& drawn = drawn_[number];
    const auto as = [&](HatchEnd end) {
        if (end == HatchEnd::crease) return std::min(round_tip * width_at_end(marks, drawn), blunt_taper(style));
        const float along = end == HatchEnd::rim ? along_rim(style, marks, drawn.end, -1) : 1.0F;
        return along * taper(style, end, number + 1, gap_after(number));
    };
    return mixed_taper(drawn.ends, drawn.ends_by, as);
}

} // namespace hrbfnpr::frame
