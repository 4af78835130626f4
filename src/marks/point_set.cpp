#include "marks/point_set.h"

namespace hrbfnpr::marks {

std::int64_t MarkGroup::bytes() const noexcept {
    return position.bytes() + normal.bytes() + direction.bytes() + curvature.bytes() + rank.bytes() + level.bytes() +
           stroke.bytes() + width.bytes() + clusters.bytes();
}

std::int64_t PointSet::bytes() const noexcept {
    std::int64_t sum = 0;
    for (const MarkGroup& marks : group) sum += marks.bytes();
    return sum;
}

} // namespace hrbfnpr::marks
