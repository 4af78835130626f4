// SPDX-License-Identifier: MIT
// Crossings of a curve with itself that are near in space, too, asked of the curve itself: beside a cusp the cubics may
// cross where the curve does not.
#pragma once

#include "visibility/crossings.h"

namespace hrbfnpr::visibility {

// Takes those out that the curves do not have.  Returns how many.
std::int64_t verify_crossings(const base::Runtime& runtime, std::span<const Subject> subjects, const ImageLines& lines,
                              base::Array<Crossing>& crossings, const base::Progress& progress);

} // namespace hrbfnpr::visibility
