// SPDX-License-Identifier: MIT
#include "frame/lines/joined_ends.h"

#include <algorithm>

namespace hrbfnpr::frame {
namespace {

// In widths: sheets that are nearly one have ends that are so far apart.
constexpr double together = 0.4;
// Lines fainter than this are not taken for what another one goes on as.
constexpr float least_opacity = 0.5F;

} // namespace

JoinedEnds::JoinedEnds(base::Memory& memory, const LineInput& input, const HuggingParts& hugging)
    : together_(together * hugging.width()), ends_(memory), goes_on_(memory, 2 * input.found.lines.lines.size()) {
    std::fill(goes_on_.begin(), goes_on_.end(), std::uint8_t{1});
    const base::Array<visibility::Interval>& intervals = input.found.intervals;
    for (std::int64_t first = 0; first < intervals.size();) {
        std::int64_t end = first;
        while (end < intervals.size() && intervals[end].line == intervals[first].line) ++end;
        add(input, hugging, intervals[first].line, first, end - 1);
        first = end;
    }
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
        return a.place.x != b.place.x ? a.place.x < b.place.x : a.number < b.number;
    });
    for (std::int64_t i = 0; i < ends_.size(); ++i)
        if (ends_[i].contour && ends_[i].seen && !meets_another(i)) goes_on_[ends_[i].number] = 0;
}

void JoinedEnds::add(const LineInput& input, const HuggingParts& hugging, std::int32_t line, std::int64_t first,
                     std::int64_t last) {
    const visibility::Line& its = input.found.lines.lines[line];
    const visibility::Subject& subject = input.subjects[static_cast<std::size_t>(its.subject)];
    if (its.closed || !subject.joined) return;
    for (const bool at_end : {false, true}) {
        const visibility::Piece& piece = input.found.lines.pieces[its.first_piece + (at_end ? its.pieces - 1 : 0)];
        float opacity = 0.0F;
        for (const DrawnAs& as : input.styles)
            if (as.subject == its.subject) opacity = std::max(opacity, faded(as, piece, at_end ? 1.0F : 0.0F));
        const std::int64_t point = its.first_point + (at_end ? its.points - 1 : 0);
        const std::int64_t interval = at_end ? last : first;
        const bool hidden = input.found.intervals[interval].sheets > 0 && !hugging.has(interval);
        const bool seen = !hidden && opacity >= least_opacity;
        ends_.push_back({input.found.lines.points[point].place, 2 * std::int64_t{line} + (at_end ? 1 : 0),
                         subject.sheets == 2, seen});
    }
}

bool JoinedEnds::meets_another(std::int64_t end) const noexcept {
    const auto meets = [&](std::int64_t i) {
        return ends_[i].seen && glm::distance(ends_[i].place, ends_[end].place) <= together_;
    };
    for (std::int64_t i = end - 1; i >= 0 && ends_[end].place.x - ends_[i].place.x <= together_; --i)
        if (meets(i)) return true;
    for (std::int64_t i = end + 1; i < ends_.size() && ends_[i].place.x - ends_[end].place.x <= together_; ++i)
        if (meets(i)) return true;
    return false;
}

} // namespace hrbfnpr::frame
