// SPDX-License-Identifier: MIT
// A uniform grid of cells.
#pragma once

#include "geometry/vec.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace hrbfnpr::geometry {

// Truncates a number to an integer in [0, last]. NaN becomes 0.
[[nodiscard]] inline std::int64_t truncate_to(double number, std::int64_t last) noexcept {
    const auto most = static_cast<double>(last);
    return static_cast<std::int64_t>(number > 0.0 ? (number < most ? number : most) : 0.0);
}

// Cell (i, j, k) is origin + side * [i, i + 1] x [j, j + 1] x [k, k + 1], each number in [0, most).
struct CellGrid {
    static constexpr int bits = 21;
    static constexpr std::int64_t most = std::int64_t{1} << bits;

    glm::dvec3 origin{0.0};
    double side = 1.0;

    using Cell = std::array<std::int64_t, 3>;

    [[nodiscard]] Cell cell_of(const glm::dvec3& p) const noexcept {
        const glm::dvec3 at = (p - origin) / side;
        return {truncate_to(at.x, most - 1), truncate_to(at.y, most - 1), truncate_to(at.z, most - 1)};
    }
    [[nodiscard]] glm::dvec3 corner(const Cell& cell) const noexcept {
        return origin + side * glm::dvec3(static_cast<double>(cell[0]), static_cast<double>(cell[1]),
                                          static_cast<double>(cell[2]));
    }
    [[nodiscard]] glm::dvec3 centre(const Cell& cell) const noexcept { return corner(cell) + 0.5 * side; }
    [[nodiscard]] static bool inside(const Cell& cell) noexcept {
        return std::all_of(cell.begin(), cell.end(), [](std::int64_t number) { return number >= 0 && number < most; });
    }
    [[nodiscard]] static std::uint64_t pack(const Cell& cell) noexcept {
        return static_cast<std::uint64_t>(cell[0]) | static_cast<std::uint64_t>(cell[1]) << bits |
               static_cast<std::uint64_t>(cell[2]) << (2 * bits);
    }
    [[nodiscard]] static Cell unpack(std::uint64_t packed) noexcept {
        constexpr auto mask = static_cast<std::uint64_t>(most - 1);
        return {static_cast<std::int64_t>(packed & mask), static_cast<std::int64_t>((packed >> bits) & mask),
                static_cast<std::int64_t>((packed >> (2 * bits)) & mask)};
    }
};

// The finaliser of splitmix64: every bit of a cell's packed number affects every bit of the hash.
[[nodiscard]] inline std::uint64_t hash_bits(std::uint64_t bits) noexcept {
    bits = (bits ^ (bits >> 30U)) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ (bits >> 27U)) * 0x94D049BB133111EBU;
    return bits ^ (bits >> 31U);
}

} // namespace hrbfnpr::geometry
