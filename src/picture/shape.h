// SPDX-License-Identifier: MIT
// Defines the contents of a source: points, possibly with normals and triangles.
#pragma once

#include "geometry/vec.h"
#include "picture/memory.h"

#include <hrbfnpr.h>

#include <array>
#include <cstdint>
#include <optional>

namespace hrbfnpr::picture {

using Points = Vector<glm::dvec3>;
using Triangle = std::array<std::int64_t, 3>;
using Edge = std::array<std::int64_t, 2>;

struct Shape {
    explicit Shape(Pool& pool) : points(&pool), normals(&pool), triangles(&pool), sharp_edges(&pool), up_by(&pool) {}

    Points points;
    Points normals;               // one normal for each point, or empty
    Vector<Triangle> triangles;   // indices of points; empty if the shape is not a mesh
    Vector<Edge> sharp_edges;     // the sharp edges, as in hrbfnpr_picture_source
    bool has_sharp_edges = false; // true if the sharp edges are known
    std::optional<glm::dvec3> up;
    String up_by;
    std::optional<glm::dvec3> viewpoint;
    bool is_photo = false;    // True if the shape is a single image of a depth camera.
    std::int64_t columns = 0; // the size of the image, if the points are its pixels
    std::int64_t rows = 0;

    [[nodiscard]] bool is_mesh() const noexcept { return !triangles.empty(); }
};

[[nodiscard]] inline hrbfnpr_array view_of(const Points& points) noexcept {
    return {points.data(), static_cast<std::int64_t>(points.size()), 0, HRBFNPR_SCALAR_FLOAT64, 3};
}
[[nodiscard]] inline hrbfnpr_array view_of(const Vector<Triangle>& triangles) noexcept {
    return {triangles.data(), static_cast<std::int64_t>(triangles.size()), 0, HRBFNPR_SCALAR_INT64, 3};
}
// Returns the points as room for a call that overwrites all of them.
[[nodiscard]] inline hrbfnpr_array_out room_in(Points& points) noexcept {
    return {points.data(), static_cast<std::int64_t>(points.size()), 0, HRBFNPR_SCALAR_FLOAT64, 3};
}

} // namespace hrbfnpr::picture
