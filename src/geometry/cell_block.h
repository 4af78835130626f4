// SPDX-License-Identifier: MIT
// Blocks of 4 x 4 x 4 cells, and a table that finds the neighbours of a cell in its block and in the blocks around it.
#pragma once

#include "geometry/cell_grid.h"
#include "geometry/morton.h"

namespace hrbfnpr::geometry {

inline constexpr std::size_t cells_of_block = 64;
inline constexpr int neighbour_count = 27; // includes the cell itself, in the middle

// Returns one of the 27 cells around and including a cell. The first coordinate runs fastest.
[[nodiscard]] constexpr CellGrid::Cell neighbour(const CellGrid::Cell& cell, int step) noexcept {
    return {cell[0] + step % 3 - 1, cell[1] + step / 3 % 3 - 1, cell[2] + step / 9 - 1};
}

// The position of one neighbour of a cell: which of the 27 blocks it is in, and its Morton code in that block
// (morton.h).
struct InBlock {
    std::uint8_t block, cell;
};
using NeighboursInBlocks = std::array<InBlock, neighbour_count>;

// The neighbours of each cell of a block, by the cell's Morton code.
inline constexpr std::array<NeighboursInBlocks, cells_of_block> neighbours_in_blocks = [] {
    std::array<NeighboursInBlocks, cells_of_block> all{};
    for (std::size_t code = 0; code < all.size(); ++code) {
        const CellGrid::Cell at = morton_cell(code);
        for (int step = 0; step < neighbour_count; ++step) {
            const CellGrid::Cell there = neighbour({at[0] + 4, at[1] + 4, at[2] + 4}, step);
            all[code][static_cast<std::size_t>(step)] = {
                static_cast<std::uint8_t>(there[0] / 4 + 3 * (there[1] / 4) + 9 * (there[2] / 4)),
                static_cast<std::uint8_t>(morton_code({there[0] % 4, there[1] % 4, there[2] % 4}))};
        }
    }
    return all;
}();

} // namespace hrbfnpr::geometry
