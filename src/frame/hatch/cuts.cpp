// SPDX-License-Identifier: MIT
#include "frame/hatch/cuts.h"

#include <algorithm>

namespace hrbfnpr::frame {
namespace {

// Points before the one that is seen last from which an edge is looked for, at least, and from where that is no farther
// away than this, pixels.
constexpr std::int64_t points_before = 2;
constexpr float off_edge = 1.5F;
// Points are hidden wrongly up to so much farther from an edge than a splat's radius, pixels; and not beyond this.
constexpr float beyond_splat = 1.0F;
constexpr float farthest_hidden = 24.0F;

} // namespace

bool HatchCuts::is_near(std::int64_t i, float reach) const noexcept {
    return hiding_.edges.is_near(dot(i), reach, halo_);
}

float HatchCuts::reach_of_splats(std::int64_t i) const noexcept {
    return std::min(hiding_.largest_splat_at(dot(i)) + beyond_splat, farthest_hidden);
}

// Whether a hidden point may be seen after all: the edge of what hides it is so near that a splat reaches beyond it.
bool HatchCuts::may_be_seen(std::int64_t i) const noexcept { return is_near(i, reach_of_splats(i)); }

// Whether no edge is passed from the point before a gap to the one behind it, and its points are hidden all the same:
// by splats that reach so far, also of their own surface near a crease.
bool HatchCuts::by_nothing(const Gap& gap) const noexcept {
    const bool is_short = length_[gap.end - 1] - length_[gap.first] <= reach_of_splats(gap.first);
    for (std::int64_t i = gap.first; i < gap.end; ++i)
        if (!is_short && !may_be_seen(i)) return false;
    for (std::int64_t i = std::max<std::int64_t>(gap.first - 1, 0); i < std::min(gap.end, size() - 1); ++i)
        if (hiding_.edges.entry(dot(i), dot(i + 1), halo_) <= 1.0F) return false;
    return true;
}

void HatchCuts::show(std::int64_t first, std::int64_t end) noexcept {
    const float opacity = dot(first > 0 ? first - 1 : end).opacity;
    for (std::int64_t i = first; i < end; ++i) dot(i).opacity = opacity;
}

// From the point that is seen last, back to one that no edge is near to.
std::int64_t HatchCuts::begin_of_search(std::int64_t last, std::int64_t way, std::int64_t limit) const noexcept {
    std::int64_t i = last;
    while (i != limit && ((last - i) * way < points_before || is_near(i, off_edge))) i -= way;
    return i;
}

// last: the point that is seen last, going that way (1 or -1).
HatchCut HatchCuts::search(std::int64_t last, std::int64_t way, std::int64_t first_seen,
                           std::int64_t last_hidden) const noexcept {
    for (std::int64_t i = begin_of_search(last, way, first_seen); i != last_hidden; i += way) {
        if ((i - last) * way > 0 && !may_be_seen(i)) break;
        const float share = hiding_.edges.entry(dot(i), dot(i + way), halo_);
        if (share <= 1.0F) return {std::min(i, i + way), length_[i] + share * (length_[i + way] - length_[i])};
    }
    return {};
}

void HatchCuts::apply(const HatchCut& cut, std::int64_t last, std::int64_t way) noexcept {
    const std::int64_t end = way > 0 ? cut.before : cut.before + 1; // seen last from now on
    const float opacity = dot(last).opacity;
    for (std::int64_t i = last; (end - i) * way > 0; i += way) dot(i + way).opacity = opacity;
    for (std::int64_t i = last; (i - end) * way > 0; i -= way) dot(i).opacity = 0.0F;
    cuts_.push_back(cut);
}

// Returns where the points behind the gap begin that are seen.
std::int64_t HatchCuts::mend(const Gap& gap) {
    HatchCut ends, begins;
    if (gap.first > gap.seen) ends = search(gap.first - 1, 1, (gap.seen + gap.first - 1) / 2, gap.end - 1);
    if (gap.end < size()) begins = search(gap.end, -1, (gap.end + gap.next - 1) / 2, gap.first);
    const bool touched = ends.any() && begins.any() && !(ends.before < begins.before);
    if (touched || (!ends.any() && !begins.any())) {
        if (!touched && (gap.end - gap.first == size() || !by_nothing(gap))) return gap.end;
        show(gap.first, gap.end);
        return gap.seen;
    }
    if (ends.any()) apply(ends, gap.first - 1, 1);
    if (!begins.any()) return gap.end;
    apply(begins, gap.end, -1);
    return begins.before + 1;
}

void HatchCuts::find() {
    cuts_.clear();
    std::int64_t begin = 0;
    for (std::int64_t i = 0; i < size(); ++i) {
        if (seen(i)) continue;
        Gap gap{begin, i, i, i};
        while (gap.end < size() && !seen(gap.end)) ++gap.end;
        gap.next = gap.end;
        while (gap.next < size() && seen(gap.next)) ++gap.next;
        begin = mend(gap);
        i = std::max(begin, gap.end) - 1;
    }
}

} // namespace hrbfnpr::frame
