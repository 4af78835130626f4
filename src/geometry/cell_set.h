// SPDX-License-Identifier: MIT
// A set of cells of a uniform grid: a hash set of packed cell numbers.
#pragma once

#include "base/memory.h"
#include "geometry/cell_grid.h"

namespace hrbfnpr::geometry {

// Cells that are near each other share entries: blocks of 4 x 4 x 4.
class CellSet {
public:
    explicit CellSet(base::Memory& memory) noexcept : table_(memory) {}

    [[nodiscard]] std::int64_t size() const noexcept { return size_; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return table_.bytes(); }
    // All of them, packed, rising.
    [[nodiscard]] base::Array<std::uint64_t> packed() const;
    [[nodiscard]] bool contains(std::uint64_t packed) const noexcept;
    // Whether the cell was new.
    bool insert(std::uint64_t packed);
    // Of the 27 neighbours, those with their bits set; returns the bits of the new ones.
    std::uint32_t insert_around(const CellGrid::Cell& cell, std::uint32_t wanted);

private:
    struct Block {
        std::uint64_t name; // its first cell, and 1 in the lowest bit; 0: a free place
        std::uint64_t cells;
    };

    [[nodiscard]] static std::int64_t place(const base::Array<Block>& table, std::uint64_t name) noexcept;
    // Of these cells of a block the new ones.
    std::uint64_t insert(std::uint64_t name, std::uint64_t cells);
    void grow();

    base::Array<Block> table_; // open addressing, a power of two, at most half full
    std::int64_t blocks_ = 0;
    std::int64_t size_ = 0;
};

} // namespace hrbfnpr::geometry
