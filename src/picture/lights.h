// SPDX-License-Identifier: MIT
// Lights of a style as text, for the path "style.light" of a change: X,Y,Z for one light, or a list of lights with ';'
// between them, each written X,Y,Z:intensity=N,shadow=N,softness=N,space=NAME,place. What stands after ':' may be left
// out, in any order.
#pragma once

#include "picture/memory.h"

#include <hrbfnpr.h>

#include <optional>
#include <string_view>

namespace hrbfnpr::picture {

// Tells whether a text is a list of lights, and not only a direction.
[[nodiscard]] bool is_list_of_lights(std::string_view text) noexcept;

// Reads a list of lights. The fields that a text leaves out come from `first` for the first light, and from `others`
// for the others. Returns nullopt for a text that is no such list.
[[nodiscard]] std::optional<Vector<hrbfnpr_light>> read_lights(std::string_view text, const hrbfnpr_light& first,
                                                               const hrbfnpr_light& others, Pool& pool);

// The texts that read_lights() accepts, for messages.
inline constexpr const char* wanted_lights =
    "lights with ';' between them: X,Y,Z:intensity=N,shadow=N,softness=N,space=NAME,place";

} // namespace hrbfnpr::picture
