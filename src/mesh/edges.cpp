// SPDX-License-Identifier: MIT
#include "mesh/edges.h"

#include <algorithm>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t vertices_a_task = 4096;

[[nodiscard]] bool before(const Side& a, const Side& b) noexcept {
    return a.edge < b.edge || (a.edge == b.edge && a.face < b.face);
}

[[nodiscard]] Side side_of(const base::Array<Triangle>& triangle, std::int64_t face, std::size_t k) noexcept {
    const auto a = static_cast<std::uint64_t>(triangle[face][k]);
    const auto b = static_cast<std::uint64_t>(triangle[face][(k + 1) % 3]);
    return {std::min(a, b) << 32U | std::max(a, b), static_cast<std::int32_t>(face), a < b ? 1 : 0};
}

// Returns an array in which element v + 1 is the number of sides whose lower vertex is below v.
[[nodiscard]] base::Array<std::int64_t> begins_of_vertices(const base::Work& work,
                                                           const base::Array<Triangle>& triangle) {
    std::int32_t last = -1;
    for (const std::int64_t face : work.over(triangle.size()))
        for (const std::int32_t v : triangle[face]) last = std::max(last, v);
    base::Array<std::int64_t> begin(work.memory, std::int64_t{last} + 3);
    for (const std::int64_t face : work.over(triangle.size()))
        for (std::size_t k = 0; k < 3; ++k) ++begin[low_end(side_of(triangle, face, k)) + 2];
    for (std::int64_t v = 2; v < begin.size(); ++v) begin[v] += begin[v - 1];
    return begin;
}

} // namespace

// The sides are sorted by counting them at their lower vertex. A vertex has only a few sides, which are then sorted.
base::Array<Side> sides_by_edge(const base::Work& work, const base::Array<Triangle>& triangle) {
    base::Array<std::int64_t> begin = begins_of_vertices(work, triangle);
    base::Array<Side> sides(work.memory);
    sides.resize_for_overwrite(3 * triangle.size());
    for (const std::int64_t face : work.over(triangle.size()))
        for (std::size_t k = 0; k < 3; ++k) {
            const Side side = side_of(triangle, face, k);
            sides[begin[low_end(side) + 1]++] = side;
        }
    // begin[v] is now the number of sides before vertex v.
    work.for_chunks(begin.size() - 2, vertices_a_task, [&](std::int64_t first, std::int64_t end) {
        for (std::int64_t v = first; v < end; ++v)
            std::sort(sides.begin() + begin[v], sides.begin() + begin[v + 1], before);
    });
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
