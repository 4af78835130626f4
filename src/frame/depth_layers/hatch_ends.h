// SPDX-License-Identifier: MIT
// Which strokes of hatching end at creases.
#pragma once

#include "frame/depth_layers/hatch_marks.h"

namespace hrbfnpr::frame {

// Of the run's stroke at hand the ends that are drawn: where it lies, and where creases do.  Marks of a pose are not
// where they are.
void find_crease_ends(const ItemView& item, const Run& run, HatchStroke& stroke) noexcept;

} // namespace hrbfnpr::frame
