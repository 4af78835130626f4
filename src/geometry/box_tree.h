// SPDX-License-Identifier: MIT
// A tree of boxes over items in a given order. The tree is fastest if items with consecutive indices are near each
// other in space.
#pragma once

#include "base/assert.h"
#include "base/long_array.h"
#include "base/work.h"
#include "geometry/vec.h"

#include <algorithm>
#include <array>

namespace hrbfnpr::geometry {

class BoxTree {
public:
    // bounds(i) returns the box of item i. It is called on all threads.
    template <class BoundsOf>
    BoxTree(const base::Work& work, std::int64_t items, BoundsOf&& bounds);

    // Calls visit(item) for all items whose box satisfies meets(box), and for some others in the same leaves.
    template <class Meets, class Visit>
    void visit(Meets&& meets, Visit&& visit) const;

    // Returns the box of all items.
    [[nodiscard]] const Bounds& bounds() const noexcept { return box_[1]; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return box_.bytes(); }

private:
    static constexpr std::int64_t leaf_size = 4;

    std::int64_t items_;
    std::int64_t leaves_ = 1; // a power of two
    base::Array<Bounds> box_; // node boxes in heap order: node 1 is the root, 2 i and 2 i + 1 are the children of i
};

template <class BoundsOf>
BoxTree::BoxTree(const base::Work& work, std::int64_t items, BoundsOf&& bounds) : items_(items), box_(work.memory) {
    HRBFNPR_ASSERT(items >= 0);
    while (leaves_ * leaf_size < items) leaves_ *= 2;
    base::fill_long(box_, 2 * leaves_, Bounds{}, work);
    const std::int64_t used = (items + leaf_size - 1) / leaf_size;
    work.for_chunks(used, 1024, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin * leaf_size; i < std::min(end * leaf_size, items); ++i) {
            const Bounds own = bounds(i);
            box_[leaves_ + i / leaf_size].extend(own.min);
            box_[leaves_ + i / leaf_size].extend(own.max);
        }
    });
    for (const std::int64_t i : work.over(leaves_ - 1)) {
        const std::int64_t node = leaves_ - 1 - i; // Children come before their parents.
        box_[node] = {glm::min(box_[2 * node].min, box_[2 * node + 1].min),
                      glm::max(box_[2 * node].max, box_[2 * node + 1].max)};
    }
}

template <class Meets, class Visit>
void BoxTree::visit(Meets&& meets, Visit&& visit) const {
    std::array<std::int64_t, 64> stack{1}; // room for one waiting node per level, and one more
    std::size_t depth = 1;
    while (depth > 0) {
        const std::int64_t node = stack[--depth];
        if (box_[node].empty() || !meets(box_[node])) continue;
        if (node < leaves_) {
            HRBFNPR_ASSERT(depth + 2 <= stack.size());
            stack[depth++] = 2 * node + 1;
            stack[depth++] = 2 * node;
            continue;
        }
        const std::int64_t begin = (node - leaves_) * leaf_size;
        for (std::int64_t i = begin; i < std::min(begin + leaf_size, items_); ++i) visit(i);
    }
}

} // namespace hrbfnpr::geometry
