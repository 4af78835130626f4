// SPDX-License-Identifier: MIT
// What the versions of point-set files share.
#pragma once

#include "io/decoder.h"
#include "marks/point_set.h"

#include <array>

namespace hrbfnpr::io {

inline constexpr std::uint32_t tag_rank = tag("RANK");
inline constexpr std::uint32_t tag_position = tag("POSI");
inline constexpr std::uint32_t tag_normal = tag("NORM");
inline constexpr std::uint32_t tag_direction = tag("DIRE");
inline constexpr std::uint32_t tag_curvature = tag("CURV");
inline constexpr std::uint32_t tag_level = tag("LEVL");
inline constexpr std::uint32_t tag_stroke = tag("STRK");
inline constexpr std::uint32_t tag_width = tag("WIDT");

inline constexpr std::size_t level_numbers = 6;

[[nodiscard]] inline marks::LevelReport level_of(const std::int64_t* n) noexcept {
    return {n[0], n[1], n[2], n[3], n[4], n[5]};
}

// RANK to STRK.
void decode_marks(Decoder& decoder, marks::Layer& layer);
void decode_width(Decoder& decoder, marks::Layer& layer);

// The three groups of version 1; those with marks become layers.
void decode_groups(Decoder& decoder, marks::PointSet& set);

} // namespace hrbfnpr::io
