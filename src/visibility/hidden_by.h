// SPDX-License-Identifier: MIT
// Which item hides each part of a line: that of the nearest surface before it.
#pragma once

#include "visibility/invisibility.h"

namespace hrbfnpr::visibility {

// Sets Interval::hidden_by, by a ray from the middle of each part that is hidden; with one occluder without.
void find_hidden_by(const base::Runtime& runtime, std::span<const Subject> subjects,
                    std::span<const Occluder> occluders, Invisibility& found, const base::Progress& progress);

} // namespace hrbfnpr::visibility
