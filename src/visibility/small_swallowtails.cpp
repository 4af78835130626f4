// SPDX-License-Identifier: MIT
#include "visibility/small_swallowtails.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::visibility {
namespace {

// Branches of a group cross within so many of its sizes.
constexpr double branches = 8.0;

} // namespace

// Along the line, by the shorter way around a closed one.
double SmallSwallowtails::from_begin(const Group& group, double at) const noexcept {
    const double way = at - group.begin;
    return line_.closed ? way - whole() * std::round(way / whole()) : way;
}

bool SmallSwallowtails::within(const Group& group, double at, double beside) const noexcept {
    const double low = group.begin - beside;
    const double high = group.end + beside;
    return (at >= low && at <= high) ||
           (line_.closed && (at + whole() <= high || (at - whole() >= low && at - whole() <= high)));
}

// Around a closed line beginning behind a gap, so that no group is cut in two.
void SmallSwallowtails::find_groups(std::span<const Event> events) {
    const std::int64_t count = cusps_.size();
    const auto at = [&](std::int64_t i) {
        return events[static_cast<std::size_t>(cusps_[i % count])].at + (i >= count ? whole() : 0.0);
    };
    std::int64_t first = 0;
    if (line_.closed)
        while (first < count && at(first + count) - at(first + count - 1) <= size_) ++first;
    if (first == count) first = 0;
    for (std::int64_t i = first; i < first + count;) {
        std::int64_t end = i + 1;
        while (end < first + count && at(end) - at(end - 1) <= size_) ++end;
        if (end - i > 1) {
            const double before = i > 0 ? at(i) - at(i - 1) : line_.closed ? at(i) + whole() - at(count - 1) : whole();
            const double after = end < count || line_.closed ? at(end) - at(end - 1) : whole();
            groups_.push_back({at(i), at(end - 1), before, after, (end - i) % 2 != 0, cusps_[(end - 1) % count]});
        }
        i = end;
    }
}

// Crossings of the branches before a group with those behind it, and within it: the loops that begin and end there have
// cusps of the group, and none of others.
bool SmallSwallowtails::crosses_itself(const Group& group, const Event& e) const noexcept {
    if (e.near_piece < line_.first_piece || e.near_piece >= line_.first_piece + line_.pieces) return false;
    const double far = from_begin(group, e.at);
    const double near = from_begin(group, lengths_.at(line_, e.near_piece, e.near_share));
    const double length = group.end - group.begin;
    const double first = std::min(far, near);
    const double last = std::max(far, near);
    return first > -std::min(group.before, branches * size_) && first < length && last > 0.0 &&
           last < length + std::min(group.after, branches * size_);
}

// Together, all changes of a group are those of a smooth contour, or of one cusp.
bool SmallSwallowtails::adds_up(const Group& group, std::span<const Event> events) const noexcept {
    std::int32_t change = group.odd ? -events[static_cast<std::size_t>(group.last)].change : 0;
    for (const Event& e : events)
        if (e.near_piece < 0 ? is_cusp_of(group, e) : crosses_itself(group, e)) change += e.change;
    return change == 0;
}

void SmallSwallowtails::keep(std::span<const Event> events, base::Array<Event>& kept) {
    for (std::size_t i = 0; i < events.size(); ++i)
        if (events[i].near_piece < 0) cusps_.push_back(static_cast<std::int64_t>(i));
    if (cusps_.size() > 1) find_groups(events);
    std::int64_t wrong = 0;
    for (const Group& group : groups_)
        if (!adds_up(group, events)) groups_[wrong++] = group;
    groups_.resize(wrong);
    for (std::size_t i = 0; i < events.size(); ++i) {
        const Event& e = events[i];
        const bool dropped = std::any_of(groups_.begin(), groups_.end(), [&](const Group& group) {
            if (e.near_piece >= 0) return crosses_itself(group, e);
            return is_cusp_of(group, e) && !(group.odd && group.last == static_cast<std::int64_t>(i));
        });
        if (!dropped) kept.push_back(e);
    }
}

} // namespace hrbfnpr::visibility
