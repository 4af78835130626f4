// SPDX-License-Identifier: MIT
// The steps of split_winding(), for each patch:
//
//   measure_ways   the ways along edges from one end of the patch to its faces
//   turn_of        the way from one turn to the next, from faces that lie beside or above each other
//   split_patch    cuts the patch into bands across the way, each at most half a turn long
#include "mesh/pieces/split_winding.h"

#include "geometry/point_tree.h"
#include "mesh/corners.h"
#include "mesh/pieces/cell_tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::mesh {
namespace {

constexpr double boundless = std::numeric_limits<double>::infinity();

using Patch = std::span<const std::int32_t>; // faces

struct Way {
    double length;
    std::int32_t vertex;
    [[nodiscard]] bool operator<(const Way& other) const noexcept { // the shortest is on top of a heap
        return length > other.length || (length == other.length && vertex > other.vertex);
    }
};

[[nodiscard]] glm::dvec3 middle_of(const Mesh& mesh, std::int32_t face) noexcept {
    const auto p = mesh.corners(face);
    return (p[0] + p[1] + p[2]) / 3.0;
}
[[nodiscard]] glm::dvec3 normal_of(const Mesh& mesh, std::int32_t face) noexcept {
    return glm::normalize(doubled_area(mesh.corners(face)));
}

// Sets the ways along a patch's edges from a face to its others. Returns the face that is farthest, of those that hang
// together with it. (The ways go along edges, as faces may be slivers: from middle to middle of these is a zigzag.)
[[nodiscard]] std::int32_t measure_ways(const Mesh& mesh, const Creases& creases, const base::Groups& corners,
                                        std::int32_t from, Patch patch, base::Array<double>& to_vertex,
                                        base::Array<double>& way) {
    for (const std::int32_t face : patch)
        for (const std::int32_t v : mesh.triangle[face]) to_vertex[v] = boundless;
    base::Array<Way> heap(way.memory());
    const auto reach = [&](std::int32_t vertex, double length) {
        if (length >= to_vertex[vertex]) return;
        to_vertex[vertex] = length;
        heap.push_back({length, vertex});
        std::push_heap(heap.begin(), heap.end());
    };
    reach(mesh.triangle[from][0], 0.0);
    while (!heap.empty()) {
        std::pop_heap(heap.begin(), heap.end());
        const Way at = heap.back();
        heap.resize(heap.size() - 1);
        if (at.length > to_vertex[at.vertex]) continue;
        for (const std::int32_t corner : corners[at.vertex])
            if (creases.patch[corner / 3] == creases.patch[from])
                for (const std::int32_t v : mesh.triangle[corner / 3])
                    reach(v, at.length + glm::distance(mesh.vertex[at.vertex], mesh.vertex[v]));
    }
    std::int32_t last = from;
    for (const std::int32_t face : patch) {
        const Triangle& t = mesh.triangle[face];
        way[face] = (to_vertex[t[0]] + to_vertex[t[1]] + to_vertex[t[2]]) / 3.0;
        if (way[face] < boundless && way[face] > way[last]) last = face;
    }
    return last;
}

// Returns the way from one turn of a patch to the next, or infinity if there are none.
[[nodiscard]] double turn_of(const Mesh& mesh, Patch patch, const base::Array<double>& way,
                             const base::Progress& progress) {
    const double diagonal = mesh.bounds.diagonal();
    const glm::dvec3 first = normal_of(mesh, patch[0]);
    const bool flat = std::all_of(patch.begin(), patch.end(), [&](std::int32_t face) {
        return glm::dot(normal_of(mesh, face), first) > winding_tuning.flat;
    });
    const auto are_turns = [&](std::int32_t a, std::int32_t b) {
        const double around = std::abs(way[a] - way[b]);
        const glm::dvec3 off = middle_of(mesh, b) - middle_of(mesh, a);
        const double distance = glm::length(off);
        const glm::dvec3 n = normal_of(mesh, a);
        return around > std::max(winding_tuning.way_around * distance, winding_tuning.least_way * diagonal) &&
               distance < winding_tuning.layers_apart * diagonal &&
               (!flat || std::abs(glm::dot(off, n)) > winding_tuning.along_normal * distance) &&
               glm::dot(n, normal_of(mesh, b)) > winding_tuning.same_way;
    };
    const auto known = static_cast<std::size_t>(winding_tuning.known);
    const std::size_t step = (patch.size() + known - 1) / known;
    geometry::VecArray place(mesh.vertex.memory());
    for (std::size_t i = 0; i < patch.size(); i += step) place.push_back(middle_of(mesh, patch[i]));
    const geometry::PointTree tree(place, progress);
    const auto face_at = [&](std::int64_t at) { return patch[static_cast<std::size_t>(tree.index(at)) * step]; };
    const std::size_t count = std::min(static_cast<std::size_t>(winding_tuning.probes), patch.size());
    base::Array<double> around(mesh.vertex.memory());
    for (std::size_t k = 0; k < count; ++k) {
        const std::int32_t face = patch[k * patch.size() / count];
        std::int64_t found = 0;
        const std::int64_t any = tree.nearest(
            middle_of(mesh, face), 1, [](std::int64_t) { return true; },
            [&](std::int64_t at) { return are_turns(face, face_at(at)); }, &found);
        if (any > 0) around.push_back(std::abs(way[face] - way[face_at(found)]));
    }
    if (around.empty() || 2 * around.size() < static_cast<std::int64_t>(count)) return boundless;
    // Not the least: where a flank runs out into a flat end, that lies above it a short way around.
    double* const quarter = around.begin() + around.size() / 4;
    std::nth_element(around.begin(), quarter, around.end());
    return *quarter;
}

} // namespace

void split_winding(const base::Runtime& runtime, const Mesh& mesh, Creases& creases, const base::Progress& progress) {
    HRBFNPR_ASSERT(creases.patch.size() == mesh.faces());
    const base::Groups corners = corners_at_vertices(mesh, progress);
    const base::Groups patches(runtime.memory, creases.patches, [&](auto&& put) {
        for (std::int32_t face = 0; face < mesh.faces(); ++face) put(creases.patch[face], face);
    });
    base::Array<double> to_vertex(runtime.memory, mesh.vertex.size());
    base::Array<double> way(runtime.memory, mesh.faces());        // of each face, from one end of its patch
    base::Array<std::int32_t> part(runtime.memory, mesh.faces()); // of its patch
    bool any = false;
    for (std::int32_t p = 0; p < creases.patches; ++p) {
        progress.check();
        const Patch patch = patches[p];
        const std::int32_t end = measure_ways(mesh, creases, corners, patch[0], patch, to_vertex, way);
        const double length = way[measure_ways(mesh, creases, corners, end, patch, to_vertex, way)];
        if (length < winding_tuning.least_way * mesh.bounds.diagonal()) continue;
        const double turn = turn_of(mesh, patch, way, progress);
        if (turn == boundless) continue;
        const double parts =
            std::clamp(std::ceil(length / (winding_tuning.part_of_turn * turn)), 1.0, winding_tuning.most_parts);
        for (const std::int32_t face : patch) {
            const double share = std::min(way[face] / length, 1.0);
            part[face] = static_cast<std::int32_t>(std::min(parts - 1.0, std::floor(parts * share)));
        }
        any = any || parts > 1.0;
    }
    if (!any) return;
    // Parts are numbered in the order of their first faces.
    const auto most = static_cast<std::int64_t>(winding_tuning.most_parts);
    base::Array<std::int32_t> number(runtime.memory, most * creases.patches);
    creases.patches = 0;
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        std::int32_t& of = number[most * creases.patch[face] + part[face]];
        if (of == 0) of = ++creases.patches;
        creases.patch[face] = of - 1;
    }
}

} // namespace hrbfnpr::mesh
