// SPDX-License-Identifier: MIT
#include "mesh/walls.h"

#include "mesh/edges.h"

namespace hrbfnpr::mesh {

base::Array<std::uint8_t> find_walls(const base::Runtime& runtime, const base::Array<Triangle>& triangle,
                                     const base::Array<std::uint8_t>& twin, const base::Progress& progress) {
    Sets sheets(runtime.memory, triangle.size());
    constexpr std::uint8_t ends = 1;  // at an edge with fewer than two other faces
    constexpr std::uint8_t meets = 2; // others, two or more
    base::Array<std::uint8_t> at(runtime.memory, triangle.size());
    for_edges(sides_by_edge(runtime, triangle, progress), progress, [&](const Side* first, const Side* last) {
        const Side* one = nullptr;
        std::int64_t twins = 0;
        for (const Side* side = first; side != last; ++side) {
            if (twin[side->face] == 0) continue;
            if (one != nullptr) sheets.join(one->face, side->face);
            one = side;
            ++twins;
        }
        if (one == nullptr) return;
        const bool others = last - first - twins >= 2;
        const unsigned found = (twins == 1 && !others ? ends : 0U) | (others ? meets : 0U);
        at[one->face] = static_cast<std::uint8_t>(at[one->face] | found);
    });
    base::Array<std::uint8_t> sheet(runtime.memory, triangle.size());
    for (std::int64_t face = 0; face < triangle.size(); ++face) {
        std::uint8_t& all = sheet[sheets.of(static_cast<std::int32_t>(face))];
        all = static_cast<std::uint8_t>(all | at[face]);
    }
    base::Array<std::uint8_t> wall(runtime.memory, triangle.size());
    for (std::int64_t face = 0; face < triangle.size(); ++face)
        wall[face] = twin[face] != 0 && sheet[sheets.of(static_cast<std::int32_t>(face))] == meets ? 1 : 0;
    return wall;
}

} // namespace hrbfnpr::mesh
