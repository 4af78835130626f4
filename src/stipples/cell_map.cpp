// SPDX-License-Identifier: MIT
#include "stipples/cell_map.h"

#include <bit>

namespace hrbfnpr::stipples {

CellMap::CellMap(base::Memory& memory, const base::Array<std::uint64_t>& codes) : CellMap(memory) {
    const auto block_of = [&](std::int64_t i) { return codes[i] / geometry::cells_of_block; };
    std::int64_t blocks = 0;
    for (std::int64_t i = 0; i < codes.size(); ++i)
        if (i == 0 || block_of(i) != block_of(i - 1)) ++blocks;
    place_.resize(static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(2 * blocks + 2))));
    number_.reserve(blocks);
    for (std::int64_t i = 0; i < codes.size(); ++i) {
        if (i == 0 || block_of(i) != block_of(i - 1)) {
            place_[place_of(block_of(i))] = {block_of(i) + 1, number_.size()};
            number_.push_back({});
            number_.back().fill(-1);
        }
        number_.back()[codes[i] % geometry::cells_of_block] = static_cast<std::int32_t>(i);
    }
}

// Where the block stands, or the free place where it would.
std::int64_t CellMap::place_of(std::uint64_t block) const noexcept {
    const auto mask = static_cast<std::uint64_t>(place_.size() - 1);
    std::uint64_t at = geometry::mixed_bits(block) & mask;
    const auto taken = [&] { return place_[static_cast<std::int64_t>(at)].taken; };
    while (taken() != 0 && taken() != block + 1) at = (at + 1) & mask;
    return static_cast<std::int64_t>(at);
}

} // namespace hrbfnpr::stipples
