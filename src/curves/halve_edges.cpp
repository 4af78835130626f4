// SPDX-License-Identifier: MIT
#include "curves/halve_edges.h"

#include "base/assert.h"
#include "geometry/long_vec_array.h"
#include "surface/project.h"

#include <algorithm>

namespace hrbfnpr::curves {

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
