// SPDX-License-Identifier: MIT
#include "frame/lines/hugging_parts.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

// In widths.
constexpr double longest = 5.0;
constexpr double beside = 0.3;
constexpr double steps = 0.2;

} // namespace

HuggingParts::HuggingParts(base::Memory& memory, const LineInput& input) : input_(input), seen_(memory), hugs_(memory) {
    for (const DrawnAs& as : input.styles) width_ = std::max(width_, static_cast<double>(as.style->width));
    if (!(width_ > 0.0)) return;
    const base::Array<visibility::Interval>& intervals = input.found.intervals;
    const auto may = [&](const visibility::Interval& interval) { return may_hug(interval); };
    if (std::none_of(intervals.begin(), intervals.end(), may)) return;
    for (const visibility::Interval& interval : intervals)
        if (interval.sheets <= 0 && is_contour(interval))
            walk(interval, [&](const glm::dvec2& place) {
                seen_.push_back(place);
                return true;
            });
    std::sort(seen_.begin(), seen_.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x; });
    hugs_.resize(intervals.size());
    for (std::int64_t i = 0; i < intervals.size(); ++i) {
        if (!may_hug(intervals[i])) continue;
        bool all = true;
        walk(intervals[i], [&](const glm::dvec2& place) { return all = all && is_beside(place); });
        hugs_[i] = all ? 1 : 0;
    }
}

bool HuggingParts::is_contour(const visibility::Interval& interval) const noexcept {
    const visibility::Line& line = input_.found.lines.lines[interval.line];
    const visibility::Subject& subject = input_.subjects[static_cast<std::size_t>(line.subject)];
    return subject.joined && subject.sheets == 2;
}

bool HuggingParts::may_hug(const visibility::Interval& interval) const noexcept {
    return interval.sheets > 0 && interval.end_at - interval.begin_at < longest * width_ && is_contour(interval);
}

template <class F>
void HuggingParts::walk(const visibility::Interval& interval, F&& f) const {
    const visibility::Line& line = input_.found.lines.lines[interval.line];
    const auto at = [&](std::int64_t i) { return input_.lengths.at_point(line.first_point + i); };
    const auto place = [&](std::int64_t i) { return input_.found.lines.points[line.first_point + i].place; };
    const double whole = input_.lengths.whole(line);
    const double step = steps * width_;
    std::int64_t i = 0;
    for (double way = interval.begin_at; way < interval.end_at + step; way += step) {
        double here = std::min(way, interval.end_at);
        if (here > whole) here -= whole; // round a closed line
        if (at(i) > here) i = 0;
        while (i + 2 < line.points && at(i + 1) < here) ++i;
        const double chord = at(i + 1) - at(i);
        const double share = chord > 0.0 ? std::clamp((here - at(i)) / chord, 0.0, 1.0) : 0.0;
        if (!f(glm::mix(place(i), place(i + 1), share))) return;
    }
}

bool HuggingParts::is_beside(const glm::dvec2& place) const noexcept {
    const auto before = [](const glm::dvec2& a, double x) { return a.x < x; };
    for (const glm::dvec2* p = std::lower_bound(seen_.begin(), seen_.end(), place.x - beside * width_, before);
         p != seen_.end() && p->x <= place.x + beside * width_; ++p)
        if (glm::distance(*p, place) <= beside * width_) return true;
    return false;
}

} // namespace hrbfnpr::frame
