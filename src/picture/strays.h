// SPDX-License-Identifier: MIT
// Finds points that lie too far away, since they would shrink all others to a dot in the picture. Such points are
// strays, or values that mark missing data.
#pragma once

#include "picture/shape.h"

namespace hrbfnpr::picture {

// One number for each point: 1 if the point is selected, else 0.
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

// Selects a few of many points if they lie far from all others. It never selects points that are not finite.
[[nodiscard]] PointMask far_from_most(const Points& points, Pool& pool);

// Selects the finite points that are strays. Strays are dust in a scan. They would make sheets in the air, and get no
// normals.
[[nodiscard]] PointMask find_strays(const Points& points, Pool& pool);

// Keeps the points that the mask selects, with their normals, faces and sharp edges. If a mesh would lose all its
// faces, it changes nothing and returns false.
bool keep_points(Shape& shape, const PointMask& kept, Pool& pool);

} // namespace hrbfnpr::picture
