// SPDX-License-Identifier: MIT
// A set of cells of a uniform grid: a hash set of packed cell numbers.
#pragma once

#include "base/memory.h"
#include "geometry/cell_grid.h"

namespace hrbfnpr::geometry {

// Neighbouring cells share an entry of the hash table: a block of 4 x 4 x 4 cells.
class CellSet {
public:
    explicit CellSet(base::Memory& memory) noexcept : table_(memory) {}

    [[nodiscard]] std::int64_t size() const noexcept { return size_; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return table_.bytes(); }
    // Returns all cells, packed, in ascending order.
    [[nodiscard]] base::Array<std::uint64_t> packed() const;
    [[nodiscard]] bool contains(std::uint64_t packed) const noexcept;
    // Returns whether the cell was new.
    bool insert(std::uint64_t packed);
    // Inserts those of the 27 neighbours of a cell (cell_block.h) whose bits are set in `wanted`. Returns the bits of
    // the neighbours that were new.
    std::uint32_t insert_around(const CellGrid::Cell& cell, std::uint32_t wanted);

private:
    struct Block {
        // The packed number of the block's first cell, with the lowest bit set to 1; 0: the slot is free.
        std::uint64_t name;
        std::uint64_t cells;
    };

    [[nodiscard]] static std::int64_t place(const base::Array<Block>& table, std::uint64_t name) noexcept;
    // Inserts the cells of one block whose bits are set in `cells`, and returns the bits of those that were new.
    std::uint64_t insert(std::uint64_t name, std::uint64_t cells);
    void grow();

    base::Array<Block> table_; // open addressing; the size is a power of two, and at most half is used
    std::int64_t blocks_ = 0;
    std::int64_t size_ = 0;
};

} // namespace hrbfnpr::geometry
