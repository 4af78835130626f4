// SPDX-License-Identifier: MIT
// Computes edges, areas and sizes of triangles, and reads the triangles of a mesh handle.
#pragma once

#include "base/assert.h"
#include "picture/handles.h"
#include "picture/shape.h"

#include <span>

namespace hrbfnpr::picture {

// The edges of triangles. A side is a half-edge of one face: the side with index k * faces + f goes from corner k of
// face f to the next corner of face f.
struct FaceEdges {
    explicit FaceEdges(Pool& pool) : ends(&pool), first(&pool), sides(&pool), of_side(&pool) {}

    // The vertex indices of each edge, the lower index first. The edges are sorted by these indices.
    Vector<Edge> ends;
    Vector<std::int64_t> first;   // The index in `sides` where the list of each edge begins, and the size of `sides`.
    Vector<std::int64_t> sides;   // All sides, sorted by edge, then by side index.
    Vector<std::int64_t> of_side; // The edge of each side.
    std::int64_t faces = 0;

    [[nodiscard]] std::size_t size() const noexcept { return ends.size(); }
    [[nodiscard]] std::span<const std::int64_t> sides_of(std::size_t edge) const noexcept {
        HRBFNPR_ASSERT(edge < ends.size());
        const auto begin = static_cast<std::size_t>(first[edge]);
        return std::span(sides).subspan(begin, static_cast<std::size_t>(first[edge + 1]) - begin);
    }
    // Returns whether exactly two faces share the edge, as they do inside a surface.
    [[nodiscard]] bool is_plain(std::size_t edge) const noexcept { return first[edge + 1] - first[edge] == 2; }
    [[nodiscard]] std::size_t face(std::int64_t side) const noexcept { return static_cast<std::size_t>(side % faces); }
};

// Finds the edges of triangles. All vertex indices of the triangles are below `vertices`.
[[nodiscard]] FaceEdges find_edges(const Vector<Triangle>& triangles, std::size_t vertices, Pool& pool);

// The index of an edge that exactly two faces share, and the indices of these faces.
struct PlainEdge {
    std::size_t edge;
    std::size_t one, other; // the two faces
};
[[nodiscard]] Vector<PlainEdge> plain_edges(const FaceEdges& edges, Pool& pool);

// Returns the normal of a face, with a length of twice the face's area.
[[nodiscard]] inline glm::dvec3 doubled_area_of(const Points& points, const Triangle& face) noexcept {
    const glm::dvec3& a = points[static_cast<std::size_t>(face[0])];
    return glm::cross(points[static_cast<std::size_t>(face[1])] - a, points[static_cast<std::size_t>(face[2])] - a);
}

// Returns the vector scaled to length 1, or the zero vector if its length is 0.
[[nodiscard]] glm::dvec3 unit_or_zero(const glm::dvec3& vector) noexcept;

[[nodiscard]] Vector<double> areas_of(const Points& points, const Vector<Triangle>& faces, Pool& pool);

// Returns the diagonal of the bounding box of the points, or NaN if a coordinate is NaN.
[[nodiscard]] double box_diagonal_of(const Points& points) noexcept;

// Returns the sum of the numbers. Pairwise summation keeps rounding errors small.
[[nodiscard]] double sum_in_pairs(std::span<const double> numbers) noexcept;

// Returns a percentile, interpolated between the two nearest numbers, or 0 for an empty list. The numbers are
// reordered.
[[nodiscard]] double percentile(Vector<double>& numbers, double percent);

// These functions read the contents of a mesh handle.
[[nodiscard]] hrbfnpr_mesh_info info_of(const Mesh& mesh);
[[nodiscard]] Points vertices_of(const Mesh& mesh, Pool& pool);
[[nodiscard]] Vector<Triangle> triangles_of(const Mesh& mesh, Pool& pool);
// `attribute` is HRBFNPR_MESH_ATTRIBUTE_COMPONENT or HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE.
[[nodiscard]] Vector<std::int32_t> numbers_of(const Mesh& mesh, std::uint32_t attribute, Pool& pool);

} // namespace hrbfnpr::picture
