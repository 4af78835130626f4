// SPDX-License-Identifier: MIT
// What a source holds, as a value: points, perhaps with normals, perhaps joined to triangles.
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
    Points normals;               // as many as points; empty: there are none
    Vector<Triangle> triangles;   // numbers of points; empty: it is no mesh
    Vector<Edge> sharp_edges;     // see hrbfnpr_picture_source
    bool has_sharp_edges = false; // whether those are known
    std::optional<glm::dvec3> up;
    String up_by;
    std::optional<glm::dvec3> viewpoint;
    bool is_photo = false;    // one picture of a depth camera
    std::int64_t columns = 0; // of its image, if there is a point for each pixel
    std::int64_t rows = 0;

    [[nodiscard]] bool is_mesh() const noexcept { return !triangles.empty(); }
};

[[nodiscard]] inline hrbfnpr_array view_of(const Points& points) noexcept {
    return {points.data(), static_cast<std::int64_t>(points.size()), 0, HRBFNPR_SCALAR_FLOAT64, 3};
}
[[nodiscard]] inline hrbfnpr_array view_of(const Vector<Triangle>& triangles) noexcept {
    return {triangles.data(), static_cast<std::int64_t>(triangles.size()), 0, HRBFNPR_SCALAR_INT64, 3};
}
// For a call that writes as many points as there are.
[[nodiscard]] inline hrbfnpr_array_out room_in(Points& points) noexcept {
    return {points.data(), static_cast<std::int64_t>(points.size()), 0, HRBFNPR_SCALAR_FLOAT64, 3};
}

} // namespace hrbfnpr::picture
