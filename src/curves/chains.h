// SPDX-License-Identifier: MIT
// Chains of points: their storage, their division into parts, and the insertion of points.
#pragma once

#include "base/assert.h"
#include "base/memory.h"

#include <cstdint>
#include <utility>

namespace hrbfnpr::curves {

// Open or closed chains, stored one after the other.
template <class T>
struct Chains {
    explicit Chains(base::Memory& memory) : first(memory, 1), closed(memory), point(memory) {}

    base::Array<std::int64_t> first; // the index of the first point of each chain; at the end, the number of points
    // For each chain: 1 if the first point follows the last one; the first point is not repeated.
    base::Array<std::uint8_t> closed;
    base::Array<T> point;

    [[nodiscard]] std::int64_t count() const noexcept { return closed.size(); }
    [[nodiscard]] std::int64_t size_of(std::int64_t chain) const noexcept {
        HRBFNPR_ASSERT(chain >= 0 && chain < count());
        return first[chain + 1] - first[chain];
    }
    // Returns the index of the point after point i of a chain, or -1 if i is the last point.
    [[nodiscard]] std::int64_t next(std::int64_t chain, std::int64_t i) const noexcept {
        HRBFNPR_ASSERT(i >= first[chain] && i < first[chain + 1]);
        if (i + 1 < first[chain + 1]) return i + 1;
        return closed[chain] != 0 ? first[chain] : -1;
    }
    // Returns the number of pieces of a chain. A piece is between two consecutive points.
    [[nodiscard]] std::int64_t pieces_of(std::int64_t chain) const noexcept {
        return size_of(chain) - (closed[chain] != 0 ? 0 : 1);
    }
    // Makes a chain of all points added since the end of the last chain.
    void end(bool is_closed) {
        HRBFNPR_ASSERT(first.size() == closed.size() + 1);
        first.push_back(point.size());
        closed.push_back(is_closed ? 1 : 0);
    }
    [[nodiscard]] std::int64_t bytes() const noexcept { return first.bytes() + closed.bytes() + point.bytes(); }
};

// Calls part(begin, end, whole) for each maximal run of wanted points among the points 0 to count - 1. In a closed
// chain, an index i past the end means point i % count. `whole` is true if all points of a closed chain are wanted.
template <class Wanted, class Part>
void for_parts(std::int64_t count, bool closed, Wanted&& wanted, Part&& part) {
    HRBFNPR_ASSERT(count >= 0);
    std::int64_t start = 0;
    while (closed && start < count && wanted(start)) ++start;
    if (closed && start == count) {
        part(std::int64_t{0}, count, true);
        return;
    }
    for (std::int64_t i = start; i < start + count;) {
        std::int64_t end = i;
        while (end < start + count && wanted(end % count)) ++end;
        if (end > i) part(i, end, false);
        i = end + 1;
    }
}

// Calls part(begin, end, whole) for each maximal run of joined points. joined(i) returns whether point i is joined to
// the next point. It is not called for the last point of an open chain.
template <class Joined, class Part>
void for_joined(std::int64_t count, bool closed, Joined&& joined, Part&& part) {
    HRBFNPR_ASSERT(count >= 0);
    std::int64_t start = 0;
    while (closed && start < count && joined((start + count - 1) % count)) ++start;
    if (closed && start == count) {
        part(std::int64_t{0}, count, true);
        return;
    }
    for (std::int64_t i = start; i < start + count;) {
        std::int64_t end = i + 1;
        while (end < start + count && joined((end - 1) % count)) ++end;
        part(i, end, false);
        i = end;
    }
}

// Calls visit(i, j) for the two end points of each piece.
template <class T, class Visit>
void for_pieces(const Chains<T>& chains, Visit&& visit) {
    for (std::int64_t c = 0; c < chains.count(); ++c)
        for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i)
            if (const std::int64_t j = chains.next(c, i); j >= 0) visit(i, j);
}

// Inserts points into pieces of chains. Returns whether it inserted any. wanted(chain, i, j, p) returns whether the
// piece from point i to point j needs a point, and sets p to a first guess. bring(points, chains, pieces) improves the
// guesses, and returns 1 for each point to insert, else 0. A piece is given by its first point.
template <class T, class Wanted, class Bring>
bool halve_pieces(Chains<T>& chains, Wanted&& wanted, Bring&& bring) {
    base::Memory& memory = chains.first.memory();
    base::Array<T> added(memory);
    base::Array<std::int64_t> after(memory), of(memory);
    for (std::int64_t c = 0; c < chains.count(); ++c)
        for (std::int64_t i = chains.first[c]; i < chains.first[c + 1]; ++i) {
            const std::int64_t j = chains.next(c, i);
            T p{};
            if (j < 0 || !wanted(c, i, j, p)) continue;
            added.push_back(p);
            after.push_back(i);
            of.push_back(c);
        }
    if (added.empty()) return false;
    const base::Array<std::uint8_t> found = bring(added, of, after);
    HRBFNPR_ASSERT(found.size() == added.size());
    base::Array<T> points(memory);
    points.reserve(chains.point.size() + added.size());
    std::int64_t k = 0;
    std::int64_t begin = 0;
    for (std::int64_t c = 0; c < chains.count(); ++c) {
        for (std::int64_t i = begin; i < chains.first[c + 1]; ++i) {
            points.push_back(chains.point[i]);
            if (k == after.size() || after[k] != i) continue;
            if (found[k] != 0) points.push_back(added[k]);
            ++k;
        }
        begin = std::exchange(chains.first[c + 1], points.size());
    }
    HRBFNPR_ASSERT(k == after.size());
    const bool any = points.size() > chains.point.size();
    chains.point = std::move(points);
    return any;
}

} // namespace hrbfnpr::curves
