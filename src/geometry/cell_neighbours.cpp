#include "geometry/cell_neighbours.h"

namespace hrbfnpr::geometry {

void CellNeighbours::find_blocks(std::uint64_t block) noexcept {
    block_ = block;
    const CellGrid::Cell place = morton_cell(block);
    for (std::size_t step = 0; step < count; ++step) {
        const CellGrid::Cell there = neighbour(place, static_cast<int>(step));
        numbers_[step] = CellGrid::inside(there) ? map_.find_block(morton_code(there)) : nullptr;
    }
}

} // namespace hrbfnpr::geometry
