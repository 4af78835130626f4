// SPDX-License-Identifier: MIT
#include "geometry/cell_set.h"

#include "geometry/cell_block.h"

#include <algorithm>
#include <bit>

namespace hrbfnpr::geometry {
namespace {

// A mask for the two lowest bits of each coordinate of a packed cell.
constexpr std::uint64_t in_block = 3U | std::uint64_t{3} << CellGrid::bits | std::uint64_t{3} << (2 * CellGrid::bits);

// block_of returns the name of a cell's block, and bit_of the cell's bit in it.
std::uint64_t block_of(std::uint64_t packed) noexcept { return (packed & ~in_block) | 1U; }
std::uint64_t bit_of(std::uint64_t packed) noexcept {
    return std::uint64_t{1} << morton_code(CellGrid::unpack(packed & in_block));
}

} // namespace

// Returns the slot of the block, or the free slot where it would be inserted.
std::int64_t CellSet::place(const base::Array<Block>& table, std::uint64_t name) noexcept {
    const auto mask = static_cast<std::uint64_t>(table.size() - 1);
    for (std::uint64_t at = hash_bits(name) & mask;; at = (at + 1) & mask) {
        const auto number = static_cast<std::int64_t>(at);
        if (table[number].name == name || table[number].name == 0) return number;
    }
}

void CellSet::grow() {
    base::Array<Block> larger(table_.memory(), std::max<std::int64_t>(64, 2 * table_.size()));
    for (const Block& block : table_)
        if (block.name != 0) larger[place(larger, block.name)] = block;
    table_ = std::move(larger);
}

std::uint64_t CellSet::insert(std::uint64_t name, std::uint64_t cells) {
    if (2 * (blocks_ + 1) > table_.size()) grow();
    Block& block = table_[place(table_, name)];
    if (block.name == 0) {
        block.name = name;
        ++blocks_;
    }
    const std::uint64_t fresh = cells & ~block.cells;
    block.cells |= cells;
    size_ += std::popcount(fresh);
    return fresh;
}

bool CellSet::insert(std::uint64_t packed) { return insert(block_of(packed), bit_of(packed)) != 0; }

base::Array<std::uint64_t> CellSet::packed() const {
    base::Array<std::uint64_t> all(table_.memory());
    for (const Block& block : table_)
        for (std::uint64_t left = block.cells; left != 0; left &= left - 1)
            all.push_back((block.name & ~in_block) |
                          CellGrid::pack(morton_cell(static_cast<std::uint64_t>(std::countr_zero(left)))));
    std::sort(all.begin(), all.end());
    return all;
}

bool CellSet::contains(std::uint64_t packed) const noexcept {
    return size_ > 0 && (table_[place(table_, block_of(packed))].cells & bit_of(packed)) != 0;
}

std::uint32_t CellSet::insert_around(const CellGrid::Cell& cell, std::uint32_t wanted) {
    const NeighboursInBlocks& place = neighbours_in_blocks[morton_code({cell[0] & 3, cell[1] & 3, cell[2] & 3})];
    std::array<std::uint64_t, neighbour_count> cells{}; // the wanted cells of each of the 27 blocks
    std::uint32_t blocks = 0;
    for (std::uint32_t left = wanted; left != 0; left &= left - 1) {
        const InBlock& there = place[static_cast<std::size_t>(std::countr_zero(left))];
        cells[there.block] |= std::uint64_t{1} << there.cell;
        blocks |= 1U << there.block;
    }
    for (; blocks != 0; blocks &= blocks - 1) {
        const int b = std::countr_zero(blocks);
        const CellGrid::Cell block = neighbour({cell[0] / 4, cell[1] / 4, cell[2] / 4}, b);
        std::uint64_t& of_block = cells[static_cast<std::size_t>(b)];
        of_block = insert(CellGrid::pack({4 * block[0], 4 * block[1], 4 * block[2]}) | 1U, of_block);
    }
    std::uint32_t fresh = 0;
    for (std::uint32_t left = wanted; left != 0; left &= left - 1) {
        const int step = std::countr_zero(left);
        const InBlock& there = place[static_cast<std::size_t>(step)];
        fresh |= static_cast<std::uint32_t>(cells[there.block] >> there.cell & 1U) << static_cast<unsigned>(step);
    }
    return fresh;
}

} // namespace hrbfnpr::geometry
