// SPDX-License-Identifier: MIT
// Sorts items by their group: for example corners by vertex, or faces by component.
#pragma once

#include "base/assert.h"
#include "base/memory.h"

#include <span>

namespace hrbfnpr::base {

class Groups {
public:
    // for_items(put) must call put(group, item) for every item. It is called twice, and must make the same calls both
    // times. The items of a group keep the order of the calls.
    template <class ForItems>
    Groups(Memory& memory, std::int64_t groups, ForItems&& for_items) : begin_(memory, groups + 2), item_(memory) {
        HRBFNPR_ASSERT(groups >= 0);
        for_items([&](std::int64_t group, std::int32_t) { ++begin_[group + 2]; });
        for (std::int64_t group = 2; group < begin_.size(); ++group) begin_[group] += begin_[group - 1];
        item_.resize_for_overwrite(begin_.back());
        for_items([&](std::int64_t group, std::int32_t item) { item_[begin_[group + 1]++] = item; });
    }

    [[nodiscard]] std::span<const std::int32_t> operator[](std::int64_t group) const noexcept {
        HRBFNPR_ASSERT(group >= 0 && group < groups());
        return item_.span().subspan(static_cast<std::size_t>(begin_[group]), static_cast<std::size_t>(count(group)));
    }
    [[nodiscard]] std::int64_t groups() const noexcept { return begin_.size() - 2; }
    [[nodiscard]] std::int64_t count(std::int64_t group) const noexcept { return begin_[group + 1] - begin_[group]; }

private:
    Array<std::int64_t> begin_; // The items of group g are item_[begin_[g]] to item_[begin_[g + 1] - 1].
    Array<std::int32_t> item_;
};

} // namespace hrbfnpr::base
