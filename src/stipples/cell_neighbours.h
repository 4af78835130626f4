// SPDX-License-Identifier: MIT
// The cells around one: quick for cells that follow each other along the curve, since those of a block of the map share
// the 27 blocks around it.
#pragma once

#include "geometry/cell_block.h"
#include "stipples/cell_map.h"

namespace hrbfnpr::stipples {

class CellNeighbours {
public:
    static constexpr std::size_t count = geometry::neighbour_count;
    static constexpr std::size_t itself = 13;
    static constexpr std::size_t step_along[3] = {1, 3, 9};

    explicit CellNeighbours(const CellMap& map) noexcept : map_(map) {}

    void go_to(std::uint64_t code) noexcept {
        if (code / geometry::cells_of_block != block_) find_blocks(code / geometry::cells_of_block);
        cell_ = code % geometry::cells_of_block;
    }
    // Numbers of the map; -1: not there.
    [[nodiscard]] std::int32_t operator[](std::size_t step) const noexcept {
        const geometry::InBlock& there = geometry::neighbours_in_blocks[cell_][step];
        const std::int32_t* const numbers = numbers_[there.block];
        return numbers == nullptr ? -1 : numbers[there.cell];
    }

private:
    void find_blocks(std::uint64_t block) noexcept;

    const CellMap& map_;
    std::uint64_t block_ = ~std::uint64_t{0};
    std::uint64_t cell_ = 0;
    std::array<const std::int32_t*, count> numbers_{};
};

} // namespace hrbfnpr::stipples
