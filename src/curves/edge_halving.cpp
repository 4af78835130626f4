// SPDX-License-Identifier: MIT
#include "curves/edge_halving.h"

#include "curves/mesh_topology.h"

namespace hrbfnpr::curves {
namespace {

// From the corner on that makes the halved edges the first ones, or the first and the third.
void cut(const SurfaceMesh& mesh, const base::Array<std::int32_t>& middles, std::int64_t triangle,
         base::Array<std::int32_t>& corner) {
    const auto middle = [&](int k) { return middles[3 * triangle + k % 3]; };
    const auto at = [&](int k) { return mesh.corner[3 * triangle + k % 3]; };
    const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
        for (const std::int32_t v : {a, b, c}) corner.push_back(v);
    };
    int halved = 0;
    for (int k = 0; k < 3; ++k) halved += middle(k) >= 0 ? 1 : 0;
    int k = 0;
    if (halved == 0) return add(at(0), at(1), at(2));
    if (halved == 1) {
        while (middle(k) < 0) ++k;
        add(at(k), middle(k), at(k + 2));
        return add(middle(k), at(k + 1), at(k + 2));
    }
    if (halved == 2) {
        while (middle(k + 2) >= 0) ++k; // edges k and k + 1 are halved: their corner k + 1 is cut off
        add(middle(k), at(k + 1), middle(k + 1));
        // By the shorter diagonal of what is left.
        const bool first = glm::distance(mesh.position[middle(k)], mesh.position[at(k + 2)]) <
                           glm::distance(mesh.position[at(k)], mesh.position[middle(k + 1)]);
        if (first) {
            add(middle(k), middle(k + 1), at(k + 2));
            return add(at(k), middle(k), at(k + 2));
        }
        add(at(k), middle(k), middle(k + 1));
        return add(at(k), middle(k + 1), at(k + 2));
    }
    for (k = 0; k < 3; ++k) add(at(k), middle(k), middle(k + 2));
    add(middle(0), middle(1), middle(2));
}

} // namespace

std::int64_t opposite_of(const SurfaceMesh& mesh, std::int64_t edge) noexcept {
    const std::int64_t triangle = mesh.neighbour[edge];
    if (triangle < 0) return -1;
    for (std::int64_t e = 3 * triangle; e < 3 * triangle + 3; ++e)
        if (start_of(mesh, e) == end_of(mesh, edge) && end_of(mesh, e) == start_of(mesh, edge)) return e;
    return -1;
}

void cut_at_middles(const base::Runtime& runtime, const base::Array<std::int32_t>& middle, SurfaceMesh& mesh) {
    base::Array<std::int32_t> corner(runtime.memory);
    corner.reserve(mesh.corner.size());
    for (std::int64_t t = 0; t < mesh.triangles(); ++t) cut(mesh, middle, t, corner);
    mesh.corner = std::move(corner);
    mesh.neighbour = find_neighbours(runtime, mesh.corner, mesh.vertices());
}

} // namespace hrbfnpr::curves
