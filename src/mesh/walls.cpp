// SPDX-License-Identifier: MIT
#include "mesh/walls.h"

#include "mesh/edge_angles.h"

namespace hrbfnpr::mesh {
namespace {

// What is found at the edges of a sheet.
constexpr unsigned ends = 1;    // fewer than two other faces
constexpr unsigned meets = 2;   // others, two or more
constexpr unsigned goes_on = 4; // of these two that lie on each other and look against each other

// Whether two faces that are no twins do so.
bool touch(const EdgeAngles& angles, const base::Array<std::uint8_t>& twin, const Side* first, const Side* last,
           base::Array<Turned>& around) {
    angles.measure(first, last, around);
    for (std::int64_t i = 0; i < around.size(); ++i)
        for (std::int64_t k = i + 1; k < around.size(); ++k) {
            const bool others = twin[around[i].side->face] == 0 && twin[around[k].side->face] == 0;
            const bool against = around[i].side->forward != around[k].side->forward;
            if (others && against && EdgeAngles::alike(around[i], around[k])) return true;
        }
    return false;
}

} // namespace

base::Array<Twin> find_walls(const base::Runtime& runtime, const base::Array<glm::dvec3>& vertex,
                             const base::Array<Triangle>& triangle, const base::Array<std::uint8_t>& twin,
                             const base::Progress& progress) {
    Sets sheets(runtime.memory, triangle.size());
    const EdgeAngles angles(vertex, triangle);
    base::Array<Turned> around(runtime.memory);
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
        const unsigned found = (twins == 1 && !others ? ends : 0U) | (others ? meets : 0U) |
                               (others && touch(angles, twin, first, last, around) ? goes_on : 0U);
        at[one->face] = static_cast<std::uint8_t>(at[one->face] | found);
    });
    base::Array<std::uint8_t> sheet(runtime.memory, triangle.size());
    for (std::int64_t face = 0; face < triangle.size(); ++face) {
        std::uint8_t& all = sheet[sheets.of(static_cast<std::int32_t>(face))];
        all = static_cast<std::uint8_t>(all | at[face]);
    }
    base::Array<Twin> result(runtime.memory, triangle.size());
    for (std::int64_t face = 0; face < triangle.size(); ++face) {
        if (twin[face] == 0) continue;
        const unsigned found = sheet[sheets.of(static_cast<std::int32_t>(face))];
        if ((found & meets) == 0 || (found & ends) != 0) continue;
        result[face] = (found & goes_on) != 0 ? Twin::contact : Twin::wall;
    }
    return result;
}

} // namespace hrbfnpr::mesh
