// SPDX-License-Identifier: MIT
// The neighbours of faces across their edges, and connected components.
//
// Corner k of a face has the index 3 face + k. A side is a half-edge: it goes from a corner of a face to the next
// corner, and has the index of the corner where it starts.
#pragma once

#include "base/groups.h"
#include "mesh/mesh.h"

#include <cmath>
#include <numeric>

namespace hrbfnpr::mesh {

// Disjoint sets of indices (union-find). The name of a set is its smallest index.
class UnionFind {
public:
    UnionFind(base::Memory& memory, std::int64_t count) : parent_(memory) {
        parent_.resize_for_overwrite(count);
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    [[nodiscard]] std::int32_t find(std::int32_t i) noexcept {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::int32_t a, std::int32_t b) noexcept {
        a = find(a);
        b = find(b);
        parent_[a < b ? b : a] = a < b ? a : b;
    }

private:
    base::Array<std::int32_t> parent_;
};

// Assigns the indices 0, 1, 2 and so on to names, in the order in which the names are first used.
class NumbersByFirstUse {
public:
    // Names are integers from 0 to `names` - 1.
    NumbersByFirstUse(base::Memory& memory, std::int64_t names) : number_(memory, names) {}
    [[nodiscard]] std::int32_t of(std::int64_t name) noexcept {
        std::int32_t& number = number_[name];
        if (number == 0) number = ++count_;
        return number - 1;
    }
    [[nodiscard]] std::int32_t count() const noexcept { return count_; }

private:
    base::Array<std::int32_t> number_; // for each name, its index plus 1; 0 if the name was not used yet
    std::int32_t count_ = 0;
};

// A side of a face: the half-edge from a corner to the next corner.
struct Side {
    // The indices of both vertices: the lower one in the high 32 bits, the higher one in the low 32 bits.
    std::uint64_t edge;
    std::int32_t face;
    std::int32_t forward; // 1 if the side runs from the lower vertex to the higher one, else 0
};

[[nodiscard]] inline std::int32_t low_end(const Side& side) noexcept {
    return static_cast<std::int32_t>(side.edge >> 32U);
}
[[nodiscard]] inline std::int32_t high_end(const Side& side) noexcept {
    return static_cast<std::int32_t>(side.edge & 0xFFFFFFFFU);
}

// Returns the index of the corner that a face has at a vertex.
[[nodiscard]] inline std::int64_t corner_at(const base::Array<Triangle>& triangle, std::int64_t face,
                                            std::int32_t vertex) noexcept {
    const Triangle& t = triangle[face];
    HRBFNPR_ASSERT(t[0] == vertex || t[1] == vertex || t[2] == vertex);
    return 3 * face + (t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2);
}

[[nodiscard]] inline std::int64_t number_of(const base::Array<Triangle>& triangle, const Side& side) noexcept {
    return corner_at(triangle, side.face, side.forward != 0 ? low_end(side) : high_end(side));
}

// Returns all sides, sorted by edge.
[[nodiscard]] base::Array<Side> sides_by_edge(const base::Work& work, const base::Array<Triangle>& triangle);

// Returns, for each side, the side of the other face at the same edge, or -1 if the edge does not have exactly two
// faces.
[[nodiscard]] base::Array<std::int64_t> sides_beyond(const base::Array<Triangle>& triangle,
                                                     const base::Array<Side>& sides,
                                                     const base::Progress& progress = {});

// Calls visit(first, last) for each edge with the range of its sides.
template <class Visit>
void for_edges(const base::Array<Side>& sides, const base::Progress& progress, Visit&& visit) {
    const Side* first = sides.begin();
    for (const std::int64_t at : progress.over(sides.size())) {
        const Side* const side = sides.begin() + at;
        if (side->edge == first->edge) continue;
        visit(first, side);
        first = side;
    }
    if (first != sides.end()) visit(first, sides.end());
}

template <class Visit>
void for_edges(const base::Array<Side>& sides, Visit&& visit) {
    for_edges(sides, base::Progress(), std::forward<Visit>(visit));
}

// Returns whether two sides of one edge run in opposite directions. They do if their faces have the same orientation.
[[nodiscard]] inline bool run_opposite(const base::Array<Triangle>& triangle, std::int64_t a, std::int64_t b) noexcept {
    return triangle[a / 3][static_cast<std::size_t>(a % 3)] != triangle[b / 3][static_cast<std::size_t>(b % 3)];
}

[[nodiscard]] inline glm::dvec3 unit_normal(const Mesh& mesh, std::int64_t face) noexcept {
    return glm::normalize(doubled_area(mesh.corners(face)));
}
[[nodiscard]] inline glm::dvec3 middle_of(const Mesh& mesh, std::int64_t face) noexcept {
    const auto p = mesh.corners(face);
    return (p[0] + p[1] + p[2]) / 3.0;
}

// Returns the unit normals of all faces.
[[nodiscard]] inline base::Array<glm::dvec3> unit_normals(const Mesh& mesh, const base::Progress& progress) {
    base::Array<glm::dvec3> normal(mesh.vertex.memory());
    normal.reserve(mesh.faces());
    for (const std::int64_t face : progress.over(mesh.faces())) normal.push_back(unit_normal(mesh, face));
    return normal;
}

// Returns the angle of a face at a corner, in radians.
[[nodiscard]] inline double angle_at(const std::array<glm::dvec3, 3>& p, std::size_t k) noexcept {
    HRBFNPR_ASSERT(k < 3);
    const glm::dvec3 u = p[(k + 1) % 3] - p[k];
    const glm::dvec3 v = p[(k + 2) % 3] - p[k];
    return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

// Returns the indices of the corners at each vertex, in ascending order.
[[nodiscard]] inline base::Groups corners_at_vertices(const Mesh& mesh, const base::Progress& progress) {
    return {mesh.vertex.memory(), mesh.vertex.size(), [&](auto&& put) {
                for (const std::int64_t corner : progress.over(3 * mesh.faces())) {
                    put(mesh.triangle[corner / 3][static_cast<std::size_t>(corner % 3)],
                        static_cast<std::int32_t>(corner));
                }
            }};
}

inline constexpr double default_crease_angle = 30.0; // in degrees

// Returns whether faces bend by more than an angle. A margin covers rounding: a prism of twelve sides bends by exactly
// 30 degrees.
[[nodiscard]] constexpr bool bends_more(double bend, double angle) noexcept { return bend > 1.01 * angle; }

// Returns the component of each face, numbered from 0 in the order of their first faces. Faces that share a vertex
// belong to one component.
[[nodiscard]] base::Array<std::int32_t> components_of(const base::Array<Triangle>& triangle, std::int64_t vertices,
                                                      std::int64_t& count, const base::Progress& progress = {});

} // namespace hrbfnpr::mesh
