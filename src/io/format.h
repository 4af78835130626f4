// SPDX-License-Identifier: MIT
// Defines the frame of model and point-set files (docs/file-format.md):
//
//   header     magic, kind, version, byte order, reserved, payload length, CRC-32 of the header
//   payload    sections {tag, scalar, count, elements}
//   trailer    CRC-32 of the payload
//
// Files are little-endian on every machine.
#pragma once

#include "base/bits.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace hrbfnpr::io {

// The first bytes of a file. As in PNG, the top bit of the first byte detects 7-bit transfers, the line ends detect
// transfers in text mode, and the byte 1A ends a listing of the file under DOS.
inline constexpr std::array<std::uint8_t, 8> magic{0x89, 'H', 'R', 'B', 0x0D, 0x0A, 0x1A, 0x0A};
// The newest format version of each kind of file.
inline constexpr std::uint32_t model_version = 2;
// The format version of models that are a single fit. It is older than model_version, so that older versions of the
// library can read these models.
inline constexpr std::uint32_t fit_version = 1;
// The newest format version of point sets. Only sets with fields need it.
inline constexpr std::uint32_t point_set_version = 4;
// The format version of sets without fields. Older versions, from before the first release, cannot be read.
inline constexpr std::uint32_t fieldless_version = 3;
inline constexpr std::uint32_t byte_order_mark = 0x01020304U;
inline constexpr std::size_t header_size = 40;
inline constexpr std::size_t section_header_size = 16;

// Returns a section tag: four letters that can be read in a hex dump.
[[nodiscard]] constexpr std::uint32_t tag(const char (&letters)[5]) noexcept {
    std::uint32_t number = 0;
    for (unsigned i = 0; i < 4; ++i)
        number |= static_cast<std::uint32_t>(static_cast<unsigned char>(letters[i])) << (8U * i);
    return number;
}

inline constexpr std::uint32_t kind_model = tag("MODL");
inline constexpr std::uint32_t kind_point_set = tag("PSET");

// The types that the elements of a section can have.
enum class ElementType : std::uint32_t { float32 = 1, float64 = 2, uint8 = 3, uint32 = 4, int64 = 5 };

template <class T>
[[nodiscard]] constexpr ElementType element_type() noexcept {
    if constexpr (std::is_same_v<T, float>)
        return ElementType::float32;
    else if constexpr (std::is_same_v<T, double>)
        return ElementType::float64;
    else if constexpr (std::is_same_v<T, std::uint8_t>)
        return ElementType::uint8;
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return ElementType::uint32;
    else {
        static_assert(std::is_same_v<T, std::int64_t>);
        return ElementType::int64;
    }
}

namespace detail {
template <std::size_t size>
using Bits = std::conditional_t<
    size == 1, std::uint8_t,
    std::conditional_t<size == 2, std::uint16_t, std::conditional_t<size == 4, std::uint32_t, std::uint64_t>>>;
} // namespace detail

// These functions work for every byte order. On little-endian machines they compile to plain copies.
template <class T>
constexpr void store(std::uint8_t* to, T value) noexcept {
    const auto bits = base::bit_cast<detail::Bits<sizeof(T)>>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i) to[i] = static_cast<std::uint8_t>(bits >> (8 * i));
}

template <class T>
[[nodiscard]] constexpr T fetch(const std::uint8_t* from) noexcept {
    detail::Bits<sizeof(T)> bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
        bits = static_cast<detail::Bits<sizeof(T)>>(bits | (detail::Bits<sizeof(T)>{from[i]} << (8 * i)));
    return base::bit_cast<T>(bits);
}

} // namespace hrbfnpr::io
