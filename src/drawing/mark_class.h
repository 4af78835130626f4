// SPDX-License-Identifier: MIT
// What a mark is for the camera.                                                 [NPAR 6]
#pragma once

#include <cstdint>

namespace hrbfnpr::drawing {

// Same numbers as HRBFNPR_CLASS_...
enum class MarkClass : std::uint8_t { none = 0, front = 1, back = 2, silhouette = 3 };

} // namespace hrbfnpr::drawing
