// SPDX-License-Identifier: MIT
// Points that lie so far away that all else would be a dot in the picture: values that stand for no data, and strays.
#pragma once

#include "picture/shape.h"

namespace hrbfnpr::picture {

// One number for each point: 1 if it is one of those, else 0.
using PointMask = Vector<std::uint8_t>;

// What leave_out_no_data() has left out.
struct NoData {
    std::int64_t points = 0;
    double value = 0.0;
};

// Leaves out the points that have a coordinate which stands for no data and is far below all others, with their faces.
NoData leave_out_no_data(Shape& shape, Pool& pool);

// Leaves out the points that far_from_most() finds, and returns how many these are.
std::int64_t leave_out_far(Shape& shape, Pool& pool);

// Which of many points are a few that lie apart from all others. Points that are not finite are none of these.
[[nodiscard]] PointMask far_from_most(const Points& points, Pool& pool);

// Which of the finite points are strays: a scanner's dust, which makes sheets in the air, and gets no normals.
[[nodiscard]] PointMask find_strays(const Points& points, Pool& pool);

// Keeps the points that the mask has, with their normals, faces and sharp edges. It changes nothing and returns false
// if a mesh would lose all its faces.
bool keep_points(Shape& shape, const PointMask& kept, Pool& pool);

} // namespace hrbfnpr::picture
