// SPDX-License-Identifier: MIT
#include "visibility/small_swallowtails.h"

#include <algorithm>

namespace hrbfnpr::visibility {

// Or within the size beside it, where the branches cross.
bool SmallSwallowtails::in(const Group& group, double at) const noexcept {
    const double low = group.begin - size_;
    const double high = group.end + size_;
    return (at >= low && at <= high) ||
           (line_.closed && (at + whole() <= high || (at - whole() >= low && at - whole() <= high)));
}

// Around a closed line beginning behind a gap, so that no group is cut in two.
void SmallSwallowtails::find_groups(std::span<const Event> events) {
    const std::int64_t count = cusps_.size();
    const auto at = [&](std::int64_t i) {
        const Event& e = events[static_cast<std::size_t>(cusps_[i % count])];
        return place(e.piece, e.share) + (i >= count ? whole() : 0.0);
    };
    std::int64_t first = 0;
    if (line_.closed)
        while (first < count && at(first + count) - at(first + count - 1) <= size_) ++first;
    if (first == count) first = 0;
    for (std::int64_t i = first; i < first + count;) {
        std::int64_t end = i + 1;
        while (end < first + count && at(end) - at(end - 1) <= size_) ++end;
        if (end - i > 1) groups_.push_back({at(i), at(end - 1), (end - i) % 2 != 0, cusps_[(end - 1) % count]});
        i = end;
    }
}

void SmallSwallowtails::keep(std::span<const Event> events, base::Array<Event>& kept) {
    for (std::size_t i = 0; i < events.size(); ++i)
        if (events[i].near_piece < 0) cusps_.push_back(static_cast<std::int64_t>(i));
    if (cusps_.size() > 1) find_groups(events);
    for (std::size_t i = 0; i < events.size(); ++i) {
        const Event& e = events[i];
        const bool own = e.near_piece >= line_.first_piece && e.near_piece < line_.first_piece + line_.pieces;
        const bool dropped = std::any_of(groups_.begin(), groups_.end(), [&](const Group& group) {
            if (!in(group, place(e.piece, e.share))) return false;
            if (e.near_piece >= 0) return own && in(group, place(e.near_piece, 0.5));
            return !(group.odd && group.last == static_cast<std::int64_t>(i));
        });
        if (!dropped) kept.push_back(e);
    }
}

} // namespace hrbfnpr::visibility
