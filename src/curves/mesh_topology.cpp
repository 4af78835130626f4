// SPDX-License-Identifier: MIT
#include "curves/mesh_topology.h"

#include "base/assert.h"
#include "base/long_array.h"
#include "curves/clip_mesh.h"

namespace hrbfnpr::curves {

base::Array<std::int32_t> find_neighbours(const base::Runtime& runtime, const base::Array<std::int32_t>& corner,
                                          std::int64_t vertices, const base::Progress& progress) {
    constexpr std::int64_t edges_at_once = 65536; // edges without a look for a cancel
    HRBFNPR_ASSERT(corner.size() % 3 == 0);
    // Edges by the vertex that they start at: edge e = 3 t + k leads from corner k of triangle t.
    base::Array<std::int64_t> begin(runtime.memory);
    base::resize_long(begin, vertices + 2, progress);
    for (std::int64_t e = 0; e < corner.size(); ++e) {
        if (e % edges_at_once == 0) progress.check();
        ++begin[corner[e] + 2];
    }
    for (std::int64_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
    progress.check();
    base::Array<std::int64_t> edge(runtime.memory);
    base::resize_long(edge, corner.size(), progress);
    for (std::int64_t e = 0; e < corner.size(); ++e) {
        if (e % edges_at_once == 0) progress.check();
        edge[begin[corner[e] + 1]++] = e;
    }
    base::Array<std::int32_t> neighbour(runtime.memory);
    neighbour.resize_for_overwrite(corner.size());
    runtime.parallel.for_chunks(corner.size(), 8192, progress, [&](std::int64_t first, std::int64_t end) {
        for (std::int64_t e = first; e < end; ++e) {
            const std::int32_t to = corner[next_in_triangle(e)];
            neighbour[e] = -1;
            for (std::int64_t i = begin[to]; i < begin[to + 1]; ++i)
                if (corner[next_in_triangle(edge[i])] == corner[e])
                    neighbour[e] = static_cast<std::int32_t>(edge[i] / 3);
        }
    });
    return neighbour;
}

} // namespace hrbfnpr::curves
