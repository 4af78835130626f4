// SPDX-License-Identifier: MIT
// Numbers the corners of a grid in the order in which they are asked for.
#pragma once

#include "base/long_array.h"
#include "geometry/cell_grid.h"

namespace hrbfnpr::curves {

class CornerMap {
public:
    explicit CornerMap(base::Memory& memory) noexcept : table_(memory) {}

    // A new corner gets the number of corners so far.
    std::int32_t number_of(std::uint64_t packed, const base::Progress& progress = {}) {
        if (2 * (count_ + 1) > table_.size()) grow(progress);
        Entry& entry = place(table_, packed + 1);
        if (entry.name == 0) entry = {packed + 1, static_cast<std::int32_t>(count_++)};
        return entry.number;
    }

private:
    struct Entry {
        std::uint64_t name; // of the corner, and 1; 0: a free place
        std::int32_t number;
    };

    [[nodiscard]] static Entry& place(base::Array<Entry>& table, std::uint64_t name) noexcept {
        const auto mask = static_cast<std::uint64_t>(table.size() - 1);
        for (std::uint64_t at = geometry::mixed_bits(name) & mask;; at = (at + 1) & mask) {
            Entry& entry = table[static_cast<std::int64_t>(at)];
            if (entry.name == name || entry.name == 0) return entry;
        }
    }
    void grow(const base::Progress& progress) {
        constexpr std::int64_t at_once = 16384;
        base::Array<Entry> larger(table_.memory());
        base::resize_long(larger, std::max<std::int64_t>(1024, 2 * table_.size()), progress);
        for (std::int64_t i = 0; i < table_.size(); ++i) {
            if (i % at_once == 0) progress.check();
            if (table_[i].name != 0) place(larger, table_[i].name) = table_[i];
        }
        table_ = std::move(larger);
    }

    base::Array<Entry> table_; // open addressing, a power of two, at most half full
    std::int64_t count_ = 0;
};

} // namespace hrbfnpr::curves
