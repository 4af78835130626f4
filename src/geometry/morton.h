// SPDX-License-Identifier: MIT
// Numbers of cells along a space-filling curve (Morton 1966): the bits of three coordinates, interleaved. A cell of
// twice the side has the code of the cells in it without their lowest three bits.
#pragma once

#include <array>
#include <cstdint>

namespace hrbfnpr::geometry {

inline constexpr int morton_bits = 21; // per coordinate

// Inserts two zeros between each two of the lowest 21 bits.
[[nodiscard]] constexpr std::uint64_t morton_spread(std::uint64_t x) noexcept {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
}

// The inverse of morton_spread.
[[nodiscard]] constexpr std::uint64_t morton_gather(std::uint64_t x) noexcept {
    x &= 0x1249249249249249;
    x = (x | x >> 2) & 0x10c30c30c30c30c3;
    x = (x | x >> 4) & 0x100f00f00f00f00f;
    x = (x | x >> 8) & 0x1f0000ff0000ff;
    x = (x | x >> 16) & 0x1f00000000ffff;
    return (x | x >> 32) & 0x1fffff;
}

// Returns the Morton code. The coordinates must be in [0, 2^21).
[[nodiscard]] constexpr std::uint64_t morton_code(const std::array<std::int64_t, 3>& cell) noexcept {
    return morton_spread(static_cast<std::uint64_t>(cell[0])) |
           morton_spread(static_cast<std::uint64_t>(cell[1])) << 1U |
           morton_spread(static_cast<std::uint64_t>(cell[2])) << 2U;
}

[[nodiscard]] constexpr std::array<std::int64_t, 3> morton_cell(std::uint64_t code) noexcept {
    return {static_cast<std::int64_t>(morton_gather(code)), static_cast<std::int64_t>(morton_gather(code >> 1U)),
            static_cast<std::int64_t>(morton_gather(code >> 2U))};
}

} // namespace hrbfnpr::geometry
