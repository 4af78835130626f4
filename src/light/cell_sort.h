// SPDX-License-Identifier: MIT
// Sorts places of a surface by the cells of a grid, and by the axes that their normals are nearest to.
#pragma once

#include "base/memory.h"
#include "base/sort_on_threads.h"
#include "base/work.h"
#include "geometry/cell_grid.h"
#include "geometry/vec_array.h"

#include <glm/common.hpp>

#include <cstdint>

namespace hrbfnpr::light {

struct InCell {
    std::uint64_t cell;
    std::uint32_t side; // the number of the direction, of six along the axes, to which the normal is nearest
    std::uint32_t index;

    [[nodiscard]] bool is_with(const InCell& other) const noexcept { return cell == other.cell && side == other.side; }
    [[nodiscard]] bool operator<(const InCell& other) const noexcept {
        if (cell != other.cell) return cell < other.cell;
        return side != other.side ? side < other.side : index < other.index;
    }
};

[[nodiscard]] inline std::uint32_t side_of(const glm::dvec3& normal) noexcept {
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<std::uint32_t>(2 * axis + (normal[axis] < 0.0 ? 1 : 0));
}

// Returns the indices below `count`, sorted. place_of(i) and normal_of(i) give a place, and a normal of any length.
template <class PlaceOf, class NormalOf>
[[nodiscard]] base::Array<InCell> sort_into_cells(const base::Work& work, std::int64_t count,
                                                  const geometry::CellGrid& grid, const PlaceOf& place_of,
                                                  const NormalOf& normal_of) {
    base::Array<InCell> sorted(work.memory);
    sorted.resize_for_overwrite(count);
    work.for_chunks(count, 65536, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            sorted[i] = {geometry::CellGrid::pack(grid.cell_of(place_of(i))), side_of(normal_of(i)),
                         static_cast<std::uint32_t>(i)};
    });
    base::sort_on_threads(work, sorted, [](const InCell& a, const InCell& b) { return a < b; });
    return sorted;
}

[[nodiscard]] inline geometry::Bounds bounds_of(const geometry::VecArray& position) noexcept {
    geometry::Bounds bounds;
    for (std::int64_t i = 0; i < position.size(); ++i) bounds.extend(position[i]);
    return bounds;
}

} // namespace hrbfnpr::light
