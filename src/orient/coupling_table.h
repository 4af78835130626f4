// SPDX-License-Identifier: MIT
// Sums by the name of a cluster: a hash table that is used again and again.
#pragma once

#include "base/memory.h"
#include "geometry/cell_grid.h"

namespace hrbfnpr::orient {

class CouplingTable {
public:
    explicit CouplingTable(base::Memory& memory) : place_(memory, 64), entry_(memory) { clear(); }

    void clear() noexcept {
        for (const Entry& entry : entry_) place_[entry.place] = 0;
        entry_.clear();
    }
    void add(std::int32_t name, double number) {
        std::int64_t at = hash(name);
        while (place_[at] != 0 && entry_[place_[at] - 1].name != name) at = (at + 1) & (place_.size() - 1);
        if (place_[at] == 0) {
            entry_.push_back({name, at, 0.0});
            place_[at] = entry_.size();
            if (2 * entry_.size() > place_.size()) grow();
            entry_.back().sum += number;
            return;
        }
        entry_[place_[at] - 1].sum += number;
    }
    // visit(name, sum), in the order in which the names came.
    template <class Visit>
    void for_each(Visit&& visit) const {
        for (const Entry& entry : entry_) visit(entry.name, entry.sum);
    }

private:
    struct Entry {
        std::int32_t name;
        std::int64_t place;
        double sum;
    };

    [[nodiscard]] std::int64_t hash(std::int32_t name) const noexcept {
        return static_cast<std::int64_t>(geometry::mixed_bits(static_cast<std::uint64_t>(name)) &
                                         static_cast<std::uint64_t>(place_.size() - 1));
    }
    void grow() {
        const std::int64_t size = 2 * place_.size();
        place_.clear();
        place_.resize(size);
        for (std::int64_t k = 0; k < entry_.size(); ++k) {
            std::int64_t at = hash(entry_[k].name);
            while (place_[at] != 0) at = (at + 1) & (size - 1);
            place_[at] = k + 1;
            entry_[k].place = at;
        }
    }

    base::Array<std::int64_t> place_; // 1 + entry; 0: free.  A power of two
    base::Array<Entry> entry_;
};

} // namespace hrbfnpr::orient
