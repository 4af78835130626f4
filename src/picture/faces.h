// SPDX-License-Identifier: MIT
// Triangles: their edges, areas and sizes, and those of a mesh handle.
#pragma once

#include "base/assert.h"
#include "picture/handles.h"
#include "picture/shape.h"

#include <span>

namespace hrbfnpr::picture {

// The edges of triangles.  A side is numbered k * faces + face: it goes from corner k of the face to the next one.
struct FaceEdges {
    explicit FaceEdges(Pool& pool) : ends(&pool), first(&pool), sides(&pool), of_side(&pool) {}

    Vector<Edge> ends;            // the lower vertex first; ascending
    Vector<std::int64_t> first;   // where the sides of each edge begin; one more for the end
    Vector<std::int64_t> sides;   // by edge, and ascending within each
    Vector<std::int64_t> of_side; // the edge of each side
    std::int64_t faces = 0;

    [[nodiscard]] std::size_t size() const noexcept { return ends.size(); }
    [[nodiscard]] std::span<const std::int64_t> sides_of(std::size_t edge) const noexcept {
        HRBFNPR_ASSERT(edge < ends.size());
        const auto begin = static_cast<std::size_t>(first[edge]);
        return std::span(sides).subspan(begin, static_cast<std::size_t>(first[edge + 1]) - begin);
    }
    // Whether two faces have it, as inside a surface.
    [[nodiscard]] bool is_plain(std::size_t edge) const noexcept { return first[edge + 1] - first[edge] == 2; }
    [[nodiscard]] std::size_t face(std::int64_t side) const noexcept { return static_cast<std::size_t>(side % faces); }
};

// vertices: all numbers in the triangles are below it.
[[nodiscard]] FaceEdges find_edges(const Vector<Triangle>& triangles, std::size_t vertices, Pool& pool);

// Twice the area of a face, along its normal.
[[nodiscard]] inline glm::dvec3 doubled_area_of(const Points& points, const Triangle& face) noexcept {
    const glm::dvec3& a = points[static_cast<std::size_t>(face[0])];
    return glm::cross(points[static_cast<std::size_t>(face[1])] - a, points[static_cast<std::size_t>(face[2])] - a);
}

// A unit vector, or 0 for 0.
[[nodiscard]] glm::dvec3 unit_or_zero(const glm::dvec3& vector) noexcept;

[[nodiscard]] Vector<double> areas_of(const Points& points, const Vector<Triangle>& faces, Pool& pool);

// The diagonal of the points' box; NaN if a coordinate is NaN.
[[nodiscard]] double box_diagonal_of(const Points& points) noexcept;

// Sums halves one by one, so that rounding errors stay small.
[[nodiscard]] double sum_in_pairs(std::span<const double> numbers) noexcept;

// Interpolates between the two numbers beside the percentile; 0 of nothing.  It moves the numbers.
[[nodiscard]] double percentile(Vector<double>& numbers, double percent);

// What a mesh holds, as values.
[[nodiscard]] hrbfnpr_mesh_info info_of(const Mesh& mesh);
[[nodiscard]] Points vertices_of(const Mesh& mesh, Pool& pool);
[[nodiscard]] Vector<Triangle> triangles_of(const Mesh& mesh, Pool& pool);
// HRBFNPR_MESH_ATTRIBUTE_COMPONENT or _GIVEN_FACE.
[[nodiscard]] Vector<std::int32_t> numbers_of(const Mesh& mesh, std::uint32_t attribute, Pool& pool);

} // namespace hrbfnpr::picture
