// SPDX-License-Identifier: MIT
#include "implicit/csg_boxes.h"

#include <algorithm>

namespace hrbfnpr::implicit {
namespace {

bool has_end(const CsgBounded& item) noexcept {
    const glm::dvec3 size = item.box.high - item.box.low;
    return std::isfinite(size.x + size.y + size.z);
}

} // namespace

// One without an end would hide the ends of all beside it.
std::int32_t CsgBoxTree::add(std::span<CsgBounded> items) {
    const auto apart = std::partition(items.begin(), items.end(), has_end);
    const auto ended = static_cast<std::size_t>(apart - items.begin());
    if (ended == 0 || ended == items.size()) return items.empty() ? -1 : split(items);
    const std::int32_t first = split(items.first(ended));
    return join(first, split(items.subspan(ended)));
}

// In two halves along the axis that their centres are farthest apart on.
std::int32_t CsgBoxTree::split(std::span<CsgBounded> items) {
    if (items.size() == 1) {
        nodes_.push_back({items[0].box, items[0].slope, items[0].item, -1});
        return static_cast<std::int32_t>(nodes_.size() - 1);
    }
    // Twice the centre; 0 where there is none.
    const auto centre = [](const CsgBounded& item, int axis) {
        const double sum = item.box.low[axis] + item.box.high[axis];
        return std::isfinite(sum) ? sum : 0.0;
    };
    int widest = 0;
    double width = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] =
            std::minmax_element(items.begin(), items.end(), [&](const CsgBounded& a, const CsgBounded& b) {
                return centre(a, axis) < centre(b, axis);
            });
        const double between = centre(*high, axis) - centre(*low, axis);
        if (between > width) {
            width = between;
            widest = axis;
        }
    }
    std::sort(items.begin(), items.end(), [&](const CsgBounded& a, const CsgBounded& b) {
        const double one = centre(a, widest);
        const double other = centre(b, widest);
        return one != other ? one < other : a.item < b.item;
    });
    const std::size_t half = items.size() / 2;
    const std::int32_t first = split(items.first(half));
    return join(first, split(items.subspan(half)));
}

// An empty box has its faces the wrong way round, and is as near as they say.
std::int32_t CsgBoxTree::join(std::int32_t first, std::int32_t second) {
    const Node& a = nodes_[first];
    const Node& b = nodes_[second];
    const CsgBox box{glm::min(a.box.low, b.box.low), glm::max(a.box.high, b.box.high)};
    const Node both{box, std::max(a.slope, b.slope), first, second};
    nodes_.push_back(both);
    return static_cast<std::int32_t>(nodes_.size() - 1);
}

} // namespace hrbfnpr::implicit
