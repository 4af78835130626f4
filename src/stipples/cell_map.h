// SPDX-License-Identifier: MIT
// From codes of cells along a space-filling curve (morton.h) to small numbers: a hash table of blocks of 4 x 4 x 4
// cells, that is filled once and then read by all threads.
#pragma once

#include "base/memory.h"
#include "geometry/cell_block.h"

#include <array>

namespace hrbfnpr::stipples {

class CellMap {
public:
    explicit CellMap(base::Memory& memory) noexcept : place_(memory), number_(memory) {}
    // The number of codes[i] is i.  Codes differ, are below 2^63, and those of a block follow each other.
    CellMap(base::Memory& memory, const base::Array<std::uint64_t>& codes);

    // -1: not there.
    [[nodiscard]] std::int32_t find(std::uint64_t code) const noexcept {
        const std::int32_t* const numbers = find_block(code / geometry::cells_of_block);
        return numbers == nullptr ? -1 : numbers[code % geometry::cells_of_block];
    }

    // The numbers of all cells of a block, in the order of their codes; null: there are none.
    [[nodiscard]] const std::int32_t* find_block(std::uint64_t block) const noexcept {
        if (place_.empty()) return nullptr;
        const Place& place = place_[place_of(block)];
        return place.taken == 0 ? nullptr : number_[place.numbers].data();
    }

private:
    struct Place {
        std::uint64_t taken; // block + 1; 0 = free
        std::int64_t numbers;
    };
    [[nodiscard]] std::int64_t place_of(std::uint64_t block) const noexcept;

    base::Array<Place> place_; // open addressing, a power of two, at most half full
    base::Array<std::array<std::int32_t, geometry::cells_of_block>> number_;
};

} // namespace hrbfnpr::stipples
