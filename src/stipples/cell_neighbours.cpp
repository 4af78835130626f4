// SPDX-License-Identifier: MIT
#include "stipples/cell_neighbours.h"

namespace hrbfnpr::stipples {

void CellNeighbours::find_blocks(std::uint64_t block) noexcept {
    block_ = block;
    const geometry::CellGrid::Cell place = geometry::morton_cell(block);
    for (std::size_t step = 0; step < count; ++step) {
        const geometry::CellGrid::Cell there = geometry::neighbour(place, static_cast<int>(step));
        numbers_[step] = geometry::CellGrid::inside(there) ? map_.find_block(geometry::morton_code(there)) : nullptr;
    }
}

} // namespace hrbfnpr::stipples
