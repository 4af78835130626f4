// SPDX-License-Identifier: MIT
#include "mesh/walls.h"

#include "mesh/edges.h"

namespace hrbfnpr::mesh {

base::Array<std::uint8_t> find_walls(const base::Runtime& runtime, const base::Array<Triangle>& triangle,
                                     const base::Array<std::uint8_t>& twin, const base::Progress& progress) {
    Sets sheets(runtime.memory, triangle.size());
    base::Array<std::uint8_t> ends(runtime.memory, triangle.size()); // at an edge with fewer than two other faces
    for_edges(sides_by_edge(runtime, triangle, progress), progress, [&](const Side* first, const Side* last) {
        const Side* one = nullptr;
        std::int64_t twins = 0;
        for (const Side* side = first; side != last; ++side) {
            if (twin[side->face] == 0) continue;
            if (one != nullptr) sheets.join(one->face, side->face);
            one = side;
            ++twins;
        }
        if (twins == 1 && last - first < 3) ends[one->face] = 1;
    });
    base::Array<std::uint8_t> open(runtime.memory, triangle.size());
    for (std::int64_t face = 0; face < triangle.size(); ++face)
        if (ends[face] != 0) open[sheets.of(static_cast<std::int32_t>(face))] = 1;
    base::Array<std::uint8_t> wall(runtime.memory, triangle.size());
    for (std::int64_t face = 0; face < triangle.size(); ++face)
        wall[face] = twin[face] != 0 && open[sheets.of(static_cast<std::int32_t>(face))] == 0 ? 1 : 0;
    return wall;
}

} // namespace hrbfnpr::mesh
