// SPDX-License-Identifier: MIT
// Declares names and limits that both reading and writing settings use.
#pragma once

#include "picture/memory.h"

#include <cstdint>
#include <string_view>
#include <utility>

namespace hrbfnpr::picture {

inline constexpr std::string_view settings_magic = "hrbfnpr-settings";
inline constexpr std::uint64_t settings_version = 1;
// The largest width and height of a picture in settings, in pixels.
inline constexpr std::int32_t largest_settings_side = 32768;

// The names of the painted maps, indexed by HRBFNPR_DAB_*.
inline constexpr std::string_view dab_map_names[] = {"tone", "density", "direction"};

// Fields and their values. A field is given by its name or path, and its value is written as text, as in a list of
// changes.
using FieldTexts = Vector<std::pair<String, String>>;

// Returns whether settings store a field. They omit flags that describe the arrays of a struct, because these are set
// automatically.
[[nodiscard]] constexpr bool is_in_settings(std::string_view field) noexcept { return field != "flags"; }

} // namespace hrbfnpr::picture
