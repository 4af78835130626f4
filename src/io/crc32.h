// SPDX-License-Identifier: MIT
// Computes the CRC-32 of zlib, PNG and Ethernet (reflected polynomial 0xEDB88320), so that other tools can check the
// files. It detects every burst error of up to 32 bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hrbfnpr::io {

namespace detail {

[[nodiscard]] constexpr std::array<std::uint32_t, 256> make_crc_table() noexcept {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t remainder = byte;
        for (int bit = 0; bit < 8; ++bit)
            remainder = (remainder & 1U) != 0 ? (remainder >> 1U) ^ 0xEDB88320U : remainder >> 1U;
        table[byte] = remainder;
    }
    return table;
}

inline constexpr std::array<std::uint32_t, 256> crc_table = make_crc_table();

} // namespace detail

class Crc32 {
public:
    constexpr void add(std::span<const std::uint8_t> bytes) noexcept {
        for (const std::uint8_t byte : bytes) state_ = (state_ >> 8U) ^ detail::crc_table[(state_ ^ byte) & 0xFFU];
    }
    [[nodiscard]] constexpr std::uint32_t value() const noexcept { return ~state_; }

private:
    std::uint32_t state_ = 0xFFFFFFFFU;
};

} // namespace hrbfnpr::io
