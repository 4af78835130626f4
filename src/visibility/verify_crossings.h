// SPDX-License-Identifier: MIT
// Crossings of curves that come near each other in space, asked of the curves themselves: beside a cusp the cubics may
// cross where the curves do not.
#pragma once

#include "visibility/crossings.h"

namespace hrbfnpr::visibility {

// Takes those out that the curves do not have.  Returns how many.
std::int64_t verify_crossings(const base::Runtime& runtime, std::span<const Subject> subjects, const ImageLines& lines,
                              base::Array<Crossing>& crossings, const base::Progress& progress);

} // namespace hrbfnpr::visibility
