// SPDX-License-Identifier: MIT
// Finds points that are too far away: strays, or values that mark missing data. With them, all other points would
// shrink to a dot in the picture.
#pragma once

#include "base/parallel.h"
#include "picture/shape.h"

namespace hrbfnpr::picture {

// For each point: 1 if it is selected, else 0.
using PointMask = Vector<std::uint8_t>;

// The result of leave_out_no_data().
struct NoData {
    std::int64_t points = 0;
    double value = 0.0;
};

// Removes points with a coordinate that marks missing data and is far below all others, together with their faces.
NoData leave_out_no_data(Shape& shape, Pool& pool);

// Removes the points that far_from_most() finds, and returns their number.
std::int64_t leave_out_far(Shape& shape, Pool& pool);

// Selects a few points if they lie far from most points. Points that are not finite are not selected.
[[nodiscard]] PointMask far_from_most(const Points& points, Pool& pool);

// Selects the finite points that are strays, such as dust in a scan: points where all are sparse, and that lie off the
// plane of their neighbours. Strays would make false sheets of surface.
[[nodiscard]] PointMask find_strays(const Points& points, const base::Parallel& parallel, Pool& pool);

// Keeps the selected points, with their normals, faces and sharp edges. If a mesh would lose all faces, it changes
// nothing and returns false.
bool keep_points(Shape& shape, const PointMask& kept, Pool& pool);

} // namespace hrbfnpr::picture
