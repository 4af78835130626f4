// From codes of cells to small numbers: a hash table that is filled once and then read by all threads.
#pragma once

#include "base/memory.h"

namespace hrbfnpr::geometry {

class CellMap {
public:
    explicit CellMap(base::Memory& memory) noexcept : code_(memory), number_(memory) {}
    // The number of codes[i] is i.  Codes differ, and are below 2^63.
    CellMap(base::Memory& memory, const base::Array<std::uint64_t>& codes);

    // -1: not there.
    [[nodiscard]] std::int32_t find(std::uint64_t code) const noexcept;

private:
    [[nodiscard]] std::int64_t place(std::uint64_t code) const noexcept;

    base::Array<std::uint64_t> code_; // open addressing, a power of two, at most half full; code + 1, 0 = free
    base::Array<std::int32_t> number_;
};

} // namespace hrbfnpr::geometry
