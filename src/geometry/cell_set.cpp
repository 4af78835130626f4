#include "geometry/cell_set.h"

namespace hrbfnpr::geometry {
namespace {

// The two lowest bits of each coordinate of a packed cell.
constexpr std::uint64_t in_block = 3U | std::uint64_t{3} << CellGrid::bits | std::uint64_t{3} << (2 * CellGrid::bits);

} // namespace

// Where the block stands, or the free place where it would.
CellSet::Block& CellSet::place(base::Array<Block>& table, std::uint64_t name) noexcept {
    const auto mask = static_cast<std::uint64_t>(table.size() - 1);
    for (std::uint64_t at = mixed_bits(name) & mask;; at = (at + 1) & mask) {
        Block& block = table[static_cast<std::int64_t>(at)];
        if (block.name == name || block.name == 0) return block;
    }
}

void CellSet::grow() {
    base::Array<Block> larger(table_.memory(), std::max<std::int64_t>(64, 2 * table_.size()));
    for (const Block& block : table_)
        if (block.name != 0) place(larger, block.name) = block;
    table_ = std::move(larger);
}

bool CellSet::insert(std::uint64_t packed) {
    if (2 * (blocks_ + 1) > table_.size()) grow();
    const std::uint64_t name = (packed & ~in_block) | 1U;
    const std::uint64_t number =
        (packed & 3U) | (packed >> CellGrid::bits & 3U) << 2U | (packed >> (2 * CellGrid::bits) & 3U) << 4U;
    Block& block = place(table_, name);
    if (block.name == 0) {
        block.name = name;
        ++blocks_;
    }
    const std::uint64_t cell = std::uint64_t{1} << number;
    if ((block.cells & cell) != 0) return false;
    block.cells |= cell;
    ++size_;
    return true;
}

} // namespace hrbfnpr::geometry
