// SPDX-License-Identifier: MIT
#include "mesh/edges.h"

#include "base/sort.h"

#include <algorithm>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t run = 1 << 16; // The number of sides that one task sorts.

[[nodiscard]] bool before(const Side& a, const Side& b) noexcept {
    return a.edge < b.edge || (a.edge == b.edge && a.face < b.face);
}

void merge_runs(const base::Work& work, base::Array<Side>& sides) {
    base::Array<Side> other(work.memory);
    other.resize_for_overwrite(sides.size());
    for (std::int64_t width = run; width < sides.size(); width *= 2) {
        work.for_chunks(sides.size(), 2 * width, [&](std::int64_t begin, std::int64_t end) {
            const std::int64_t middle = std::min(begin + width, end);
            base::merge_long(sides.begin() + begin, sides.begin() + middle, sides.begin() + middle, sides.begin() + end,
                             other.begin() + begin, before, work);
        });
        std::swap(sides, other);
    }
}

} // namespace

base::Array<Side> sides_by_edge(const base::Work& work, const base::Array<Triangle>& triangle) {
    base::Array<Side> sides(work.memory);
    sides.resize_for_overwrite(3 * triangle.size());
    work.for_chunks(triangle.size(), run / 3, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t face = begin; face < end; ++face)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto a = static_cast<std::uint64_t>(triangle[face][k]);
                const auto b = static_cast<std::uint64_t>(triangle[face][(k + 1) % 3]);
                sides[3 * face + static_cast<std::int64_t>(k)] = {std::min(a, b) << 32U | std::max(a, b),
                                                                  static_cast<std::int32_t>(face), a < b ? 1 : 0};
            }
    });
    work.for_chunks(sides.size(), run, [&](std::int64_t begin, std::int64_t end) {
        std::sort(sides.begin() + begin, sides.begin() + end, before);
    });
    merge_runs(work, sides);
    return sides;
}

base::Array<std::int64_t> sides_beyond(const base::Array<Triangle>& triangle, const base::Array<Side>& sides,
                                       const base::Progress& progress) {
    base::Array<std::int64_t> beyond(triangle.memory());
    beyond.resize_for_overwrite(3 * triangle.size());
    std::fill(beyond.begin(), beyond.end(), -1);
    for_edges(sides, progress, [&](const Side* first, const Side* last) {
        if (last - first != 2) return;
        const std::int64_t one = number_of(triangle, first[0]), other = number_of(triangle, first[1]);
        beyond[one] = other;
        beyond[other] = one;
    });
    return beyond;
}

base::Array<std::int32_t> components_of(const base::Array<Triangle>& triangle, std::int64_t vertices,
                                        std::int64_t& count, const base::Progress& progress) {
    base::Memory& memory = triangle.memory();
    UnionFind sets(memory, vertices);
    for (const std::int64_t face : progress.over(triangle.size())) {
        const Triangle& t = triangle[face];
        sets.join(t[0], t[1]);
        sets.join(t[0], t[2]);
    }
    NumbersByFirstUse numbers(memory, vertices);
    base::Array<std::int32_t> component(memory, triangle.size());
    for (const std::int64_t face : progress.over(triangle.size())) {
        component[face] = numbers.of(sets.find(triangle[face][0]));
    }
    count = numbers.count();
    return component;
}

} // namespace hrbfnpr::mesh
