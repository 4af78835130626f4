// SPDX-License-Identifier: MIT
#include "curves/edge_halving.h"

#include "base/assert.h"
#include "curves/mesh_topology.h"
#include "geometry/long_vec_array.h"
#include "surface/project.h"

#include <algorithm>

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

bool halve_edges(const base::Runtime& runtime, const implicit::Implicit& implicit,
                 const base::Array<std::int64_t>& edges, double farthest, bool smooth, SurfaceMesh& mesh,
                 const base::Progress& progress) {
    constexpr std::int64_t at_once = 8192; // edges without a look for a cancel
    const auto between = [&](std::int64_t e) {
        HRBFNPR_ASSERT(e >= 0 && e < mesh.corner.size());
        return 0.5 * (mesh.position[start_of(mesh, e)] + mesh.position[end_of(mesh, e)]);
    };
    surface::Projection at(runtime.memory);
    for (const std::int64_t e : edges) at.position.push_back(between(e));
    surface::project(runtime, implicit, {}, at, progress);
    base::Array<std::int32_t> middle(runtime.memory);
    middle.resize_for_overwrite(mesh.corner.size());
    std::fill(middle.begin(), middle.end(), -1);
    const std::int64_t before = mesh.vertices();
    for (std::int64_t i = 0; i < edges.size(); ++i) {
        if (i % at_once == 0) progress.check();
        const std::int64_t e = edges[i];
        const double length = glm::distance(mesh.position[start_of(mesh, e)], mesh.position[end_of(mesh, e)]);
        const auto agrees = [&](std::int32_t end) { return glm::dot(at.gradient[i], mesh.gradient[end]) > 0.0; };
        if (at.status[i] != surface::ProjectionStatus::converged ||
            !(glm::distance(at.position[i], between(e)) < farthest * length) ||
            (smooth && !(agrees(start_of(mesh, e)) && agrees(end_of(mesh, e)))))
            continue;
        middle[e] = static_cast<std::int32_t>(mesh.vertices());
        if (const std::int64_t other = opposite_of(mesh, e); other >= 0) middle[other] = middle[e];
        geometry::push_back_long(mesh.position, at.position[i], progress);
        geometry::push_back_long(mesh.gradient, at.gradient[i], progress);
    }
    if (mesh.vertices() == before) return false;
    cut_at_middles(runtime, middle, mesh);
    return true;
}

} // namespace hrbfnpr::curves
