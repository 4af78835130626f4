// SPDX-License-Identifier: MIT
// What reading and writing settings have in common.
#pragma once

#include "picture/memory.h"

#include <cstdint>
#include <string_view>
#include <utility>

namespace hrbfnpr::picture {

inline constexpr std::string_view settings_magic = "hrbfnpr-settings";
inline constexpr std::uint64_t settings_version = 1;
inline constexpr std::int32_t largest_settings_side = 32768; // pixels, of a picture

inline constexpr std::string_view dab_map_names[] = {"tone", "density", "direction"}; // by number: HRBFNPR_DAB_...

// Names or paths of fields, and their values as changes have them.
using FieldTexts = Vector<std::pair<String, String>>;

// Flags say what a struct's arrays are, and are chosen.
[[nodiscard]] constexpr bool is_in_settings(std::string_view field) noexcept { return field != "flags"; }

} // namespace hrbfnpr::picture
