// SPDX-License-Identifier: MIT
// Signs that spread from neighbour to neighbour, along the most trusted pairs first.
#pragma once

#include "orient/directions.h"
#include "orient/signs.h"

namespace hrbfnpr::orient {

enum class Spreading {
    parallel, // neighbours' normals agree: Hoppe and others, "Surface reconstruction from unorganized points", 1992
    reflected // ... with the one's mirror image across the middle of the pair: Xie, Wang, Hua, Qin, Kaufman, 2003
};

// Along the minimum spanning forest of the neighbour graph.
[[nodiscard]] Signs spread_signs(const base::Runtime& runtime, const geometry::PointTree& tree, const Near& near,
                                 std::int64_t neighbours, const geometry::VecArray& normal, Spreading spreading,
                                 const base::Progress& progress);

} // namespace hrbfnpr::orient
