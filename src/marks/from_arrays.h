// Ready-made marks, from the caller's arrays.
#pragma once

#include "base/runtime.h"
#include "base/view.h"
#include "marks/point_set.h"

#include <array>

namespace hrbfnpr::marks {

// Of one group; empty views as described at hrbfnpr_group_arrays.
struct GroupArrays {
    base::InView position, normal, direction, curvature, rank, level, stroke, width;
};
[[nodiscard]] PointSet from_arrays(const base::Runtime& runtime, const std::array<GroupArrays, group_count>& arrays,
                                   std::uint64_t random_seed);

} // namespace hrbfnpr::marks
