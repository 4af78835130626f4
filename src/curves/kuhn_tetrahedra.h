// SPDX-License-Identifier: MIT
// A cube cut into six tetrahedra around its diagonal (Kuhn 1960), in every cube alike, so that those of adjacent cubes
// share their faces; and how a surface that separates their corners passes through them.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace hrbfnpr::curves {

// Corners of the cube are numbered by bits: x, y, z.  A tetrahedron goes from corner 0 to corner 7 by one bit at a
// time, so that every edge leads from a corner to one with more bits.
struct Tetrahedron {
    std::array<std::uint8_t, 4> corner;
    std::uint8_t corners; // as a set
    bool even;            // positively oriented
};

inline constexpr std::array<Tetrahedron, 6> tetrahedra = [] {
    constexpr std::array<std::array<unsigned, 3>, 6> orders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
    std::array<Tetrahedron, 6> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const unsigned first = 1U << orders[i][0];
        const unsigned second = first | 1U << orders[i][1];
        all[i].corner = {0, static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second), 7};
        all[i].corners = static_cast<std::uint8_t>(1U | 1U << first | 1U << second | 1U << 7U);
        all[i].even = i < 3;
    }
    return all;
}();

// Where the surface meets a tetrahedron: a polygon with a corner on each of these edges, counter-clockwise as seen from
// the positive corners if the tetrahedron is even, else clockwise.
struct Section {
    std::uint8_t size = 0;                             // 0, 3 or 4
    std::array<std::array<std::uint8_t, 2>, 4> edge{}; // between the corners of the tetrahedron, the lower one first
};

namespace detail {

constexpr std::array<std::uint8_t, 2> edge(unsigned a, unsigned b) {
    return {static_cast<std::uint8_t>(a < b ? a : b), static_cast<std::uint8_t>(a < b ? b : a)};
}

// Around the corner i: (i, i ^ 1, i ^ 2, i ^ 3) is an even order of the four.
constexpr Section triangle(unsigned i, bool negative) {
    const unsigned second = negative ? 1 : 2;
    return {3, {edge(i, i ^ 3U), edge(i, i ^ second), edge(i, i ^ (3U - second))}};
}

// Between the corners 0 and j and the other two; (0, j, k, l) is an even order.
constexpr Section quadrilateral(unsigned j, bool negative) {
    const unsigned k = j == 1 ? 2 : (j == 2 ? 3 : 1);
    const unsigned l = 6 - j - k;
    if (negative) return {4, {edge(0, k), edge(0, l), edge(j, l), edge(j, k)}};
    return {4, {edge(j, k), edge(j, l), edge(0, l), edge(0, k)}};
}

} // namespace detail

// By the set of negative corners.
inline constexpr std::array<Section, 16> sections = [] {
    std::array<Section, 16> all{};
    for (unsigned set = 1; set < 15; ++set) {
        const int count = std::popcount(set);
        const unsigned other = ~set & 15U;
        if (count == 1) all[set] = detail::triangle(static_cast<unsigned>(std::countr_zero(set)), true);
        if (count == 3) all[set] = detail::triangle(static_cast<unsigned>(std::countr_zero(other)), false);
        if (count == 2)
            all[set] = (set & 1U) != 0
                           ? detail::quadrilateral(static_cast<unsigned>(std::countr_zero(set & 14U)), true)
                           : detail::quadrilateral(static_cast<unsigned>(std::countr_zero(other & 14U)), false);
    }
    return all;
}();

// The negative ones of a tetrahedron's corners, of those of the cube.
[[nodiscard]] constexpr unsigned negative_of(const Tetrahedron& tetrahedron, unsigned negative) noexcept {
    unsigned set = 0;
    for (unsigned i = 0; i < 4; ++i) set |= (negative >> tetrahedron.corner[i] & 1U) << i;
    return set;
}

} // namespace hrbfnpr::curves
