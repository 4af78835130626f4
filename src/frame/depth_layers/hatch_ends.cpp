// SPDX-License-Identifier: MIT
#include "frame/depth_layers/hatch_ends.h"

#include "curves/line_set.h"

namespace hrbfnpr::frame {
namespace {

// A line that crosses a crease ends at the last mark before it.
[[nodiscard]] HatchEnd end_at(const ItemView& item, const Run& run, std::int64_t last, std::int64_t before) noexcept {
    const glm::dvec3 place(run.position_of(run.marks->mark_of(last)));
    const glm::dvec3 inner(run.position_of(run.marks->mark_of(before)));
    const double step = glm::distance(place, inner);
    return item.lines->has_crease_near(item.origin + place, step) ? HatchEnd::crease : HatchEnd::line;
}

} // namespace

void find_crease_ends(const ItemView& item, const Run& run, HatchStroke& stroke) noexcept {
    stroke.begins = stroke.ends = HatchEnd::line;
    const bool posed = run.position != run.marks->position.data();
    if (stroke.closed || stroke.mark.empty() || item.lines == nullptr || posed) return;
    const std::int64_t last = stroke.first + stroke.count - 1;
    if (stroke.mark[0].is_drawn()) stroke.begins = end_at(item, run, stroke.first, stroke.first + 1);
    if (stroke.mark.back().is_drawn()) stroke.ends = end_at(item, run, last, last - 1);
}

} // namespace hrbfnpr::frame
