// SPDX-License-Identifier: MIT
#include "mesh/join_borders.h"

#include "geometry/point_grid.h"
#include "mesh/edges.h"

namespace hrbfnpr::mesh {
namespace {

// The vertices of edges of one face.
base::Array<std::int32_t> border_vertices(const base::Runtime& runtime, std::int64_t vertices,
                                          const base::Array<Triangle>& triangle, const base::Progress& progress) {
    base::Array<std::uint8_t> is_border(runtime.memory, vertices);
    for_edges(sides_by_edge(runtime, triangle, progress), progress, [&](const Side* first, const Side* last) {
        if (last - first != 1) return;
        is_border[static_cast<std::int64_t>(first->edge >> 32U)] = 1;
        is_border[static_cast<std::int64_t>(first->edge & 0xFFFFFFFFU)] = 1;
    });
    base::Array<std::int32_t> found(runtime.memory);
    for (std::int64_t v = 0; v < vertices; ++v)
        if (is_border[v] != 0) found.push_back(static_cast<std::int32_t>(v));
    return found;
}

void renumber(Sets& same, base::Array<glm::dvec3>& vertex, base::Array<Triangle>& triangle) {
    base::Array<std::int32_t> number(vertex.memory(), vertex.size());
    std::int64_t kept = 0;
    for (std::int64_t v = 0; v < vertex.size(); ++v) {
        const std::int32_t first = same.of(static_cast<std::int32_t>(v)); // the least of them
        if (first == v) vertex[kept] = vertex[v];
        number[v] = first == v ? static_cast<std::int32_t>(kept++) : number[first];
    }
    vertex.resize(kept);
    for (Triangle& t : triangle)
        for (std::int32_t& corner : t) corner = number[corner];
}

} // namespace

void join_borders(const base::Runtime& runtime, base::Array<glm::dvec3>& vertex, base::Array<Triangle>& triangle,
                  double near, const base::Progress& progress) {
    const base::Array<std::int32_t> border = border_vertices(runtime, vertex.size(), triangle, progress);
    if (border.empty() || !(near > 0.0)) return;
    geometry::VecArray place(runtime.memory, border.size());
    for (std::int64_t i = 0; i < border.size(); ++i) place.set(i, vertex[border[i]]);
    const geometry::PointGrid grid(place, near, progress);
    Sets same(runtime.memory, vertex.size());
    bool any = false;
    for (std::int64_t i = 0; i < border.size(); ++i)
        grid.around(place[i], [&](std::int64_t at) {
            const std::int64_t j = grid.index(at);
            const glm::dvec3 way = place[j] - place[i];
            if (j <= i || glm::dot(way, way) > near * near) return;
            same.join(border[i], border[j]);
            any = true;
        });
    if (any) renumber(same, vertex, triangle);
}

} // namespace hrbfnpr::mesh
