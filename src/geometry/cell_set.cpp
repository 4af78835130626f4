#include "geometry/cell_set.h"

namespace hrbfnpr::geometry {
bool CellSet::place(base::Array<std::uint64_t>& table, std::uint64_t stored) noexcept {
    const auto mask = static_cast<std::uint64_t>(table.size() - 1);
    for (std::uint64_t at = mixed_bits(stored) & mask;; at = (at + 1) & mask) {
        std::uint64_t& entry = table[static_cast<std::int64_t>(at)];
        if (entry == stored) return false;
        if (entry == 0) {
            entry = stored;
            return true;
        }
    }
}

void CellSet::grow() {
    base::Array<std::uint64_t> larger(table_.memory(), std::max<std::int64_t>(64, 2 * table_.size()));
    for (const std::uint64_t stored : table_)
        if (stored != 0) place(larger, stored);
    table_ = std::move(larger);
}

bool CellSet::insert(std::uint64_t packed) {
    if (2 * (size_ + 1) > table_.size()) grow();
    if (!place(table_, packed + 1)) return false;
    ++size_;
    return true;
}

} // namespace hrbfnpr::geometry
