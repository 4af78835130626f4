// SPDX-License-Identifier: MIT
#include "curves/mesh_chains.h"

namespace hrbfnpr::curves {

MeshChains find_chains(const base::Runtime& runtime, const SurfaceMesh& mesh, const base::Array<double>& level) {
    constexpr std::int64_t triangles_a_task = 8192;
    HRBFNPR_ASSERT(level.size() == mesh.vertices());
    base::Array<std::uint8_t> crossed(runtime.memory);
    crossed.resize_for_overwrite(mesh.triangles());
    runtime.parallel.for_chunks(mesh.triangles(), triangles_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t t = begin; t < end; ++t) {
            const std::int32_t* const corner = mesh.corner.data() + 3 * t;
            const bool a = level[corner[0]] < 0.0;
            const bool b = level[corner[1]] < 0.0;
            const bool c = level[corner[2]] < 0.0;
            crossed[t] = static_cast<std::uint8_t>((a != b ? 1 : 0) | (b != c ? 2 : 0) | (c != a ? 4 : 0));
        }
    });
    // A walk comes in from the negative side of an edge's start, so that this stays to the left.
    const auto enters = [&](std::int64_t edge) { return level[start_of(mesh, edge)] < 0.0; };
    Chains<std::int64_t> edges = walk_chains(mesh, crossed, enters);
    MeshChains chains(runtime.memory);
    chains.crossing.reserve(edges.point.size());
    for (const std::int64_t edge : edges.point) {
        const bool negative_start = enters(edge);
        const std::int32_t a = negative_start ? start_of(mesh, edge) : end_of(mesh, edge);
        const std::int32_t b = negative_start ? end_of(mesh, edge) : start_of(mesh, edge);
        const double drop = level[b] - level[a];
        chains.crossing.push_back({a, b, drop > 0.0 ? -level[a] / drop : 0.5});
    }
    chains.first = std::move(edges.first);
    chains.closed = std::move(edges.closed);
    return chains;
}

} // namespace hrbfnpr::curves
